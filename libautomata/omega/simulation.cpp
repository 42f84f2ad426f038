#include "libautomata/omega/simulation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/greatest_simulation.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// By state: the first state that it simulates and that simulates it.
std::vector<std::uint32_t> representatives(const StatePairs& below) {
  std::vector<std::uint32_t> out(below.states());
  for (std::uint32_t q = 0; q < out.size(); ++q)
    for (std::uint32_t r = 0; r <= q; ++r)
      if (below(q, r) && below(r, q)) {
        out[q] = r;
        break;
      }
  return out;
}

// Of branches that are no better than another one, one at a time goes.
template <class NoBetter>
void drop_dominated(std::vector<Branch>& branches, const NoBetter& no_better) {
  for (std::size_t i = 0; i < branches.size();) {
    const Branch b = branches[i];
    if (std::any_of(branches.begin(), branches.end(), [&](const Branch& a) { return a != b && no_better(b, a); }))
      branches.erase(branches.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
}

std::vector<Branch> unique(std::vector<Branch> branches) {
  std::sort(branches.begin(), branches.end());
  branches.erase(std::unique(branches.begin(), branches.end()), branches.end());
  return branches;
}

bool is_identity(const std::vector<std::uint32_t>& representative) {
  for (std::uint32_t q = 0; q < representative.size(); ++q)
    if (representative[q] != q) return false;
  return true;
}

// Classes numbered by first member; `kept` holds the representatives.
struct Merging {
  std::vector<std::uint32_t> kept, number;  // number: new state of an old one
};
Merging merging(const std::vector<std::uint32_t>& representative) {
  Merging out{{}, std::vector<std::uint32_t>(representative.size())};
  for (std::uint32_t q = 0; q < representative.size(); ++q) {
    if (representative[q] == q) {
      out.number[q] = static_cast<std::uint32_t>(out.kept.size());
      out.kept.push_back(q);
    } else {
      out.number[q] = out.number[representative[q]];
    }
  }
  return out;
}

TransitionRelation merged(const TransitionRelation& automaton, const StatePairs& below,
                          const std::vector<std::uint32_t>& representative) {
  const Merging merge = merging(representative);
  TransitionRelation out = rebuild(automaton, merge.kept, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.target = representative[b.target];
    branches = unique(std::move(branches));
    drop_dominated(branches, [&](const Branch& b, const Branch& a) {
      return a.marks.includes(b.marks) && below(b.target, a.target);
    });
    for (Branch& b : branches) b.target = merge.number[b.target];
    return branches;
  });
  out.initial = merge.number[automaton.initial];
  return out;
}

// No two states simulate each other. A branch that leaves its component may carry any marks: a run takes such ones
// finitely often. So it may replace a branch with marks whose target it simulates.
TransitionRelation pruned(const TransitionRelation& automaton, const StatePairs& below) {
  const BranchGraph graph(automaton);
  const Components found = components(graph);
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  return rebuild(automaton, all, [&](std::uint32_t source, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    drop_dominated(branches, [&](const Branch& b, const Branch& a) {
      const bool leaves = found.of[source] != found.of[a.target];
      return (leaves || a.marks.includes(b.marks)) && below(b.target, a.target);
    });
    return branches;
  });
}

}  // namespace

Quotient bisimulation(const TransitionRelation& automaton, Budget& budget) {
  std::vector<std::uint32_t> class_of(automaton.states(), 0);
  std::size_t classes = 1;
  while (true) {
    Mtbdd images;
    Choices choices;
    const auto leaf = [&](std::uint32_t c) {
      budget.step();
      std::vector<Branch> branches(automaton.choices[c].begin(), automaton.choices[c].end());
      for (Branch& b : branches) b.target = class_of[b.target];
      return Mtbdd::terminal(choices.intern(std::move(branches)));
    };
    const std::vector<Node> roots =
        images.import(automaton.diagram, automaton.roots, leaf, [](Mtbdd::Variable v) { return v; });
    std::map<std::pair<std::uint32_t, Node>, std::uint32_t> names;
    std::vector<std::uint32_t> next(class_of.size()), representative(class_of.size()), first;
    for (std::uint32_t q = 0; q < next.size(); ++q) {
      const auto [at, fresh] = names.try_emplace({class_of[q], roots[q]}, static_cast<std::uint32_t>(names.size()));
      if (fresh) first.push_back(q);
      next[q] = at->second;
      representative[q] = first[at->second];
    }
    class_of = std::move(next);
    if (names.size() == automaton.states()) return {automaton, std::move(representative)};
    if (names.size() == classes) {
      Merging merge = merging(representative);
      TransitionRelation out = rebuild(automaton, merge.kept, [&](std::uint32_t, std::span<const Branch> choice) {
        std::vector<Branch> branches(choice.begin(), choice.end());
        for (Branch& b : branches) b.target = merge.number[b.target];
        return branches;
      });
      out.initial = merge.number[automaton.initial];
      return {std::move(out), std::move(merge.number)};
    }
    classes = names.size();
  }
}

std::vector<bool> marked_states(const TransitionRelation& automaton) {
  std::vector<bool> out(automaton.states(), false);
  ChoiceLists lists(automaton);
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (const Branch& b : lists.branches(q)) out[q] = out[q] || !b.marks.empty();
  return out;
}

TransitionRelation united(const TransitionRelation& automaton, const std::vector<std::uint32_t>& representative,
                          Budget& budget) {
  const Merging merge = merging(representative);
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.target = merge.number[b.target];
    return branches;
  });
  const Mtbdd::Operation operation = out.diagram.operation();
  std::vector<Node> roots(merge.kept.size(), Mtbdd::terminal(Choices::none));
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    Node& root = roots[merge.number[q]];
    root = unite(out, operation, root, out.roots[q], budget);
  }
  out.roots = std::move(roots);
  out.initial = merge.number[automaton.initial];
  return out;
}

std::vector<std::vector<bool>> direct_simulation(const TransitionRelation& automaton, Budget& budget) {
  const StatePairs below = greatest_simulation(automaton, budget);
  std::vector<std::vector<bool>> out(automaton.states(), std::vector<bool>(automaton.states()));
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t r = 0; r < automaton.states(); ++r) out[q][r] = below(q, r);
  return out;
}

struct Simulations::Relations {
  std::optional<StatePairs> forwards, backwards;
};

Simulations::Simulations(const TransitionRelation& automaton, Budget& budget)
    : automaton_(automaton), budget_(budget), relations_(std::make_unique<Relations>()) {}
Simulations::~Simulations() = default;

const Simulations::Relations& Simulations::with_forwards() {
  if (!relations_->forwards) relations_->forwards = greatest_simulation(automaton_, budget_);
  return *relations_;
}
const Simulations::Relations& Simulations::with_backwards() {
  if (!relations_->backwards) relations_->backwards = greatest_reverse_simulation(automaton_, budget_);
  return *relations_;
}

TransitionRelation Simulations::quotient() {
  const StatePairs& below = *with_forwards().forwards;
  const std::vector<std::uint32_t> representative = representatives(below);
  return is_identity(representative) ? pruned(automaton_, below) : merged(automaton_, below, representative);
}

TransitionRelation Simulations::reverse_quotient(const std::vector<bool>& colour) {
  const StatePairs& below = *with_backwards().backwards;
  std::vector<std::uint32_t> representative(automaton_.states());
  for (std::uint32_t q = 0; q < representative.size(); ++q) {
    representative[q] = q;
    for (std::uint32_t r = 0; r < q && representative[q] == q; ++r)
      if (colour[q] == colour[r] && below(q, r) && below(r, q)) representative[q] = r;
  }
  return is_identity(representative) ? automaton_ : united(automaton_, representative, budget_);
}

TransitionRelation Simulations::without_overtaken() {
  const StatePairs &after = *with_forwards().forwards, &before = *with_backwards().backwards;
  TransitionRelation out = automaton_;
  const Mtbdd::Operation operation = out.diagram.operation();
  const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
    const Node none = Mtbdd::terminal(Choices::none);
    budget_.step();
    if (n[0] == none || n[1] == none) return n[0];
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    const auto mine = out.choices[Mtbdd::payload(n[0])], theirs = out.choices[Mtbdd::payload(n[1])];
    std::vector<Branch> kept;
    for (const Branch& b : mine)
      if (std::none_of(theirs.begin(), theirs.end(),
                       [&](const Branch& a) { return a.marks.includes(b.marks) && after(b.target, a.target); }))
        kept.push_back(b);
    return Mtbdd::terminal(out.choices.intern(std::move(kept)));
  };
  for (std::uint32_t p = 0; p < automaton_.states(); ++p)
    for (std::uint32_t q = 0; q < automaton_.states(); ++q)
      if (before(p, q) && !before(q, p))
        out.roots[p] = out.diagram.apply(operation, std::array{out.roots[p], automaton_.roots[q]}, decide);
  return out;
}

}  // namespace waymark::automata
