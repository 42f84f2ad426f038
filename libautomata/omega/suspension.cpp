#include "libautomata/omega/suspension.hpp"

#include "libautomata/graph/numbered_pairs.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class LateProduct {
 public:
  LateProduct(const TransitionRelation& automaton, const TransitionRelation& late, Budget& budget)
      : a_(automaton),
        b_(late),
        budget_(budget),
        live_(live_components(BranchGraph(automaton), automaton.acceptance.condition)) {
    const std::uint32_t sets = a_.acceptance.sets + b_.acceptance.sets;
    if (sets > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    out_.acceptance = Acceptance::generalized_buchi(sets);
    const auto same = [](std::uint32_t payload) { return Mtbdd::terminal(payload); };
    const auto keep = [](Mtbdd::Variable v) { return v; };
    a_roots_ = out_.diagram.import(a_.diagram, a_.roots, same, keep);
    b_roots_ = out_.diagram.import(b_.diagram, b_.roots, same, keep);
  }

  TransitionRelation run() {
    out_.initial = entry(a_.initial);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {  // the pairs double as the queue
      const auto [p, q] = pairs_[i];
      const Node late = q == alone ? Mtbdd::terminal(Choices::none) : b_roots_[q];
      out_.roots.push_back(successors(p, a_roots_[p], late));
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint32_t alone = UINT32_MAX;

  std::uint32_t component(std::uint32_t p) const { return live_.components.of[p]; }
  std::uint32_t entry(std::uint32_t p) { return number(p, live_.accepting[component(p)] ? b_.initial : alone); }
  std::uint32_t number(std::uint32_t p, std::uint32_t q) { return pairs_.number(p, q, budget_); }

  // What a letter means depends on the component of p, so an operation serves one state.
  Node successors(std::uint32_t p, Node f, Node g) {
    const bool paired = live_.accepting[component(p)];
    const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
      budget_.step();
      if (n[0] == Mtbdd::terminal(Choices::none)) return n[0];
      if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
      std::vector<Branch> branches;
      for (const Branch& x : a_.choices[Mtbdd::payload(n[0])]) {
        if (!paired || component(x.target) != component(p)) {
          branches.push_back({entry(x.target), {}});
          continue;
        }
        for (const Branch& y : b_.choices[Mtbdd::payload(n[1])])
          branches.push_back(
              {number(x.target, y.target), x.marks | Marks::from_bits(y.marks.bits() << a_.acceptance.sets)});
      }
      return Mtbdd::terminal(out_.choices.intern(std::move(branches)));
    };
    return out_.diagram.apply(out_.diagram.operation(), std::array{f, g}, decide);
  }

  const TransitionRelation &a_, &b_;
  Budget& budget_;
  LiveComponents live_;
  TransitionRelation out_;
  std::vector<Node> a_roots_, b_roots_;
  NumberedPairs pairs_;
};

}  // namespace

TransitionRelation compose_late(const TransitionRelation& automaton, const TransitionRelation& late, Budget& budget) {
  return LateProduct(automaton, late, budget).run();
}

}  // namespace waymark::automata
