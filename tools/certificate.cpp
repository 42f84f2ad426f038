#include "tools/certificate.hpp"

#include <stdexcept>

#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/finite/run.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/omega/operations.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/print.hpp"

namespace waymark::tools {
namespace {

using automata::Automaton;
using automata::Dfa;

constexpr std::size_t determinization_steps = 400'000'000;  // some seconds

[[noreturn]] void wrong(ltl::Formula formula, const std::string& what, const std::string& word) {
  throw std::logic_error("the automaton of " + ltl::print(formula) + " is wrong: " + what + ' ' + word);
}

// Random words over the propositions of φ, read by the definition: what φ and ¬φ have wrong alike.
void try_words(ltl::Formula formula, const Dfa& dfa) {
  const ltl::Vocabulary& vocabulary = formula.arena().vocabulary();
  ltl::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const ltl::Trace word = ltl::random_trace(random, {.length = 1 + random.below(8), .atoms = vocabulary.size()});
    const bool expected = ltl::holds(word, formula);
    if (automata::accepts(dfa, word) != expected)
      wrong(formula, expected ? "it rejects" : "it accepts", ltl::show(word, vocabulary));
  }
}

// The DFAs of φ and ¬φ, where every word must be accepted by exactly one.
void prove(ltl::Formula formula, const Dfa& positive, const Dfa& negative) {
  const Dfa both = automata::product(positive, negative, [](bool p, bool q) { return p && q; });
  if (const auto word = automata::shortest_word(both))
    wrong(formula, "it and its negation accept", ltl::show(*word, both.vocabulary()));
  const Dfa all(positive.vocabulary(), {}, automata::Mtbdd(),
                {automata::Mtbdd::terminal(1), automata::Mtbdd::terminal(1)}, {false, true}, automata::StateId{0});
  const Dfa any = automata::product(positive, negative, [](bool p, bool q) { return p || q; });
  if (const auto found = automata::difference(all, any))
    wrong(formula, "neither it nor its negation accepts", ltl::show(found->word, found->vocabulary));
}

// Is every word accepted by one of the two? Both are determinised where they are not deterministic; nullopt: that took
// more than was given to it.
std::optional<bool> prove_universal(ltl::Formula formula, const Automaton& positive, const Automaton& negative,
                                    const ltl::Limits& limits) {
  automata::Budget budget(determinization_steps, limits.states, limits.stop);
  try {
    const automata::Deterministic a = automata::determinized(positive, budget);
    const automata::Deterministic b = automata::determinized(negative, budget);
    const Automaton neither =
        automata::intersection(automata::complement(a).automaton(), automata::complement(b).automaton(), budget);
    if (const auto word = automata::find_lasso(neither, budget))
      wrong(formula, "neither it nor its negation accepts", ltl::show(*word, neither.vocabulary()));
    return true;
  } catch (const automata::Budget::Exceeded& spent) {
    if (spent.reason == automata::Budget::Exceeded::Reason::Stopped) throw;
    return std::nullopt;
  }
}

// Random lassos over the propositions of φ, read by the definition.
std::size_t try_words(ltl::Formula formula, const Automaton& positive, const Automaton& negative) {
  constexpr std::size_t words = 200;
  const ltl::Vocabulary& vocabulary = formula.arena().vocabulary();
  ltl::Random random(1);
  for (std::size_t i = 0; i < words; ++i) {
    const ltl::Lasso word = ltl::random_lasso(random, {.prefix = random.below(6),
                                                       .cycle = 1 + random.below(5),
                                                       .atoms = vocabulary.size(),
                                                       .density = 0.2 + 0.2 * static_cast<double>(random.below(4))});
    const bool expected = ltl::holds(word, formula);
    if (automata::accepts(positive, word) != expected)
      wrong(formula, expected ? "it rejects" : "it accepts", ltl::show(word, vocabulary));
    if (automata::accepts(negative, word) == expected)
      wrong(formula, expected ? "its negation accepts" : "its negation rejects", ltl::show(word, vocabulary));
  }
  return words;
}

const Automaton& omega_of(const Translated& result) {
  if (const auto* ldba = std::get_if<automata::TranslatedForMdps>(&result)) return ldba->automaton.automaton();
  return std::get<automata::Translated>(result).automaton;
}

Certificate certify_omega(ltl::Formula formula, const Automaton& positive, const Automaton& negative,
                          const ltl::Limits& limits) {
  automata::Budget budget(SIZE_MAX, limits.states, limits.stop);
  const Automaton both = automata::intersection(positive, negative, budget);
  if (const auto word = automata::find_lasso(both, budget))
    wrong(formula, "it and its negation accept", ltl::show(*word, both.vocabulary()));
  if (prove_universal(formula, positive, negative, limits)) return {.proved = true};
  return {.words = try_words(formula, positive, negative)};
}

}  // namespace

Certificate certify(ltl::Formula formula, const Translated& result, const Translation& translation,
                    const ltl::Limits& limits) {
  const Translated negated = translation.run(ltl::negate(formula), limits);
  if (std::holds_alternative<automata::Exhausted>(negated))
    throw automata::Budget::Exceeded{automata::Budget::Exceeded::Reason::States};
  if (const auto* dfa = std::get_if<Dfa>(&result)) {
    prove(formula, *dfa, std::get<Dfa>(negated));
    try_words(formula, *dfa);
    return {.proved = true};
  }
  return certify_omega(formula, omega_of(result), omega_of(negated), limits);
}

}  // namespace waymark::tools
