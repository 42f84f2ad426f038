#include "libautomata/omega/weak.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/residual.hpp"
#include "libautomata/graph/scc.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libltl/meaning/semantics.hpp"

namespace waymark::automata {
namespace {

using Letters = std::vector<ltl::Letter>;

// Shortest words in the graph of a deterministic automaton.
class Paths {
 public:
  Paths(const TransitionGraph& graph, const Mtbdd& diagram, const std::vector<ltl::Proposition>& reads)
      : graph_(graph), diagram_(diagram), reads_(reads) {}

  // Explores from a state; only vertices that `allowed` admits.
  template <class Allowed>
  void explore(Vertex start, const Allowed& allowed) {
    parent_.clear();
    start_ = start;
    std::vector<Vertex> queue{start};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Vertex w : graph_.successors(queue[i]))
        if (allowed(w) && parent_.try_emplace(w, queue[i]).second && w != start) queue.push_back(w);
  }
  // The word read from the start to a state, at least one letter.
  Letters to(Vertex state) const {
    Letters out;
    for (Vertex v = state; out.empty() || v != start_;) {
      ltl::Letter letter;
      Vertex u = parent_.at(v);
      for (; !graph_.is_state(u); v = u, u = parent_.at(v))
        if (graph_.successors(u)[1] == v && graph_.successors(u)[0] != v)
          letter.insert(reads_[diagram_.variable(graph_.node(u))]);
      out.push_back(letter);
      v = u;
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  const TransitionGraph& graph_;
  const Mtbdd& diagram_;
  const std::vector<ltl::Proposition>& reads_;
  Vertex start_ = 0;
  std::unordered_map<Vertex, Vertex> parent_;
};

// By component: whether it has a cycle, and whether its cycles accept.
class Colouring {
 public:
  Colouring(ltl::Formula f, const Transitions& automaton, const std::vector<ltl::Proposition>& reads, Budget& budget)
      : formula_(f),
        automaton_(automaton),
        graph_(automaton.diagram, automaton.roots),
        found_(components(graph_)),
        reach_(graph_, automaton.diagram, reads),
        loop_(graph_, automaton.diagram, reads),
        budget_(budget) {
    reach_.explore(graph_.of_state(automaton.initial), [](Vertex) { return true; });
  }

  // The largest colours, decreasing along edges, even where cycles accept and odd where they reject: [Loe01, Sec. 3].
  std::vector<bool> accepting() {
    std::vector<std::uint32_t> colour(found_.count, 2 * found_.count + 2);
    std::vector<bool> out(graph_.states());
    for (std::size_t i = 0; i < found_.order.size();) {  // successors first
      const std::uint32_t c = found_.of[found_.order[i]];
      const std::size_t begin = i;
      bool cyclic = false;
      for (; i < found_.order.size() && found_.of[found_.order[i]] == c; ++i)
        for (Vertex w : graph_.successors(found_.order[i])) {
          if (found_.of[w] == c)
            cyclic = true;
          else
            colour[c] = std::min(colour[c], colour[found_.of[w]]);
        }
      if (cyclic && (colour[c] % 2 == 0) != loop_accepts(c, begin)) --colour[c];
      for (std::size_t j = begin; j < i; ++j)
        if (graph_.is_state(found_.order[j])) out[graph_.state(found_.order[j])] = colour[c] % 2 == 0;
    }
    return out;
  }

 private:
  bool loop_accepts(std::uint32_t component, std::size_t begin) {
    while (!graph_.is_state(found_.order[begin])) ++begin;
    const Vertex state = found_.order[begin];
    const Vertex start = graph_.of_state(automaton_.initial);
    loop_.explore(state, [&](Vertex v) { return found_.of[v] == component; });
    const ltl::Lasso word(state == start ? Letters{} : reach_.to(state), loop_.to(state));
    budget_.step(word.size() * word.size() * 16);
    return ltl::holds(word, formula_);
  }

  ltl::Formula formula_;
  const Transitions& automaton_;
  TransitionGraph graph_;
  Components found_;
  Paths reach_, loop_;
  Budget& budget_;
};

}  // namespace

Transitions progression(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget) {
  Residuals residuals(f, reads, budget);
  std::vector<std::uint32_t> leaves;
  return close(residuals, ltl::Semantics::Infinite, leaves, budget);
}

Progression progression_with_meaning(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget) {
  Residuals residuals(f, reads, budget);
  std::vector<std::uint32_t> leaves;
  Progression out{close(residuals, ltl::Semantics::Infinite, leaves, budget), {}};
  for (std::uint32_t leaf : leaves) out.meaning.push_back(residuals.formula(residuals.leaf(leaf).residual, f.arena()));
  return out;
}

Transitions weak_deterministic(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget) {
  return weak_deterministic(f, reads, progression(f, reads, budget), budget);
}

Transitions weak_deterministic(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Transitions structure,
                               Budget& budget) {
  structure.accepting = Colouring(f, structure, reads, budget).accepting();
  return minimize(structure, budget);
}

TransitionRelation as_buchi(const Transitions& weak, const AsBuchi& options) {
  const auto accepts = [&](std::uint32_t q) { return weak.accepting[q] != options.complement; };
  const auto is_sink = [&](std::uint32_t q) { return !accepts(q) && weak.roots[q] == Mtbdd::terminal(q); };
  std::vector<std::uint32_t> kept, number(weak.roots.size(), 0);
  bool all = true;
  for (std::uint32_t q = 0; q < weak.roots.size(); ++q) {
    if (options.trim && is_sink(q) && q != weak.initial) continue;
    number[q] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(q);
    all = all && (accepts(q) || (options.trim && is_sink(q)));
  }
  TransitionRelation out;
  out.roots.resize(kept.size());
  for (const bool accepting : {false, true}) {  // marks belong to states
    std::vector<Mtbdd::Node> sources;
    for (std::uint32_t q : kept)
      if (accepts(q) == accepting) sources.push_back(weak.roots[q]);
    const Marks marks = !all && accepting ? Marks::of(0) : Marks();
    const auto leaf = [&](std::uint32_t target) {
      if (options.trim && is_sink(target)) return Mtbdd::terminal(Choices::none);
      return Mtbdd::terminal(out.choices.intern({{number[target], marks}}));
    };
    const std::vector<Mtbdd::Node> images =
        out.diagram.import(weak.diagram, sources, leaf, [](Mtbdd::Variable v) { return v; });
    std::size_t next = 0;
    for (std::uint32_t q : kept)
      if (accepts(q) == accepting) out.roots[number[q]] = images[next++];
  }
  out.initial = number[weak.initial];
  out.acceptance = all ? Acceptance::all() : Acceptance::buchi();
  return out;
}

std::optional<TransitionRelation> restarted(const TransitionRelation& automaton) {
  const Marks full = Marks::first(automaton.acceptance.sets);
  const auto is_sink = [&](std::uint32_t q) {
    const Mtbdd::Node root = automaton.roots[q];
    if (!Mtbdd::is_terminal(root)) return false;
    const auto choice = automaton.choices[Mtbdd::payload(root)];
    return choice.size() == 1 && choice[0] == Branch{q, full};
  };
  const LiveComponents live = live_components(BranchGraph(automaton), automaton.acceptance.condition);
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    if (live.accepting[live.components.of[q]] != is_sink(q)) return std::nullopt;
  if (is_sink(automaton.initial)) return std::nullopt;
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches;
    for (const Branch& b : choice)
      branches.push_back(is_sink(b.target) ? Branch{automaton.initial, Marks::of(0)} : Branch{b.target, {}});
    return branches;
  });
  out.acceptance = Acceptance::buchi();
  return out;
}

}  // namespace waymark::automata
