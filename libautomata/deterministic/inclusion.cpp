#include "libautomata/deterministic/inclusion.hpp"

#include "libautomata/bdd/pair_walk.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

// The graph of pairs (q, r), q a state of a and r a state of b. A pair is live when some word is accepted from q and
// not from r.
class Differences {
 public:
  Differences(const TransitionRelation& a, const TransitionRelation& b, Budget& budget) : a_(a), b_(b) {
    if (a.acceptance.sets + b.acceptance.sets > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    for (std::size_t i = 0; i < a.states() * b.states(); ++i) graph_.add_state();
    PairWalk pairs(a.diagram, b.diagram, budget);
    for (std::uint32_t q = 0; q < a.states(); ++q)
      for (std::uint32_t r = 0; r < b.states(); ++r) {
        if (trivial(q, r)) continue;
        pairs.from(a.roots[q], b.roots[r],
                   [&](std::uint32_t in_a, std::uint32_t in_b) { add(pair(q, r), in_a, in_b); });
      }
    const Condition rejected = b.acceptance.condition.negated().shifted(a.acceptance.sets);
    live_ = live_components(graph_, Condition::all_of({a.acceptance.condition, rejected})).live;
  }
  bool differ(std::uint32_t q, std::uint32_t r) const { return live_[pair(q, r)]; }

 private:
  // A state includes its own language, so its pair with itself needs no edges.
  bool trivial(std::uint32_t q, std::uint32_t r) const { return &a_ == &b_ && q == r; }
  std::uint32_t pair(std::uint32_t q, std::uint32_t r) const { return q * static_cast<std::uint32_t>(b_.states()) + r; }
  // Adds the edge of one joint choice. The marks of b are shifted behind those of a, so that both conditions can be
  // read.
  void add(std::uint32_t source, std::uint32_t in_a, std::uint32_t in_b) {
    const Branch p = a_.choices[in_a].front(), q = b_.choices[in_b].front();
    if (!trivial(p.target, q.target))
      graph_.add(source, {pair(p.target, q.target), p.marks | Marks::from_bits(q.marks.bits() << a_.acceptance.sets)});
  }

  const TransitionRelation &a_, &b_;
  BranchGraph graph_;
  std::vector<bool> live_;
};

}  // namespace

std::vector<std::vector<bool>> inclusions(const TransitionRelation& a, const TransitionRelation& b, Budget& budget) {
  const Differences differences(a, b, budget);
  std::vector<std::vector<bool>> out(a.states(), std::vector<bool>(b.states()));
  for (std::uint32_t q = 0; q < a.states(); ++q)
    for (std::uint32_t r = 0; r < b.states(); ++r) out[q][r] = !differences.differ(q, r);
  return out;
}

}  // namespace waymark::automata
