#include "libautomata/deterministic/parity_game.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

using Player = ParityGame::Player;
using Set = std::set<std::uint32_t>;

// A game read from its text, by the grammar of the format.
ParityGame read_pgsolver(const std::string& text) {
  std::istringstream in(text);
  std::string word, line;
  std::size_t last = 0;
  in >> word >> last;
  EXPECT_EQ(word, "parity");
  std::getline(in, line);
  ParityGame out;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    std::size_t number = 0;
    unsigned owner = 0;
    ParityGame::Vertex vertex{};
    row >> number >> vertex.priority >> owner >> word;
    EXPECT_EQ(number, out.vertices.size());
    EXPECT_EQ(line.back(), ';');
    vertex.owner = static_cast<Player>(owner);
    std::istringstream successors(word);
    for (std::string one; std::getline(successors, one, ',');)
      vertex.successors.push_back(static_cast<std::uint32_t>(std::stoul(one)));
    out.vertices.push_back(vertex);
  }
  EXPECT_EQ(out.vertices.size(), last + 1);
  return out;
}

// Within `area`: from where `player` forces a visit to `target`.
Set attractor(const ParityGame& game, const Set& area, Set target, Player player) {
  for (bool grew = true; grew;) {
    grew = false;
    for (std::uint32_t v : area) {
      if (target.contains(v)) continue;
      bool any = false, all = true;
      for (std::uint32_t w : game.vertices[v].successors) {
        if (!area.contains(w)) continue;
        (target.contains(w) ? any : all) = target.contains(w);
      }
      if (game.vertices[v].owner == player ? any : all && any) grew = target.insert(v).second;
    }
  }
  return target;
}

Set without(const Set& all, const Set& taken) {
  Set out;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(), std::inserter(out, out.end()));
  return out;
}

// Zielonka's algorithm: where the system wins.
Set won_by_system(const ParityGame& game, const Set& area) {
  if (area.empty()) return {};
  std::uint32_t top = 0;
  for (std::uint32_t v : area) top = std::max(top, game.vertices[v].priority);
  const Player better = top % 2 == 0 ? Player::System : Player::Environment;
  const Player worse = better == Player::System ? Player::Environment : Player::System;
  Set highest;
  for (std::uint32_t v : area)
    if (game.vertices[v].priority == top) highest.insert(v);
  const Set rest = without(area, attractor(game, area, highest, better));
  const Set system = won_by_system(game, rest);
  const Set lost = worse == Player::System ? system : without(rest, system);
  if (lost.empty()) return better == Player::System ? area : Set{};
  const Set forced = attractor(game, area, lost, worse);
  Set inner = won_by_system(game, without(area, forced));
  if (worse == Player::System) inner.insert(forced.begin(), forced.end());
  return inner;
}

bool system_wins(ltl::Formula f, const std::vector<ltl::Proposition>& outputs) {
  Budget budget;
  const ParityGame game = read_pgsolver(write_pgsolver(parity_game(ltl_to_dpa(f), outputs, budget)));
  Set all;
  for (std::uint32_t v = 0; v < game.vertices.size(); ++v) {
    all.insert(v);
    EXPECT_FALSE(game.vertices[v].successors.empty());
  }
  return won_by_system(game, all).contains(0);
}

TEST(ParityGame, IsWonWhereTheFormulaIsRealisable) {
  struct Row {
    const char* formula;
    bool realisable;
  };
  const Row table[] = {
      {"G (i <-> o)", true},
      {"G (o <-> X i)", false},
      {"G (i -> F o)", true},
      {"G F i <-> G F o", true},
      {"F i", false},
      {"F o", true},
      {"G F (o <-> X i)", false},
      {"false", false},
      {"true", true},
      {"G (X o <-> i)", true},
      {"o U i", false},
      {"G (o -> Y i) & G (i -> X o)", true},
      {"G (o <-> O i)", true},
      {"G F i -> G F (i & o)", true},
      {"F G i | G F !i", true},
  };
  for (const Row& row : table) {
    ltl::Arena arena{ltl::Vocabulary({"i", "o"})};
    EXPECT_EQ(system_wins(ltl::parse(row.formula, arena), {{1}}), row.realisable) << row.formula;
  }
}

// Without inputs the system wins exactly when some word satisfies, without outputs when every word does.
TEST(ParityGame, OfOnePlayerIsSatisfiabilityOrValidity) {
  constexpr std::uint64_t seed = 4;
  ltl::Random random(seed);
  const auto words = testing::all_lassos({.length = 4, .atoms = 2});
  for (int i = 0; i < 200; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 4 + random.below(4), .atoms = 2});
    const auto holds = [&](const ltl::Lasso& word) { return ltl::holds(word, f); };
    ASSERT_EQ(system_wins(f, {{0}, {1}}), std::any_of(words.begin(), words.end(), holds)) << testing::show(f);
    ASSERT_EQ(system_wins(f, {}), std::all_of(words.begin(), words.end(), holds)) << testing::show(f);
  }
}

// A Mealy machine with one state: outputs are a function of the inputs alone. Where one such machine satisfies φ on all
// small lassos of inputs, the game is won.
TEST(ParityGame, IsWonWhereAMachineOfOneStateSatisfies) {
  constexpr std::uint64_t seed = 9;
  ltl::Random random(seed);
  const auto inputs = testing::all_lassos({.length = 4, .atoms = 1});
  for (int i = 0; i < 300; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 4 + random.below(4), .atoms = 2});
    for (unsigned machine = 0; machine < 4; ++machine) {
      const bool good = std::all_of(inputs.begin(), inputs.end(), [&](const ltl::Lasso& input) {
        std::vector<ltl::Letter> prefix, cycle;
        for (std::size_t k = 0; k < input.size(); ++k) {
          ltl::Letter letter = input[k];
          if ((machine >> (letter.contains({0}) ? 1U : 0U) & 1U) != 0) letter.insert({1});
          (k < input.loop_start() ? prefix : cycle).push_back(letter);
        }
        return ltl::holds(ltl::Lasso(prefix, cycle), f);
      });
      if (good) {
        ASSERT_TRUE(system_wins(f, {{1}})) << testing::show(f);
      }
    }
  }
}

}  // namespace
}  // namespace waymark::automata
