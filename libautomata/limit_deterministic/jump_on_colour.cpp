#include "libautomata/limit_deterministic/jump_on_colour.hpp"

#include <algorithm>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

constexpr std::uint32_t unset = UINT32_MAX;

struct Digraph {  // a graph without letters
  std::vector<std::vector<std::uint32_t>> targets;
  std::size_t size() const { return targets.size(); }
  const std::vector<std::uint32_t>& successors(std::uint32_t q) const { return targets[q]; }
};

class Copies {
 public:
  explicit Copies(const TransitionRelation& parity) : from_(parity), graph_(parity) {}

  std::vector<Jump> jumps(AcceptingPart& accepting_part) {
    std::vector<Jump> out;
    add_buchi_region(accepting_part, out);
    for (std::uint32_t colour = 0; colour <= from_.acceptance.sets; colour += 2)
      add_components(colour, accepting_part, out);
    return out;
  }

 private:
  std::uint32_t colour(const Branch& b) const { return colour_of(from_, b.marks); }

  // Copies of some states, branches that stay among them; `marked` and `kept` look at a state and its branch.
  template <class Kept, class Marked>
  void copy(const std::vector<std::uint32_t>& states, const Kept& kept, const Marked& marked, bool whole,
            AcceptingPart& accepting_part, std::vector<Jump>& out) const {
    std::vector<std::uint32_t> number(graph_.size(), unset);
    for (std::uint32_t i = 0; i < states.size(); ++i) number[states[i]] = i;
    const TransitionRelation part = rebuild(from_, states, [&](std::uint32_t q, std::span<const Branch> choice) {
      std::vector<Branch> branches;
      for (const Branch& b : choice)
        if (number[b.target] != unset && kept(b))
          branches.push_back({number[b.target], marked(q, b) ? Marks::of(0) : Marks()});
      return branches;
    });
    const std::uint32_t first = accepting_part.add(part);
    for (std::uint32_t i = 0; i < states.size(); ++i) out.push_back({states[i], first + i, whole});
  }

  void add_components(std::uint32_t least, AcceptingPart& accepting_part, std::vector<Jump>& out) const {
    Digraph above{std::vector<std::vector<std::uint32_t>>(graph_.size())};
    for (std::uint32_t q = 0; q < graph_.size(); ++q)
      for (const Branch& b : graph_.branches(q))
        if (colour(b) >= least) above.targets[q].push_back(b.target);
    const Components found = components(above);
    std::vector<std::vector<std::uint32_t>> states(found.count);
    std::vector<bool> meets(found.count, false);
    for (std::uint32_t q = 0; q < graph_.size(); ++q) {
      states[found.of[q]].push_back(q);
      for (const Branch& b : graph_.branches(q))
        if (colour(b) == least && found.of[b.target] == found.of[q]) meets[found.of[q]] = true;
    }
    const auto kept = [&](const Branch& b) { return colour(b) >= least; };
    const auto marked = [&](std::uint32_t, const Branch& b) { return colour(b) == least; };
    for (std::uint32_t c = 0; c < found.count; ++c)
      if (meets[c]) copy(states[c], kept, marked, false, accepting_part, out);
  }

  // The states from which all components that a run can come into are Büchi as they are: at most one even colour
  // decides. Their copies accept their whole language.
  void add_buchi_region(AcceptingPart& accepting_part, std::vector<Jump>& out) const {
    const Components found = components(graph_);
    std::vector<std::uint32_t> mark(found.count, unset);  // by component: the colour that is marked
    std::vector<bool> good(found.count, true);
    std::vector<std::uint32_t> states;
    for (std::size_t i = 0; i < found.order.size();) {  // successors first
      const std::size_t begin = i;
      const std::uint32_t c = found.of[found.order[begin]];
      std::uint32_t least = unset;
      for (; i < found.order.size() && found.of[found.order[i]] == c; ++i)
        for (const Branch& b : graph_.branches(found.order[i])) {
          good[c] = good[c] && good[found.of[b.target]];
          if (found.of[b.target] == c) least = std::min(least, colour(b));
        }
      if (least != unset && least % 2 == 0) mark[c] = least;
      const std::vector<std::uint32_t> members(found.order.begin() + static_cast<std::ptrdiff_t>(begin),
                                               found.order.begin() + static_cast<std::ptrdiff_t>(i));
      good[c] = good[c] && !accepts_without(members, found, mark[c]);
      if (good[c]) states.insert(states.end(), members.begin(), members.end());
    }
    std::sort(states.begin(), states.end());
    const auto marked = [&](std::uint32_t q, const Branch& b) {
      return found.of[q] == found.of[b.target] && colour(b) == mark[found.of[q]];
    };
    if (!states.empty())
      copy(
          states, [](const Branch&) { return true; }, marked, true, accepting_part, out);
  }
  // Some cycle in the component accepts and does not meet this colour.
  bool accepts_without(const std::vector<std::uint32_t>& members, const Components& found,
                       std::uint32_t without) const {
    std::vector<std::uint32_t> number(graph_.size(), unset);
    for (std::uint32_t i = 0; i < members.size(); ++i) number[members[i]] = i;
    BranchGraph rest;
    for (std::size_t i = 0; i < members.size(); ++i) rest.add_state();
    for (std::uint32_t q : members)
      for (const Branch& b : graph_.branches(q))
        if (found.of[b.target] == found.of[q] && colour(b) != without) rest.add(number[q], {number[b.target], b.marks});
    const std::vector<bool> accepting = live_components(rest, from_.acceptance.condition).accepting;
    return std::find(accepting.begin(), accepting.end(), true) != accepting.end();
  }

  const TransitionRelation& from_;
  BranchGraph graph_;
};

}  // namespace

std::vector<Jump> jump_on_colour(const TransitionRelation& parity, AcceptingPart& accepting_part) {
  return Copies(parity).jumps(accepting_part);
}

}  // namespace waymark::automata
