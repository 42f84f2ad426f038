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
#include "tests/support/zielonka.hpp"

namespace waymark::automata {
namespace {

using Player = ParityGame::Player;
using test::won_by_system;

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

bool system_wins(ltl::Formula f, const std::vector<ltl::Proposition>& outputs) {
  Budget budget;
  const ParityGame game = read_pgsolver(write_pgsolver(parity_game(ltl_to_dpa(f), outputs, budget)));
  test::Vertices all;
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
