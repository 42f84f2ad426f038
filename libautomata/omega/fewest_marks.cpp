#include "libautomata/omega/fewest_marks.hpp"

#include <map>
#include <numeric>

#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

// Edges between states that are taken without meeting the mark.
class Unmarked {
 public:
  explicit Unmarked(std::size_t states) : successors_(states) {}
  void add(std::uint32_t from, std::uint32_t to) { successors_[from].push_back(to); }
  bool reaches(std::uint32_t from, std::uint32_t to, Budget& budget) const {
    std::vector<bool> seen(successors_.size(), false);
    std::vector<std::uint32_t> stack{from};
    while (!stack.empty()) {
      const std::uint32_t q = stack.back();
      stack.pop_back();
      if (q == to) return true;
      if (seen[q]) continue;
      seen[q] = true;
      budget.step();
      stack.insert(stack.end(), successors_[q].begin(), successors_[q].end());
    }
    return false;
  }

 private:
  std::vector<std::vector<std::uint32_t>> successors_;
};

}  // namespace

std::optional<TransitionRelation> fewest_marks(const TransitionRelation& automaton, Budget& budget) {
  const BranchGraph graph(automaton);
  std::map<std::pair<std::uint32_t, Branch>, Marks> lost;
  for (std::uint32_t mark = 0; mark < automaton.acceptance.sets; ++mark) {
    Unmarked unmarked(graph.size());
    for (std::uint32_t q = 0; q < graph.size(); ++q)
      for (const Branch& b : graph.branches(q))
        if (!b.marks.contains(mark)) unmarked.add(q, b.target);
    for (std::uint32_t q = 0; q < graph.size(); ++q)
      for (const Branch& b : graph.branches(q)) {
        if (!b.marks.contains(mark) || unmarked.reaches(b.target, q, budget)) continue;
        unmarked.add(q, b.target);
        Marks& all = lost[{q, b}];
        all = all | Marks::of(mark);
      }
  }
  if (lost.empty()) return std::nullopt;
  std::vector<std::uint32_t> kept(automaton.states());
  std::iota(kept.begin(), kept.end(), 0U);
  return rebuild(automaton, kept, [&](std::uint32_t source, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches)
      if (const auto at = lost.find({source, b}); at != lost.end()) b.marks = b.marks.without(at->second);
    return branches;
  });
}

}  // namespace waymark::automata
