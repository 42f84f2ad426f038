// Determinisation of automata that no formula gave: random generalised Büchi automata over two letters, on all small
// lassos, and their language inside that of the result by emptiness. Nothing reduces what is looked at.
#include <gtest/gtest.h>

#include "libautomata/deterministic/determinize.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

const ltl::Vocabulary one_letter({"a"});

TEST(Determinize, KeepsTheLanguageOfRandomAutomata) {
  constexpr std::uint64_t seed = 81;
  ltl::Random random(seed);
  const auto words = testing::all_lassos({.length = 6, .atoms = 1});
  for (int i = 0; i < (testing::sanitized ? 40 : 600); ++i) {
    const RandomAutomaton options{.states = static_cast<std::uint32_t>(2 + i % 3),
                                  .atoms = 1,
                                  .sets = static_cast<std::uint32_t>(i % 3),
                                  .branches = static_cast<std::size_t>(2 + i % 2),
                                  .marked = i % 5 == 0 ? 0.6 : 0.25,
                                  .empty = 0.1,
                                  .generic = false};
    const Automaton from = random_automaton(random, one_letter, options);
    Budget budget;
    const Automaton made = as_automaton(determinize(from.transitions(), budget), one_letter, from.reads());
    const auto checked = Deterministic::checked(made);
    ASSERT_TRUE(checked) << write_hoa(from);
    ASSERT_TRUE(is_empty(intersection(from, complement(*checked).automaton(), budget).transitions()))
        << "seed " << seed << ", automaton " << i << '\n'
        << write_hoa(from);
    for (const ltl::Lasso& word : words)
      ASSERT_EQ(accepts(made, word), accepts(from, word)) << "seed " << seed << ", automaton " << i << '\n'
                                                          << write_hoa(from) << "on " << ltl::show(word, one_letter);
  }
}

}  // namespace
}  // namespace waymark::automata
