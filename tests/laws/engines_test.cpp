// Every engine that says whether a finite word satisfies a formula, against the definition: on all small pairs, then
// on seeded random larger ones. A disagreement is printed ready to paste.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <ostream>
#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/finite/run.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Trace;
using testing::show;

enum class Engine : std::uint8_t { Definition, Progression, TraceCheck, Dfa, Run, HoaRoundTrip };
constexpr std::array engines{Engine::Definition, Engine::Progression, Engine::TraceCheck,
                             Engine::Dfa,        Engine::Run,         Engine::HoaRoundTrip};

std::ostream& operator<<(std::ostream& out, Engine engine) {
  switch (engine) {
    case Engine::Definition: return out << "definition";
    case Engine::Progression: return out << "progression";
    case Engine::TraceCheck: return out << "trace check";
    case Engine::Dfa: return out << "DFA";
    case Engine::Run: return out << "run with trap detection";
    case Engine::HoaRoundTrip: return out << "HOA round trip";
  }
  return out;
}

// The file has its own vocabulary: letters are translated by name.
bool accepts_by_name(const Dfa& dfa, const ltl::Vocabulary& names, const Trace& word) {
  std::vector<ltl::Letter> letters;
  for (const ltl::Letter& letter : word) {
    letters.emplace_back();
    for (ltl::Proposition p : letter.members())
      if (const auto q = dfa.vocabulary().find(names.name(p))) letters.back().insert(*q);
  }
  return accepts(dfa, Trace(letters));
}

// The run, stopped early where there is no hope.
bool accepts_by_run(const Dfa& dfa, const Trace& word) {
  const Run all = run(dfa, word);
  EXPECT_EQ(all.states.size(), word.size() + 1);
  EXPECT_FALSE(all.trapped && all.accepted) << "a trap accepts";
  return all.accepted;
}

class Engines {  // one formula, prepared for every engine
 public:
  explicit Engines(Formula f)
      : formula_(f), check_(f), dfa_(ltlf_to_dfa(f)), file_(read_hoa(write_hoa(dfa_, {.name = ltl::print(f)}))) {}

  bool accepts(Engine engine, const Trace& word) {
    switch (engine) {
      case Engine::Definition: return ltl::holds(word, formula_);
      case Engine::Progression: {
        Formula rest = formula_;
        for (const ltl::Letter& letter : word) rest = ltl::progress(rest, letter);
        return ltl::accepts_empty(rest);
      }
      case Engine::TraceCheck: return check_(ltl::Columns(word, formula_.arena().vocabulary().size()));
      case Engine::Dfa: return automata::accepts(dfa_, word);
      case Engine::Run: return accepts_by_run(dfa_, word);
      case Engine::HoaRoundTrip: return accepts_by_name(file_, formula_.arena().vocabulary(), word);
    }
    return false;
  }
  const Dfa& dfa() const { return dfa_; }
  const Dfa& file() const { return file_; }

 private:
  Formula formula_;
  ltl::TraceCheck check_;
  Dfa dfa_, file_;
};

::testing::AssertionResult all_agree(Engines& engines_of_f, Formula f, const Trace& word) {
  const bool truth = ltl::holds(word, f);
  for (Engine engine : engines)
    if (engines_of_f.accepts(engine, word) != truth)
      return ::testing::AssertionFailure()
             << engine << (truth ? " rejects, " : " accepts, ") << "the definition does not: " << show(f, word);
  return ::testing::AssertionSuccess();
}

TEST(Engines, AgreeOnAllSmallFormulasAndWords) {
  ltl::Arena arena;
  const std::vector<Trace> words = testing::all_traces({.length = 3, .atoms = 2});
  std::size_t formulas = 0;
  testing::for_each_formula(arena, {.size = testing::sanitized ? 4 : 5, .atoms = 2}, [&](Formula f) {
    Engines all(f);
    for (const Trace& word : words) ASSERT_TRUE(all_agree(all, f, word));
    ++formulas;
  });
  EXPECT_GT(formulas, testing::sanitized ? 100U : 1000U);
}

TEST(Engines, AgreeOnLongerFormulasOfOneProposition) {
  ltl::Arena arena;
  const std::vector<Trace> words = testing::all_traces({.length = 6, .atoms = 1});
  testing::for_each_formula(arena, {.size = testing::sanitized ? 4 : 5, .atoms = 1}, [&](Formula f) {
    Engines all(f);
    for (const Trace& word : words) ASSERT_TRUE(all_agree(all, f, word));
  });
}

TEST(Engines, AgreeOnRandomFormulasAndWords) {
  constexpr std::uint64_t seed = 20260701;
  ltl::Random random(seed);
  for (int i = 0; i < testing::scaled(1500); ++i) {
    ltl::Arena arena(testing::letters_vocabulary(4));
    const Formula f = ltl::random_formula(random, arena, {.size = 8 + random.below(18), .atoms = 4});
    Engines all(f);
    for (int j = 0; j < 25; ++j) {
      const Trace word = ltl::random_trace(random, {.length = 1 + random.below(12), .atoms = 4});
      ASSERT_TRUE(all_agree(all, f, word)) << "seed " << seed << ", formula " << i;
    }
  }
}

// Minimal automata are canonical, so what means the same must give the same bytes.
TEST(Engines, EquivalentFormulasGiveTheSameBytes) {
  constexpr std::uint64_t seed = 77;
  ltl::Random random(seed);
  for (int i = 0; i < 600; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 6 + random.below(15), .atoms = 3});
    const std::string bytes = write_hoa(ltlf_to_dfa(f));
    for (Formula g : {ltl::simplify(f, ltl::Semantics::Finite), ltl::nnf(f)})
      ASSERT_EQ(write_hoa(ltlf_to_dfa(g)), bytes) << show(f) << "\nrewritten to " << ltl::print(g) << "\nseed " << seed;
  }
}

TEST(Engines, HoaRoundTripKeepsEveryStateAndEdge) {
  constexpr std::uint64_t seed = 5;
  ltl::Random random(seed);
  for (int i = 0; i < 400; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(4));
    const Formula f = ltl::random_formula(random, arena, {.size = 20, .atoms = 4});
    const Engines all(f);
    ASSERT_EQ(write_hoa(all.file()), write_hoa(all.dfa())) << show(f);
    ASSERT_EQ(all.file().states(), all.dfa().states()) << show(f);
    ASSERT_FALSE(difference(all.dfa(), all.file()).has_value()) << show(f);
  }
}

// φ and ¬φ share no word and miss none; on φ ∧ ψ the translation and the product of translations are one language.
TEST(Engines, BooleanOperatorsAreProducts) {
  constexpr std::uint64_t seed = 6;
  ltl::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 12, .atoms = 3});
    const Formula g = ltl::random_formula(random, arena, {.size = 12, .atoms = 3});
    const Dfa af = ltlf_to_dfa(f), ag = ltlf_to_dfa(g), not_f = ltlf_to_dfa(ltl::negate(f));
    ASSERT_FALSE(shortest_word(product(af, not_f, [](bool p, bool q) { return p && q; }))) << show(f);
    const Dfa everything = ltlf_to_dfa(arena.constant(true));
    ASSERT_FALSE(difference(product(af, not_f, [](bool p, bool q) { return p || q; }), everything)) << show(f);
    const Dfa both = product(af, ag, [](bool p, bool q) { return p && q; });
    ASSERT_FALSE(difference(both, ltlf_to_dfa(ltl::conjunction(f, g)))) << show(f) << " and " << show(g);
  }
}

}  // namespace
}  // namespace waymark::automata
