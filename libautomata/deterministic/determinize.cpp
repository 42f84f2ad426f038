#include "libautomata/deterministic/determinize.hpp"

#include <algorithm>
#include <utility>

#include "libautomata/bdd/joint_choices.hpp"
#include "libautomata/deterministic/brace_tree.hpp"
#include "libautomata/graph/numbering.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/simulation.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class EdgeLevels {
 public:
  EdgeLevels(const TransitionRelation& automaton, Budget& budget)
      : from_(automaton),
        budget_(budget),
        live_(live_components(BranchGraph(automaton), automaton.acceptance.condition)),
        sets_(automaton.acceptance.sets) {}

  TransitionRelation run() {
    TransitionRelation out;
    out.acceptance = Acceptance::buchi();
    copy(from_.initial, 0);
    RootCopier copier(from_, out);
    for (std::size_t i = 0; i < copies_.size(); ++i) {  // the copies double as the queue
      const std::uint32_t q = copies_[i].first, level = copies_[i].second;
      const auto leaf = [&](std::uint32_t c) {
        std::vector<Branch> branches;
        for (const Branch& b : from_.choices[c]) branches.push_back(step(q, level, b));
        return out.choices.intern(std::move(branches));
      };
      out.roots.push_back(copier.copy(from_.roots[q], leaf));
    }
    return out;
  }

 private:
  Branch step(std::uint32_t q, std::uint32_t level, const Branch& b) {
    const std::uint32_t component = live_.components.of[q];
    if (component != live_.components.of[b.target] || !live_.accepting[component]) return {copy(b.target, 0), {}};
    const auto advanced = [&](std::uint32_t from) {
      while (from < sets_ && b.marks.contains(from)) ++from;
      return from;
    };
    std::uint32_t next = advanced(level);
    if (next < sets_) return {copy(b.target, next), {}};
    next = b.marks == Marks::first(sets_) ? 0 : advanced(0);  // what is left over counts for the next round
    return {copy(b.target, next), Marks::of(0)};
  }
  std::uint32_t copy(std::uint32_t q, std::uint32_t level) { return copies_.of({q, level}, budget_); }

  const TransitionRelation& from_;
  Budget& budget_;
  LiveComponents live_;
  std::uint32_t sets_;
  Numbering<std::pair<std::uint32_t, std::uint32_t>> copies_;
};

class Determinization {
 public:
  Determinization(const TransitionRelation& buchi, Budget& budget)
      : budget_(budget), rules_(buchi, direct_simulation(buchi, budget)), joint_(out_.diagram, budget) {
    from_roots_ = out_.diagram.import(
        buchi.diagram, buchi.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
        [](Mtbdd::Variable v) { return v; });
  }

  TransitionRelation run() {
    number(rules_.initial());
    for (std::size_t i = 0; i < trees_.size(); ++i) out_.roots.push_back(successors(trees_[i]));
    out_.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, colours_);
    return std::move(out_);
  }

 private:
  Node successors(const BraceTree& tree) {
    Node offered = JointChoices::empty();
    for (const auto& [q, brace] : tree.runs) offered = joint_.extended(offered, from_roots_[q]);
    return joint_.settled(offered, [&](std::uint32_t offer) { return step(tree, offer); });
  }
  std::uint32_t step(const BraceTree& tree, std::uint32_t offer) {
    budget_.step(tree.runs.size() * tree.runs.size() * 8);
    std::vector<std::uint32_t> choices(tree.runs.size());
    joint_.read(offer, choices);
    BraceStep next = rules_.successor(tree, choices);
    if (next.tree.runs.empty()) return Choices::none;
    Marks marks;
    if (next.colour != BraceStep::nothing) {
      if (next.colour + 3 > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
      marks = Marks::of(next.colour);
      colours_ = std::max(colours_, (next.colour | 1U) + 2);  // odd: a branch without mark counts as rejecting
    }
    return out_.choices.intern({{number(std::move(next.tree)), marks}});
  }
  std::uint32_t number(BraceTree tree) { return trees_.of(std::move(tree), budget_); }

  Budget& budget_;
  BraceRules rules_;
  TransitionRelation out_;
  std::vector<Node> from_roots_;
  JointChoices joint_;
  std::uint32_t colours_ = 1;
  Numbering<BraceTree> trees_;
};

}  // namespace

TransitionRelation degeneralize_on_edges(const TransitionRelation& automaton, Budget& budget) {
  return EdgeLevels(automaton, budget).run();
}

TransitionRelation determinize(const TransitionRelation& automaton, Budget& budget) {
  const TransitionRelation buchi = bisimulation_quotient(
      automaton.acceptance.is_buchi() ? canonical(automaton) : degeneralize_on_edges(automaton, budget), budget);
  return Determinization(buchi, budget).run();
}

}  // namespace waymark::automata
