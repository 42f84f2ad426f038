#include "libautomata/finite/projection.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/finite/minimize.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
using Set = std::vector<std::uint32_t>;  // of states, sorted

class Projection {
 public:
  Projection(const Dfa& dfa, Mtbdd::Variable kept, Budget& budget)
      : dfa_(dfa), kept_(kept), budget_(budget), unite_(work_.operation()) {
    for (std::uint32_t q = 0; q < dfa.states(); ++q) single_.push_back(collapsed(dfa.root(StateId{q})));
  }

  Transitions build() {
    Transitions out;
    out.initial = number({dfa_.initial().index});
    std::vector<Node> roots;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const Set set = *sets_[i];
      const auto accepts = [&](std::uint32_t q) { return dfa_.is_accepting(StateId{q}); };
      out.accepting.push_back(std::any_of(set.begin(), set.end(), accepts));
      Node all = Mtbdd::terminal(number({}));
      for (std::uint32_t q : set) all = united(all, single_[q]);
      roots.push_back(all);
    }
    out.roots = out.diagram.import(
        work_, roots, [](std::uint32_t set) { return Mtbdd::terminal(set); }, [](Mtbdd::Variable v) { return v; });
    return out;
  }

 private:
  // The diagram of the automaton with sets for states, a union over the values of each variable that is forgotten.
  Node collapsed(Node n) {
    if (Mtbdd::is_terminal(n)) {
      const std::uint32_t q = Mtbdd::payload(n);
      return Mtbdd::terminal(number(dfa_.is_trap(StateId{q}) ? Set{} : Set{q}));
    }
    if (const auto known = collapsed_.find(n.id); known != collapsed_.end()) return known->second;
    const Node low = collapsed(dfa_.diagram().low(n)), high = collapsed(dfa_.diagram().high(n));
    const Mtbdd::Variable variable = dfa_.diagram().variable(n);
    const Node made = variable < kept_ ? work_.make(variable, low, high) : united(low, high);
    collapsed_.emplace(n.id, made);
    return made;
  }

  std::uint32_t number(Set set) {
    const auto [at, fresh] = number_.try_emplace(std::move(set), static_cast<std::uint32_t>(sets_.size()));
    if (fresh) {
      budget_.state();
      sets_.push_back(&at->first);
    }
    return at->second;
  }

  Node united(Node f, Node g) {
    const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
      budget_.step();
      if (n[0] == n[1]) return n[0];
      if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
      const Set &a = *sets_[Mtbdd::payload(n[0])], &b = *sets_[Mtbdd::payload(n[1])];
      Set both;
      std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
      return Mtbdd::terminal(number(std::move(both)));
    };
    return work_.apply(unite_, std::array{f, g}, decide);
  }

  const Dfa& dfa_;
  Mtbdd::Variable kept_;
  Budget& budget_;
  Mtbdd work_;  // payloads are sets
  Mtbdd::Operation unite_;
  std::unordered_map<std::uint32_t, Node> collapsed_;
  std::map<Set, std::uint32_t> number_;
  std::vector<const Set*> sets_;
  std::vector<Node> single_;  // by state
};

}  // namespace

Dfa projected(const Dfa& dfa, const ltl::Vocabulary& names, Budget& budget) {
  std::vector<ltl::Proposition> kept = dfa.reads();
  std::erase_if(kept, [&](ltl::Proposition p) { return p.index >= names.size(); });
  const Transitions subsets = Projection(dfa, static_cast<Mtbdd::Variable>(kept.size()), budget).build();
  const Transitions minimal = minimize(canonical(subsets, budget), budget);
  return as_dfa(canonical(minimal, budget), names, kept);
}

}  // namespace waymark::automata
