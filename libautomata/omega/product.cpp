#include "libautomata/omega/product.hpp"

#include "libautomata/graph/numbered_pairs.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Intersection {
 public:
  Intersection(const TransitionRelation& a, const TransitionRelation& b, Budget& budget)
      : a_(a), b_(b), budget_(budget) {
    if (a.acceptance.sets + b.acceptance.sets > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    const auto same = [](std::uint32_t payload) { return Mtbdd::terminal(payload); };
    const auto keep = [](Mtbdd::Variable v) { return v; };
    a_roots_ = out_.diagram.import(a.diagram, a.roots, same, keep);
    b_roots_ = out_.diagram.import(b.diagram, b.roots, same, keep);
    operation_ = out_.diagram.operation();
  }
  Pairs run() {
    out_.initial = number(a_.initial, b_.initial);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {  // the pairs double as the queue
      const auto [p, q] = pairs_[i];
      out_.roots.push_back(both(a_roots_[p], b_roots_[q]));
    }
    const std::uint32_t by = a_.acceptance.sets;
    out_.acceptance = {by + b_.acceptance.sets,
                       Condition::all_of({a_.acceptance.condition, b_.acceptance.condition.shifted(by)})};
    return {std::move(out_), std::move(pairs_).list()};
  }

 private:
  std::uint32_t number(std::uint32_t p, std::uint32_t q) { return pairs_.number(p, q, budget_); }
  // Terminals: choices of a on the left, of b on the right, of the product in the result.
  Node both(Node f, Node g) {
    const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
      budget_.step();
      const Node none = Mtbdd::terminal(Choices::none);
      if (n[0] == none || n[1] == none) return none;
      if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
      std::vector<Branch> branches;
      for (const Branch& x : a_.choices[Mtbdd::payload(n[0])])
        for (const Branch& y : b_.choices[Mtbdd::payload(n[1])])
          branches.push_back(
              {number(x.target, y.target), x.marks | Marks::from_bits(y.marks.bits() << a_.acceptance.sets)});
      return Mtbdd::terminal(out_.choices.intern(std::move(branches)));
    };
    return out_.diagram.apply(operation_, std::array{f, g}, decide);
  }

  const TransitionRelation &a_, &b_;
  Budget& budget_;
  TransitionRelation out_;
  std::vector<Node> a_roots_, b_roots_;
  Mtbdd::Operation operation_;
  NumberedPairs pairs_;
};

}  // namespace

Pairs pairs_of(const TransitionRelation& a, const TransitionRelation& b, Budget& budget) {
  return Intersection(a, b, budget).run();
}
TransitionRelation intersection(const TransitionRelation& a, const TransitionRelation& b, Budget& budget) {
  return pairs_of(a, b, budget).automaton;
}

}  // namespace waymark::automata
