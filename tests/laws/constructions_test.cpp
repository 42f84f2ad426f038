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

#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
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
                                   Construction{"generic, written and read", written_and_read}};

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

}  // namespace
}  // namespace waymark::automata
