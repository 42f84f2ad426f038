// Every construction of automata on infinite words against every other: what one has of φ and another of ¬φ must have
// no word in common, and each says of random lassos what the definition says. As ltlcross does, with our own products.
//
// A pair is a formula and a construction. WAYMARK_PAIRS sets how many, WAYMARK_SEED where the drawing begins.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "libautomata/deterministic/conversions.hpp"
#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/hoa/exchange.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/monitor/good_prefixes.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/random.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

const ltl::Limits limits{.states = 100'000};

const Automaton& automaton_of(const Translated& made) { return made.automaton; }
const Automaton& automaton_of(const TranslatedForMdps& made) { return made.automaton.automaton(); }

template <class Made>
Automaton made(std::variant<Made, Exhausted> (*translate)(Formula, const ltl::Limits&), Formula f) {
  const auto found = translate(f, limits);
  return automaton_of(std::get<Made>(found));
}

Automaton tgba(Formula f) { return made(ltl_to_tgba, f); }
Automaton buchi(Formula f) { return made(ltl_to_buchi, f); }
Automaton parity(Formula f) { return made(ltl_to_parity, f); }
Automaton rabin(Formula f) { return made(ltl_to_rabin, f); }
Automaton generic(Formula f) { return made(ltl_to_generic, f); }
Automaton ldba(Formula f) { return made(ltl_to_ldba, f); }
Automaton determinised(Formula f) {
  Budget unlimited;
  return to_parity(buchi(f), unlimited).automaton();
}
Automaton complemented(Formula f) { return complement(*Deterministic::checked(parity(ltl::negate(f)))).automaton(); }
Automaton limit_deterministic_of_parity(Formula f) {
  Budget unlimited;
  return limit_deterministic(to_parity(tgba(f), unlimited)).automaton();
}
// The file names its own propositions; together with an automaton of all words it has those of the formula again.
Automaton written_and_read(Formula f) {
  Budget unlimited;
  return intersection(tgba(f.arena().constant(true)), read_omega_hoa(write_hoa(generic(f))), unlimited);
}

// What `waymark automaton --to` makes of an automaton in a file. The file reads a proposition first that its language
// does not ask for, so that what is made of it reads fewer.
template <class Convert>
Automaton converted(Formula f, const Convert& convert) {
  Budget unlimited;
  const Automaton two_copies = read_omega_hoa(
      "HOA: v1 States: 3 Start: 0 AP: 1 \"unasked\" Acceptance: 0 t --BODY-- State: 0 [0] 1 [!0] 2 State: 1 [t] 1 "
      "State: 2 [t] 2 --END--");
  const Automaton file = read_omega_hoa(write_hoa(intersection(two_copies, generic(f), unlimited)));
  return intersection(tgba(f.arena().constant(true)), convert(file, unlimited), unlimited);
}
Automaton made_tgba(Formula f) { return converted(f, to_tgba); }
Automaton made_buchi(Formula f) {
  return converted(f, [](const Automaton& a, Budget& budget) { return *make_state_based(to_tgba(a, budget), budget); });
}
Automaton made_parity(Formula f) {
  return converted(f, [](const Automaton& a, Budget& budget) { return to_parity(a, budget).automaton(); });
}
Automaton made_rabin(Formula f) { return converted(f, to_rabin); }
Automaton made_generic(Formula f) { return converted(f, to_generic); }
Automaton made_ldba(Formula f) {
  return converted(
      f, [](const Automaton& a, Budget& budget) { return limit_deterministic(to_parity(a, budget)).automaton(); });
}

struct Construction {
  const char* name;
  Automaton (*run)(Formula);
};
constexpr std::array constructions{Construction{"tgba", tgba},
                                   Construction{"buchi", buchi},
                                   Construction{"parity", parity},
                                   Construction{"rabin", rabin},
                                   Construction{"generic", generic},
                                   Construction{"ldba", ldba},
                                   Construction{"parity of the Büchi automaton", determinised},
                                   Construction{"complement of the parity automaton of the negation", complemented},
                                   Construction{"ldba of the parity automaton", limit_deterministic_of_parity},
                                   Construction{"generic, written and read", written_and_read},
                                   Construction{"automaton --to tgba", made_tgba},
                                   Construction{"automaton --to buchi", made_buchi},
                                   Construction{"automaton --to parity", made_parity},
                                   Construction{"automaton --to rabin", made_rabin},
                                   Construction{"automaton --to generic", made_generic},
                                   Construction{"automaton --to ldba", made_ldba}};

std::vector<Automaton> all_of(Formula f) {
  std::vector<Automaton> out;
  for (const Construction& construction : constructions) out.push_back(construction.run(f));
  return out;
}

::testing::AssertionResult no_word_in_common(const std::vector<Automaton>& yes, const std::vector<Automaton>& no) {
  for (std::size_t i = 0; i < yes.size(); ++i)
    for (std::size_t j = 0; j < no.size(); ++j) {
      Budget unlimited;
      if (!is_empty(intersection(yes[i], no[j], unlimited).transitions()))
        return ::testing::AssertionFailure()
               << constructions[i].name << ", and of the negation " << constructions[j].name << ", accept one word";
    }
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult reads_as_defined(const std::vector<Automaton>& all, Formula f, const ltl::Lasso& word) {
  const bool truth = ltl::holds(word, f);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (accepts(all[i], word) != truth)
      return ::testing::AssertionFailure()
             << constructions[i].name << (truth ? " rejects " : " accepts ") << testing::show(f, word);
  return ::testing::AssertionSuccess();
}

void check(Formula f, ltl::Random& random, std::size_t atoms, int words) {
  const Formula negated = ltl::negate(f);
  const std::vector<Automaton> yes = all_of(f), no = all_of(negated);
  ASSERT_TRUE(no_word_in_common(yes, no)) << testing::show(f);
  for (int i = 0; i < words; ++i) {
    const ltl::Lasso word =
        ltl::random_lasso(random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = atoms});
    ASSERT_TRUE(reads_as_defined(yes, f, word));
    ASSERT_TRUE(reads_as_defined(no, negated, word));
  }
}

std::uint64_t given(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

TEST(Constructions, AgreeOnAllSmallFormulas) {
  ltl::Arena arena;
  ltl::Random random(1);
  testing::for_each_formula(arena, {.size = 3, .atoms = 2}, [&](Formula f) { check(f, random, 2, 4); });
}

TEST(Constructions, AgreeOnRandomFormulas) {
  const std::uint64_t seed = given("WAYMARK_SEED", 20261125);
  const std::uint64_t pairs = given("WAYMARK_PAIRS", testing::sanitized ? 200 : 2'000);
  const std::uint64_t each = 2 * constructions.size();  // of φ and of ¬φ
  for (std::uint64_t i = 0; i * each < pairs; ++i) {
    ltl::Random random(seed + i);
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 5 + random.below(13), .atoms = 3});
    check(f, random, 3, 8);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << seed << ", formula " << i;
  }
}

// Every word accepted begins with a good prefix, or one is shown that does not. A run of the DFA along a lasso is
// periodic after as many rounds as it has states.
::testing::AssertionResult settles(Formula f, const std::vector<ltl::Lasso>& words) {
  Budget unlimited;
  const auto made = good_prefixes(generic(f), unlimited);
  if (const auto* none = std::get_if<UnsettledWord>(&made))
    return ltl::holds(none->word, f) ? ::testing::AssertionSuccess()
                                     : ::testing::AssertionFailure() << testing::show(f, none->word);
  const Dfa& dfa = std::get<Dfa>(made);
  for (const ltl::Lasso& word : words) {
    StateId q = dfa.initial();
    bool settled = false;
    std::size_t at = 0;
    for (std::size_t i = 0; i < word.size() * dfa.states(); ++i, at = word.successor(at)) {
      q = dfa.next(q, word[at]);
      settled = settled || dfa.is_accepting(q);
    }
    if (settled != ltl::holds(word, f)) return ::testing::AssertionFailure() << testing::show(f, word);
  }
  return ::testing::AssertionSuccess();
}

TEST(Constructions, DfasOfInfiniteWordsSettleThem) {
  ltl::Arena arena;
  const std::vector<ltl::Lasso> words = testing::all_lassos({.length = 3, .atoms = 2});
  std::size_t settled = 0, all = 0;
  testing::for_each_formula(arena, {.size = 3, .atoms = 2}, [&](Formula f) {
    ASSERT_TRUE(settles(f, words));
    Budget unlimited;
    settled += std::holds_alternative<Dfa>(good_prefixes(generic(f), unlimited)) ? 1 : 0;
    ++all;
  });
  EXPECT_GT(settled, 0U);
  EXPECT_LT(settled, all);
}

}  // namespace
}  // namespace waymark::automata
