#include "libautomata/omega/automaton.hpp"

#include <stdexcept>
#include <utility>

namespace waymark::automata {
namespace {

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

void check_choices(const TransitionRelation& automaton) {
  const Marks known = Marks::first(automaton.acceptance.sets);
  for (std::uint32_t c = 0; c < automaton.choices.size(); ++c)
    for (const Branch& branch : automaton.choices[c]) {
      require(branch.target < automaton.states(), "a branch of an automaton leads to no state");
      require(known.includes(branch.marks), "a branch carries a mark that the acceptance does not have");
    }
}

}  // namespace

Automaton::Automaton(ltl::Vocabulary vocabulary, std::vector<ltl::Proposition> reads, TransitionRelation transitions)
    : vocabulary_(std::move(vocabulary)), reads_(std::move(reads)), transitions_(std::move(transitions)) {
  require(transitions_.initial < states(), "the initial state of an automaton must be one of its states");
  require(acceptance().sets <= Marks::most, "an automaton with more than 64 acceptance sets");
  require(Marks::first(acceptance().sets).includes(acceptance().condition.marks()),
          "the acceptance condition names a mark that the automaton does not have");
  for (ltl::Proposition p : reads_) require(p.index < vocabulary_.size(), "an automaton reads an unknown proposition");
  check_choices(transitions_);
  const auto is_choice = [&](Mtbdd::Node n) {
    return !Mtbdd::is_terminal(n) || Mtbdd::payload(n) < transitions_.choices.size();
  };
  for (Mtbdd::Node root : transitions_.roots) require(is_choice(root), "an automaton's terminal is no choice");
  for (Mtbdd::Node n : diagram().reachable(transitions_.roots)) {
    require(is_choice(diagram().low(n)) && is_choice(diagram().high(n)), "an automaton's terminal is no choice");
    require(diagram().variable(n) < reads_.size(), "an edge asks for a proposition that is not read");
  }
}

void Automaton::rename(ltl::Vocabulary names) {
  for (ltl::Proposition p : reads_)
    require(p.index < names.size(), "a proposition that an automaton reads has no new name");
  vocabulary_ = std::move(names);
}

std::span<const Branch> Automaton::next(StateId q, const ltl::Letter& letter) const {
  const auto holds = [&](Mtbdd::Variable v) { return letter.contains(reads_[v]); };
  return transitions_.choices[Mtbdd::payload(diagram().evaluate(root(q), holds))];
}

std::vector<ltl::Proposition> keep_asked(TransitionRelation& transitions, const std::vector<ltl::Proposition>& reads) {
  std::vector<bool> asked(reads.size(), false);
  for (Mtbdd::Node n : transitions.diagram.reachable(transitions.roots)) asked[transitions.diagram.variable(n)] = true;
  std::vector<ltl::Proposition> kept;
  std::vector<Mtbdd::Variable> renamed(reads.size());
  for (std::size_t v = 0; v < reads.size(); ++v) {
    renamed[v] = static_cast<Mtbdd::Variable>(kept.size());
    if (asked[v]) kept.push_back(reads[v]);
  }
  Mtbdd diagram;
  transitions.roots = diagram.import(
      transitions.diagram, transitions.roots, [](std::uint32_t choice) { return Mtbdd::terminal(choice); },
      [&](Mtbdd::Variable v) { return renamed[v]; });
  transitions.diagram = std::move(diagram);
  return kept;
}

Automaton as_automaton(const TransitionRelation& transitions, const ltl::Vocabulary& vocabulary,
                       const std::vector<ltl::Proposition>& reads) {
  TransitionRelation numbered = canonical(transitions);
  std::vector<ltl::Proposition> kept = keep_asked(numbered, reads);
  return Automaton(vocabulary, std::move(kept), std::move(numbered));
}

}  // namespace waymark::automata
