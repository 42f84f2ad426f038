#include "libautomata/omega/recurrence.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/bdd/joint_choices.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/weak.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

TransitionRelation without_marks(const Transitions& structure) {
  TransitionRelation out;
  const auto leaf = [&](std::uint32_t target) { return Mtbdd::terminal(out.choices.intern({{target, {}}})); };
  out.roots = out.diagram.import(structure.diagram, structure.roots, leaf, [](Mtbdd::Variable v) { return v; });
  out.initial = structure.initial;
  return out;
}

// By state of the structure: on which letters its edge lies in an accepting component of the product. The diagram
// receives them, with payloads 0 and 1.
std::vector<Node> taken_by_rejected_words(const Pairs& product, std::size_t states, Mtbdd& diagram, Budget& budget) {
  const TransitionRelation& pairs = product.automaton;
  const LiveComponents live = live_components(BranchGraph(pairs), pairs.acceptance.condition);
  const std::vector<std::uint32_t>& component = live.components.of;
  const std::vector<Node> roots = diagram.import(
      pairs.diagram, pairs.roots, [](std::uint32_t choice) { return Mtbdd::terminal(choice); },
      [](Mtbdd::Variable v) { return v; });
  Boolean logic(diagram);
  std::vector<Node> out(states, Boolean::constant(false));
  for (std::uint32_t i = 0; i < roots.size(); ++i) {
    if (!live.accepting[component[i]]) continue;
    const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
      budget.step();
      if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
      bool inside = false;
      for (const Branch& b : pairs.choices[Mtbdd::payload(n[0])])
        inside = inside || component[b.target] == component[i];
      return Boolean::constant(inside);
    };
    Node& sum = out[product.pairs[i].first];
    sum = logic.disjunction(sum, diagram.apply(diagram.operation(), std::array{roots[i]}, decide));
  }
  return out;
}

class Windows {
 public:
  Windows(const Transitions& cosafe, Budget& budget) : from_(cosafe), budget_(budget), joint_(out_.diagram, budget) {}

  TransitionRelation run() {
    roots_ = out_.diagram.import(
        from_.diagram, from_.roots, [](std::uint32_t q) { return Mtbdd::terminal(q); },
        [](Mtbdd::Variable v) { return v; });
    out_.acceptance = Acceptance::buchi();
    number({});
    for (std::size_t i = 0; i < sets_.size(); ++i) {  // the sets double as the queue
      const std::size_t runs = sets_[i].size() + 1;
      Node tuples = joint_.extended(JointChoices::empty(), roots_[from_.initial]);
      for (std::size_t k = 0; k + 1 < runs; ++k) tuples = joint_.extended(tuples, roots_[sets_[i][k]]);
      out_.roots.push_back(joint_.settled(tuples, [&](std::uint32_t tuple) { return choice(runs, tuple); }));
    }
    return std::move(out_);
  }

 private:
  std::uint32_t choice(std::size_t runs, std::uint32_t tuple) {
    std::vector<std::uint32_t> next(runs);
    joint_.read(tuple, next);
    const auto done = [&](std::uint32_t q) { return from_.roots[q] == Mtbdd::terminal(q); };
    const bool good =
        std::any_of(next.begin(), next.end(), [&](std::uint32_t q) { return done(q) && from_.accepting[q]; });
    next.erase(std::remove_if(next.begin(), next.end(), done), next.end());
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return out_.choices.intern({{number(std::move(next)), good ? Marks::of(0) : Marks()}});
  }
  std::uint32_t number(std::vector<std::uint32_t> set) {
    const auto [at, fresh] = number_.try_emplace(std::move(set), static_cast<std::uint32_t>(sets_.size()));
    if (fresh) {
      budget_.state();
      sets_.push_back(at->first);
    }
    return at->second;
  }

  const Transitions& from_;
  Budget& budget_;
  TransitionRelation out_;
  JointChoices joint_;
  std::vector<Node> roots_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> number_;
  std::vector<std::vector<std::uint32_t>> sets_;
};

}  // namespace

std::optional<TransitionRelation> recurring(const Transitions& cosafe, Budget& budget) {
  if (cosafe.accepting[cosafe.initial] && cosafe.roots[cosafe.initial] == Mtbdd::terminal(cosafe.initial))
    return std::nullopt;
  return Windows(cosafe, budget).run();
}

std::optional<OnProgression> on_progression(ltl::Formula f, const std::vector<ltl::Proposition>& reads,
                                            const TransitionRelation& yes, const TransitionRelation& no,
                                            Budget& budget) {
  const Transitions structure = progression(f, reads, budget);
  const Transitions guess = weak_deterministic(f, reads, structure, budget);
  TransitionRelation inside = as_buchi(guess, {.complement = false, .trim = true});
  const TransitionRelation outside = as_buchi(guess, {.complement = true, .trim = false});
  if (is_empty(intersection(yes, outside, budget)) && is_empty(intersection(inside, no, budget)))
    return OnProgression{std::move(inside), true};
  std::optional<TransitionRelation> marked = deterministic_buchi(structure, yes, no, budget);
  if (!marked) return std::nullopt;
  return OnProgression{*std::move(marked), false};
}

TransitionRelation started_inside(TransitionRelation automaton) {
  const BranchGraph graph(automaton);
  const Components found = components(graph);
  std::vector<std::uint32_t> size(found.count, 0);
  std::vector<bool> left(found.count, false);
  for (std::uint32_t q = 0; q < graph.size(); ++q) {
    ++size[found.of[q]];
    for (std::uint32_t r : graph.successors(q)) left[found.of[q]] = left[found.of[q]] || found.of[r] != found.of[q];
  }
  std::uint32_t best = 0;
  for (std::uint32_t c = 0; c < found.count; ++c)
    if (!left[c] && (left[best] || size[c] < size[best])) best = c;
  automaton.initial =
      *std::find_if(found.order.begin(), found.order.end(), [&](std::uint32_t q) { return found.of[q] == best; });
  return automaton;
}

std::optional<TransitionRelation> deterministic_buchi(const Transitions& structure, const TransitionRelation& yes,
                                                      const TransitionRelation& no, Budget& budget) {
  const TransitionRelation bare = without_marks(structure);
  TransitionRelation out;
  out.initial = bare.initial;
  const std::vector<Node> rejected =
      taken_by_rejected_words(pairs_of(bare, no, budget), bare.states(), out.diagram, budget);
  const std::vector<Node> roots = out.diagram.import(
      bare.diagram, bare.roots, [](std::uint32_t choice) { return Mtbdd::terminal(choice); },
      [](Mtbdd::Variable v) { return v; });
  const Mtbdd::Operation mark = out.diagram.operation();
  const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
    budget.step();
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    const Branch edge = bare.choices[Mtbdd::payload(n[0])].front();
    const Marks marks = n[1] == Boolean::constant(true) ? Marks() : Marks::of(0);
    return Mtbdd::terminal(out.choices.intern({{edge.target, marks}}));
  };
  for (std::uint32_t q = 0; q < bare.states(); ++q)
    out.roots.push_back(out.diagram.apply(mark, std::array{roots[q], rejected[q]}, decide));
  out.acceptance = Acceptance::co_buchi();  // its complement: the structure is deterministic and complete
  if (!is_empty(intersection(out, yes, budget))) return std::nullopt;
  out.acceptance = Acceptance::buchi();
  return out;
}

TransitionRelation rejected_by(const TransitionRelation& automaton) {
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  const auto sink = static_cast<std::uint32_t>(automaton.states());
  TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    return choice.empty() ? std::vector<Branch>{{sink, {}}} : std::vector<Branch>(choice.begin(), choice.end());
  });
  out.roots.push_back(Mtbdd::terminal(out.choices.intern({{sink, {}}})));
  out.acceptance.condition = out.acceptance.condition.negated();
  return out;
}

}  // namespace waymark::automata
