// Runtime monitors of conjunctions: one small monitor for each conjunct, verdicts combined.
//
// The monitor of φ₁ ∧ … ∧ φₙ as one automaton may have as many states as the product of those of all φᵢ. Kept apart,
// the conjuncts need the sum. A prefix is good when it is good for all, and bad when it is bad for one; also when no
// word continues it that satisfies the conjuncts together, though each could be satisfied by itself. Conjuncts that
// share propositions are asked about this on the fly (joint_search.hpp); answers are remembered by places, and found
// words are tried again before a search begins. Past the budget the verdict is open, and not known to be satisfiable.
// A disjunction is monitored as the negation of a conjunction, and G(φ ∧ ψ) as G φ ∧ G ψ. Verdicts: [BLS11, Sec. 3].
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "libautomata/monitor/joint_search.hpp"
#include "libautomata/monitor/monitor.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

struct MonitorVerdict {                   // after a letter
  Foresight foresight = Foresight::Open;  // what all continuations share
  std::optional<bool> now = {};           // finite words: whether the word so far satisfies the formula
  bool is_known_satisfiable = true;  // false: open, but whether some continuation satisfies the formula is not known
  friend bool operator==(const MonitorVerdict&, const MonitorVerdict&) = default;
};

// What may be spent on questions about several conjuncts, in moves that are tried: some tens of nanoseconds each.
struct JointEffort {
  std::size_t question = 100'000, all = 50'000'000;  // on one question; on all of them
};

// The operands of a conjunction, G(φ ∧ ψ) taken as two.
std::vector<ltl::Formula> conjuncts(ltl::Formula f);

class ConjunctionMonitor {  // a monitor and the word that it has read
 public:
  // The letters are over the vocabulary of f's arena, which need not stay.
  static std::variant<ConjunctionMonitor, Exhausted> of(ltl::Formula f, Words words, const ltl::Limits& limits,
                                                        const JointEffort& effort = {});
  ConjunctionMonitor(ConjunctionMonitor&&) noexcept;
  ConjunctionMonitor& operator=(ConjunctionMonitor&&) noexcept;
  ~ConjunctionMonitor();

  // O(conjuncts) for a letter that came before in the same places, and a search where conjuncts that share propositions
  // are in new ones. Throws Budget::Exceeded when a stop is requested.
  MonitorVerdict read(const ltl::Letter& letter);
  MonitorVerdict verdict() const { return verdict_; }  // before the first letter: of all words
  std::size_t parts() const;                           // conjuncts that are monitored

 private:
  class Run;
  ConjunctionMonitor(std::unique_ptr<Run> run, bool negated);
  MonitorVerdict shown(MonitorVerdict of_run) const;
  std::unique_ptr<Run> run_;
  bool negated_;  // a disjunction: the run is that of its negation
  MonitorVerdict verdict_;
};

}  // namespace waymark::automata
