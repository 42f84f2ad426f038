#include "libautomata/deterministic/inclusion.hpp"

#include <algorithm>
#include <unordered_set>

#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// Pairs (q, r), live when some word is accepted from q and not from r.
class Differences {
 public:
  Differences(const Branching& a, const Branching& b, Effort& effort) : a_(a), b_(b), effort_(effort) {
    if (a.acceptance.sets + b.acceptance.sets > Marks::most)
      throw Effort::Spent{Effort::Spent::Reason::States};
    for (std::size_t i = 0; i < a.states() * b.states(); ++i) graph_.add_state();
    for (std::uint32_t q = 0; q < a.states(); ++q)
      for (std::uint32_t r = 0; r < b.states(); ++r) {
        if (trivial(q, r)) continue;
        seen_.clear();
        add(pair(q, r), a.roots[q], b.roots[r]);
      }
    const Condition rejected = b.acceptance.condition.negated().shifted(a.acceptance.sets);
    live_ = live_components(graph_, Condition::all_of({a.acceptance.condition, rejected})).live;
  }
  bool differ(std::uint32_t q, std::uint32_t r) const { return live_[pair(q, r)]; }

 private:
  bool trivial(std::uint32_t q, std::uint32_t r) const { return &a_ == &b_ && q == r; }
  std::uint32_t pair(std::uint32_t q, std::uint32_t r) const {
    return q * static_cast<std::uint32_t>(b_.states()) + r;
  }
  void add(std::uint32_t source, Node x, Node y) {
    if (!seen_.insert(std::uint64_t{x.id} << 32U | y.id).second) return;
    effort_.step();
    if (Mtbdd::is_terminal(x) && Mtbdd::is_terminal(y)) {
      const Branch p = a_.choices[Mtbdd::payload(x)].front(), q = b_.choices[Mtbdd::payload(y)].front();
      if (!trivial(p.target, q.target))
        graph_.add(source, {pair(p.target, q.target),
                            p.marks | Marks::from_bits(q.marks.bits() << a_.acceptance.sets)});
      return;
    }
    const Mtbdd::Variable top = std::min(a_.diagram.variable(x), b_.diagram.variable(y));
    const auto side = [&](const Mtbdd& diagram, Node n, bool high) {
      return diagram.variable(n) != top ? n : high ? diagram.high(n) : diagram.low(n);
    };
    for (const bool high : {false, true}) add(source, side(a_.diagram, x, high), side(b_.diagram, y, high));
  }

  const Branching &a_, &b_;
  Effort& effort_;
  BranchGraph graph_;
  std::unordered_set<std::uint64_t> seen_;  // pairs of nodes below one pair of states
  std::vector<bool> live_;
};

}  // namespace

std::vector<std::vector<bool>> inclusions(const Branching& a, const Branching& b, Effort& effort) {
  const Differences differences(a, b, effort);
  std::vector<std::vector<bool>> out(a.states(), std::vector<bool>(b.states()));
  for (std::uint32_t q = 0; q < a.states(); ++q)
    for (std::uint32_t r = 0; r < b.states(); ++r) out[q][r] = !differences.differ(q, r);
  return out;
}

}  // namespace waymark::automata
