#include "libautomata/deterministic/colours.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

constexpr std::uint32_t unset = UINT32_MAX;

struct Edge {
  std::uint32_t source, target, colour, height;
};

class Heights {
 public:
  // lowest: of a component that accepts, and of one that rejects: 0 and 1, or 2 and 1.
  Heights(const TransitionRelation& automaton, std::uint32_t accepting) : accepting_(accepting) {
    const BranchGraph graph(automaton);
    states_ = graph.size();
    for (std::uint32_t q = 0; q < states_; ++q)
      for (const Branch& b : graph.branches(q)) edges_.push_back({q, b.target, colour_of(automaton, b.marks), unset});
    std::vector<std::size_t> all(edges_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const Components found = components_of(all);
    lift(all);
    std::vector<std::uint32_t> first(found.count, unset);
    for (const Edge& e : edges_) {
      if (e.height == unset) continue;
      most_ = std::max(most_, e.height);
      least_ = std::min(least_, e.height);
      std::uint32_t& of_component = first[found.of[e.source]];
      if (of_component == unset) of_component = e.height;
      weak_ = weak_ && of_component == e.height;
    }
    if (least_ == unset) least_ = most_;
  }
  bool weak() const { return weak_; }
  std::uint32_t colours() const { return most_ - least_; }

  TransitionRelation applied(const TransitionRelation& automaton) const {
    const std::uint32_t top = most_ + most_ % 2, sets = top - least_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> colour;
    for (const Edge& e : edges_) colour[{e.source, e.target, e.colour}] = top - (e.height == unset ? least_ : e.height);
    std::vector<std::uint32_t> all(automaton.states());
    std::iota(all.begin(), all.end(), 0U);
    TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t q, std::span<const Branch> choice) {
      std::vector<Branch> branches;
      for (const Branch& b : choice)
        branches.push_back({b.target, mark_of(colour.at({q, b.target, colour_of(automaton, b.marks)}), sets)});
      return branches;
    });
    out.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, sets);
    return out;
  }

 private:
  struct Subgraph {
    const std::vector<std::vector<std::uint32_t>>& targets;
    std::size_t size() const { return targets.size(); }
    const std::vector<std::uint32_t>& successors(std::uint32_t q) const { return targets[q]; }
  };
  Components components_of(const std::vector<std::size_t>& edges) const {
    std::vector<std::vector<std::uint32_t>> targets(states_);
    for (std::size_t e : edges) targets[edges_[e].source].push_back(edges_[e].target);
    return components(Subgraph{targets});
  }
  // Sets the heights of the edges that lie on cycles of these edges; returns the greatest of them.
  std::uint32_t lift(const std::vector<std::size_t>& edges) {
    const Components found = components_of(edges);
    std::map<std::uint32_t, std::vector<std::size_t>> inside;
    for (std::size_t e : edges)
      if (found.of[edges_[e].source] == found.of[edges_[e].target]) inside[found.of[edges_[e].source]].push_back(e);
    std::uint32_t most = 0;
    for (const auto& [component, own] : inside) {
      std::uint32_t least = unset;
      for (std::size_t e : own) least = std::min(least, edges_[e].colour);
      std::vector<std::size_t> rest;
      for (std::size_t e : own)
        if (edges_[e].colour != least) rest.push_back(e);
      std::uint32_t height = least % 2 == 0 ? accepting_ : 1;
      if (!rest.empty()) height = std::max(height, lift(rest));
      if (height % 2 != least % 2) ++height;
      for (std::size_t e : own)
        if (edges_[e].height == unset) edges_[e].height = height;
      most = std::max(most, height);
    }
    return most;
  }

  std::uint32_t accepting_;
  std::size_t states_ = 0;
  std::vector<Edge> edges_;
  std::uint32_t most_ = 0, least_ = unset;
  bool weak_ = true;
};

}  // namespace

std::uint32_t colour_of(const TransitionRelation& automaton, Marks marks) {
  return marks.empty() ? automaton.acceptance.sets : marks.members().front();
}
Marks mark_of(std::uint32_t colour, std::uint32_t sets) { return colour < sets ? Marks::of(colour) : Marks(); }

TransitionRelation completed_parity(const TransitionRelation& automaton) {
  if (is_complete(automaton)) return automaton;
  const auto sink = static_cast<std::uint32_t>(automaton.states());
  const std::uint32_t sets = std::max(automaton.acceptance.sets, 2U);
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    if (choice.empty()) return std::vector<Branch>{{sink, {}}};
    return std::vector<Branch>{{choice.front().target, mark_of(colour_of(automaton, choice.front().marks), sets)}};
  });
  out.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, sets);
  out.roots.push_back(Mtbdd::terminal(out.choices.intern({{sink, Marks::of(1)}})));
  return out;
}

Recoloured with_fewest_colours(const TransitionRelation& automaton) {
  const Heights from_even(automaton, 0), from_odd(automaton, 2);
  const Heights& best = from_odd.colours() < from_even.colours() ? from_odd : from_even;
  return {best.applied(automaton), best.weak()};
}

}  // namespace waymark::automata
