#include "libautomata/deterministic/one_language.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// Pairs (q, r) of a complete automaton, live when some word is accepted from q and not from r.
class Differences {
 public:
  Differences(const Branching& automaton, Effort& effort) : from_(automaton), effort_(effort) {
    const auto states = static_cast<std::uint32_t>(automaton.states());
    const std::uint32_t sets = automaton.acceptance.sets;
    if (2 * sets > Marks::most) throw Effort::Spent{Effort::Spent::Reason::States};
    for (std::uint32_t i = 0; i < states * states; ++i) graph_.add_state();
    for (std::uint32_t q = 0; q < states; ++q)
      for (std::uint32_t r = 0; r < states; ++r) {
        if (q == r) continue;
        seen_.clear();
        add(pair(q, r), automaton.roots[q], automaton.roots[r]);
      }
    const Condition& accepts = automaton.acceptance.condition;
    live_ = live_components(graph_, Condition::all_of({accepts, accepts.negated().shifted(sets)})).live;
  }
  bool same(std::uint32_t q, std::uint32_t r) const { return !live_[pair(q, r)] && !live_[pair(r, q)]; }

 private:
  std::uint32_t pair(std::uint32_t q, std::uint32_t r) const {
    return q * static_cast<std::uint32_t>(from_.states()) + r;
  }
  void add(std::uint32_t source, Node x, Node y) {
    if (!seen_.insert(std::uint64_t{x.id} << 32U | y.id).second) return;
    effort_.step();
    if (Mtbdd::is_terminal(x) && Mtbdd::is_terminal(y)) {
      const Branch a = from_.choices[Mtbdd::payload(x)].front(), b = from_.choices[Mtbdd::payload(y)].front();
      if (a.target != b.target)
        graph_.add(source, {pair(a.target, b.target),
                            a.marks | Marks::from_bits(b.marks.bits() << from_.acceptance.sets)});
      return;
    }
    const Mtbdd& diagram = from_.diagram;
    const Mtbdd::Variable top = std::min(diagram.variable(x), diagram.variable(y));
    const auto side = [&](Node n, bool high) {
      return diagram.variable(n) != top ? n : high ? diagram.high(n) : diagram.low(n);
    };
    for (const bool high : {false, true}) add(source, side(x, high), side(y, high));
  }

  const Branching& from_;
  Effort& effort_;
  BranchGraph graph_;
  std::unordered_set<std::uint64_t> seen_;  // pairs of nodes below one pair of states
  std::vector<bool> live_;
};

}  // namespace

std::vector<std::uint32_t> languages(const Branching& complete, Effort& effort) {
  const Differences differences(complete, effort);
  std::vector<std::uint32_t> first(complete.states());
  for (std::uint32_t q = 0; q < first.size(); ++q)
    for (first[q] = 0; first[q] < q; ++first[q])
      if (differences.same(first[q], q)) break;
  return first;
}

Branching one_component_each(const Branching& automaton, Effort& effort) {
  const Branching complete = completed_parity(automaton);
  const std::vector<std::uint32_t> language = languages(complete, effort);
  const Components found = components(BranchGraph(complete));
  std::vector<std::uint32_t> all(complete.states()), image(complete.states());
  std::iota(all.begin(), all.end(), 0U);
  image = all;
  for (std::uint32_t q : all)
    for (std::uint32_t r : all)
      if (found.of[r] < found.of[image[q]] && language[q] == language[r]) image[q] = r;
  Branching out = rebuild(complete, all, [&](std::uint32_t, std::span<const Branch> choice) {
    return std::vector<Branch>{{image[choice.front().target], choice.front().marks}};
  });
  out.initial = image[complete.initial];
  return out;
}

}  // namespace waymark::automata
