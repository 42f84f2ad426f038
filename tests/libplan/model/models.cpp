#include "tests/libplan/model/models.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::plan::test {
namespace {

std::uint32_t draw(std::mt19937& random, std::uint32_t below) { return static_cast<std::uint32_t>(random() % below); }

ltl::Letter random_letter(std::mt19937& random) {
  ltl::Letter out;
  for (std::uint32_t p = 0; p < 2; ++p)
    if (draw(random, 3) == 0) out.insert(ltl::Proposition{p});
  return out;
}

std::string show(const Letters& letters, LetterId id) { return ltl::show(letters[id], letters.vocabulary()); }

std::string difference(const Mdp& a, const Mdp& b, std::uint32_t s, std::uint32_t k) {
  const std::string where = "choice " + std::to_string(k) + " of state " + std::to_string(s);
  if (a.cost(s, k) != b.cost(s, k)) return "cost of " + where;
  const auto left = a.outcomes(s, k), right = b.outcomes(s, k);
  if (left.size() != right.size()) return "number of outcomes of " + where;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i].target != right[i].target) return "targets of " + where;
    if (std::abs(left[i].probability - right[i].probability) > 1e-15) return "probabilities of " + where;
    if (show(a.letters(), left[i].letter) != show(b.letters(), right[i].letter)) return "letters of " + where;
  }
  return "";
}

}  // namespace

Mdp random_mdp(std::mt19937& random) {
  MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
  const std::uint32_t states = 1 + draw(random, 6);
  for (std::uint32_t s = 0; s < states; ++s) {
    builder.add_state();
    const std::uint32_t choices = draw(random, 4);
    for (std::uint32_t k = 0; k < choices; ++k) {
      builder.add_choice(draw(random, 2) == 0 ? "go" : "F", draw(random, 3) + 0.5);
      const std::uint32_t outcomes = 1 + draw(random, 3);
      for (std::uint32_t i = 0; i < outcomes; ++i)
        builder.add_outcome(draw(random, states), builder.letter(random_letter(random)), 1.0 / outcomes);
    }
  }
  const LetterId first = builder.letter(random_letter(random));
  return std::move(builder).build(draw(random, states), first);
}

GridWorld random_grid(std::mt19937& random) {
  GridWorld::Shape shape{1 + draw(random, 5), 1 + draw(random, 5), {}, {}};
  for (std::size_t d = 0; d < 4; ++d) {
    shape.motion[d] = draw(random, 3) == 0 ? SlipChances{} : SlipChances{0.5, 0.25, 0.125, 0.125};
    shape.cost[d] = 1 + draw(random, 2);
  }
  const std::vector<GridCell> palette{{},
                                      {.wall = true},
                                      {.one_way = Compass::East},
                                      {.one_way = Compass::North, .label = {ltl::Proposition{0}}},
                                      {.label = {ltl::Proposition{0}}},
                                      {.label = {ltl::Proposition{1}}}};
  std::vector<std::uint16_t> cells(std::size_t{shape.width} * shape.height);
  for (std::uint16_t& cell : cells) cell = static_cast<std::uint16_t>(draw(random, 2) == 0 ? 0 : draw(random, 6));
  const std::uint32_t start = draw(random, static_cast<std::uint32_t>(cells.size()));
  cells[start] = 0;
  return GridWorld(shape, ltl::Vocabulary({"a", "b"}), palette, cells, start);
}

std::string difference(const Mdp& a, const Mdp& b) {
  if (a.states() != b.states()) return "number of states";
  if (a.initial() != b.initial()) return "initial state";
  if (show(a.letters(), a.initial_letter()) != show(b.letters(), b.initial_letter())) return "first letter";
  for (std::uint32_t s = 0; s < a.states(); ++s) {
    if (a.choices(s) != b.choices(s)) return "number of choices of state " + std::to_string(s);
    for (std::uint32_t k = 0; k < a.choices(s); ++k)
      if (std::string found = difference(a, b, s, k); !found.empty()) return found;
  }
  return "";
}

}  // namespace waymark::plan::test
