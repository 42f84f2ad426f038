#include "libautomata/finite/run.hpp"

#include <stdexcept>

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// A letter that leads one step nearer to acceptance. Depth first over the diagram, false before true, no node twice.
class NearerLetter {
 public:
  NearerLetter(const Dfa& dfa, StateId q)
      : dfa_(dfa), wanted_(dfa.distance_to_acceptance(q)), failed_(dfa.diagram().size(), false) {}

  bool find(Node n, ltl::Letter& letter) {
    if (Mtbdd::is_terminal(n)) return leads_to(StateId{Mtbdd::payload(n)});
    if (failed_[n.id]) return false;
    if (find(dfa_.diagram().low(n), letter)) return true;
    const ltl::Proposition p = dfa_.reads()[dfa_.diagram().variable(n)];
    letter.insert(p);
    if (find(dfa_.diagram().high(n), letter)) return true;
    letter.erase(p);
    failed_[n.id] = true;
    return false;
  }

 private:
  bool leads_to(StateId q) const {
    return dfa_.distance_to_acceptance(q) != Dfa::unreachable && dfa_.distance_to_acceptance(q) < wanted_;
  }
  const Dfa& dfa_;
  std::uint32_t wanted_;
  std::vector<bool> failed_;
};

}  // namespace

Run run(const Dfa& dfa, const ltl::Trace& word) {
  Run out{{dfa.initial()}, false, std::nullopt};
  out.states.reserve(word.size() + 1);
  if (dfa.is_trap(dfa.initial())) out.trapped = 0;
  for (const ltl::Letter& letter : word) {
    out.states.push_back(dfa.next(out.states.back(), letter));
    if (!out.trapped && dfa.is_trap(out.states.back())) out.trapped = out.states.size() - 1;
  }
  out.accepted = dfa.is_accepting(out.states.back());
  return out;
}

std::optional<ltl::Trace> shortest_word(const Dfa& dfa) {
  if (dfa.is_trap(dfa.initial())) return std::nullopt;
  std::vector<ltl::Letter> letters;
  for (StateId q = dfa.initial(); !dfa.is_accepting(q);) {  // the initial state rejects: at least one letter
    ltl::Letter letter;
    if (!NearerLetter(dfa, q).find(dfa.root(q), letter)) throw std::logic_error("distance without a letter");
    letters.push_back(letter);
    q = dfa.next(q, letter);
  }
  return ltl::Trace(std::move(letters));
}

}  // namespace waymark::automata
