#include "libautomata/omega/projection.hpp"

#include <algorithm>
#include <unordered_map>

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Projection {
 public:
  Projection(const TransitionRelation& from, Mtbdd::Variable kept) : from_(from), kept_(kept) {
    out_.initial = from.initial;
    out_.acceptance = from.acceptance;
    for (Node root : from.roots) out_.roots.push_back(collapsed(root));
  }
  TransitionRelation made() && { return std::move(out_); }

 private:
  Node collapsed(Node n) {
    if (Mtbdd::is_terminal(n)) {
      const auto branches = from_.choices[Mtbdd::payload(n)];
      return Mtbdd::terminal(out_.choices.intern({branches.begin(), branches.end()}));
    }
    if (const auto known = collapsed_.find(n.id); known != collapsed_.end()) return known->second;
    const Node low = collapsed(from_.diagram.low(n)), high = collapsed(from_.diagram.high(n));
    const Mtbdd::Variable variable = from_.diagram.variable(n);
    const Node made = variable < kept_ ? out_.diagram.make(variable, low, high) : united(low, high);
    collapsed_.emplace(n.id, made);
    return made;
  }
  // Below the propositions that are kept there are terminals only.
  Node united(Node a, Node b) {
    std::vector<Branch> all;
    for (Node n : {a, b}) {
      const auto branches = out_.choices[Mtbdd::payload(n)];
      all.insert(all.end(), branches.begin(), branches.end());
    }
    return Mtbdd::terminal(out_.choices.intern(std::move(all)));
  }

  const TransitionRelation& from_;
  Mtbdd::Variable kept_;
  TransitionRelation out_;
  std::unordered_map<std::uint32_t, Node> collapsed_;
};

}  // namespace

Automaton projected(const Automaton& automaton, const ltl::Vocabulary& names) {
  std::vector<ltl::Proposition> kept = automaton.reads();
  std::erase_if(kept, [&](ltl::Proposition p) { return p.index >= names.size(); });
  Projection projection(automaton.transitions(), static_cast<Mtbdd::Variable>(kept.size()));
  return as_automaton(std::move(projection).made(), names, kept);
}

}  // namespace waymark::automata
