#include "libautomata/deterministic/combination.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "libautomata/bdd/joint_choices.hpp"
#include "libautomata/graph/numbering.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/recurrence.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
constexpr std::uint32_t absent = UINT32_MAX;
using States = std::vector<std::uint32_t>;  // by part; `absent` for those that are not followed

// Marks such that a loop with exactly these marks is accepted (answer true) or rejected (answer false).
std::optional<Marks> marks_for(const Acceptance& acceptance, bool answer) {
  std::vector<Marks> tried{Marks(), Marks::first(acceptance.sets)};
  for (std::uint32_t mark = 0; mark < acceptance.sets; ++mark) tried.push_back(Marks::of(mark));
  for (Marks marks : tried)
    if (acceptance.condition.holds(marks) == answer) return marks;
  return std::nullopt;
}

// An equivalent automaton that can reject a loop. If the condition holds for all marks that are tried, one more mark is
// put on all branches and required infinitely often.
TransitionRelation rejectable(const TransitionRelation& automaton) {
  if (marks_for(automaton.acceptance, false)) return automaton;
  const std::uint32_t mark = automaton.acceptance.sets;
  if (mark >= Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
  std::vector<std::uint32_t> all(automaton.states());
  for (std::uint32_t q = 0; q < all.size(); ++q) all[q] = q;
  TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.marks = b.marks | Marks::of(mark);
    return branches;
  });
  out.acceptance = {mark + 1, Condition::all_of({Condition::inf(mark), automaton.acceptance.condition})};
  return out;
}

// A component automaton (a part) with two sets of its states: those that accept no word, and those that accept all.
struct Followed {
  TransitionRelation automaton;
  bool late;
  std::uint32_t first_mark;
  std::vector<bool> nothing, everything;
  std::vector<Node> roots;  // in the manager of the product that is being made

  Followed(const Operand& part, std::uint32_t mark)
      : automaton(rejectable(part.late ? started_inside(part.automaton) : part.automaton)),
        late(part.late),
        first_mark(mark) {
    const std::uint32_t sets = automaton.acceptance.sets;
    if (mark + sets >= Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    BranchGraph graph(automaton);
    const auto sink = static_cast<std::uint32_t>(graph.size());
    graph.add_state();
    graph.add(sink, {sink, Marks::of(sets)});  // missing edges lead to the sink, whose extra mark rejects
    ChoiceLists lists(automaton);
    for (std::uint32_t q = 0; q < sink; ++q) {
      const auto choices = lists.of(q);
      if (std::find(choices.begin(), choices.end(), Choices::none) != choices.end()) graph.add(q, {sink, {}});
    }
    const Condition accepts = automaton.acceptance.condition;
    const auto yes = live_components(graph, Condition::all_of({accepts, Condition::fin(sets)})).live;
    const auto no = live_components(graph, Condition::any_of({accepts.negated(), Condition::inf(sets)})).live;
    for (std::uint32_t q = 0; q < sink; ++q) {
      nothing.push_back(!yes[q]);
      everything.push_back(!no[q]);
    }
  }
  Condition condition() const { return automaton.acceptance.condition.shifted(first_mark); }
  Marks shifted(Marks marks) const { return Marks::from_bits(marks.bits() << first_mark); }
  void move_to(Mtbdd& diagram) {
    roots = diagram.import(
        automaton.diagram, automaton.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
        [](Mtbdd::Variable v) { return v; });
  }
  const Branch* branch(std::uint32_t choice) const {
    return choice == Choices::none ? nullptr : &automaton.choices[choice].front();
  }
};

// What is left to decide once some parts are settled. A part is settled when its state accepts nothing or everything.
struct Question {
  Condition over;  // Inf(i): part i accepts; Fin(i): part i rejects
  Marks parts;     // the numbers of the parts that occur in `over`
  Marks fixed;     // on every edge: marks with which the settled parts give their answers
};

// First the product of the parts that are not late is made (`early`); then the late parts are added to it component by
// component (`late`), each only in the components where its verdict matters.
class Combination {
 public:
  Combination(const std::vector<Operand>& parts, const Condition& over, Budget& budget) : budget_(budget), over_(over) {
    if (parts.size() > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    for (const Operand& part : parts) {
      parts_.emplace_back(part, sets_);
      sets_ += parts_.back().automaton.acceptance.sets;
    }
  }

  TransitionRelation run() {
    const Acceptance acceptance{sets_, answered(over_)};
    early_.acceptance = acceptance;
    make_early();
    if (std::none_of(parts_.begin(), parts_.end(), [](const Followed& part) { return part.late; }))
      return std::move(early_);
    late_.acceptance = acceptance;
    make_late();
    return std::move(late_);
  }

 private:
  struct State {
    std::uint32_t question;  // in the early product; in the late one: the state of the early product
    States states;
    friend auto operator<=>(const State&, const State&) = default;
  };
  // Inf(i) and Fin(i) replaced by the condition of part i and its negation.
  Condition answered(const Condition& over) const {
    std::vector<Condition> operands;
    switch (over.op()) {
      case Condition::Op::True:
      case Condition::Op::False: return over;
      case Condition::Op::Inf: return parts_[over.mark()].condition();
      case Condition::Op::Fin: return parts_[over.mark()].condition().negated();
      case Condition::Op::And:
      case Condition::Op::Or: break;
    }
    for (const Condition& operand : over.operands()) operands.push_back(answered(operand));
    return over.op() == Condition::Op::And ? Condition::all_of(std::move(operands))
                                           : Condition::any_of(std::move(operands));
  }

  // Parts whose state has settled are taken out of the question, those that do not matter out of the states.
  State settled(std::uint32_t before, States states) {
    Condition over = questions_[before].over;
    Marks answers = answers_[before];
    for (std::uint32_t i : questions_[before].parts.members()) {
      const std::uint32_t q = states[i];
      if (parts_[i].late && q == absent) continue;
      const bool yes = q != absent && parts_[i].everything[q];
      if (!yes && q != absent && !parts_[i].nothing[q]) continue;
      over = over.replaced(i, yes);
      if (yes) answers = answers | Marks::of(i);
    }
    const std::uint32_t question = number_of(over, answers);
    for (std::uint32_t i = 0; i < states.size(); ++i)
      if (!questions_[question].parts.contains(i)) states[i] = absent;
    return {question, std::move(states)};
  }
  std::uint32_t number_of(const Condition& over, Marks answers) {
    const auto [at, fresh] = question_.try_emplace(print(over), static_cast<std::uint32_t>(questions_.size()));
    if (!fresh) return at->second;
    Question made{over, over.marks(), Marks()};
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      if (made.parts.contains(i)) continue;
      const std::optional<Marks> marks = marks_for(parts_[i].automaton.acceptance, answers.contains(i));
      if (marks) made.fixed = made.fixed | parts_[i].shifted(*marks);
    }
    questions_.push_back(std::move(made));
    answers_.push_back(answers);
    return at->second;
  }
  bool early(std::uint32_t i) const { return !parts_[i].late; }

  void make_early() {
    for (Followed& part : parts_) part.move_to(early_.diagram);
    JointChoices joint(early_.diagram, budget_);
    States start;
    for (const Followed& part : parts_) start.push_back(part.automaton.initial);
    number_of(over_, Marks());
    State first = settled(0, std::move(start));
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
      if (parts_[i].late) first.states[i] = absent;
    numbering_.of(std::move(first), budget_);
    for (std::size_t s = 0; s < numbering_.size(); ++s) {  // doubles as the queue
      const State& state = numbering_[s];
      Node tuples = JointChoices::empty();
      for (std::uint32_t i = 0; i < parts_.size(); ++i)
        if (state.states[i] != absent) tuples = joint.extended(tuples, parts_[i].roots[state.states[i]]);
      early_.roots.push_back(
          joint.settled(tuples, [&](std::uint32_t tuple) { return early_choice(state, joint, tuple); }));
    }
  }
  std::uint32_t early_choice(const State& state, const JointChoices& joint, std::uint32_t tuple) {
    if (questions_[state.question].over.op() == Condition::Op::False) return Choices::none;
    States next = state.states;
    Marks marks = questions_[state.question].fixed;
    std::vector<std::uint32_t> choices(
        static_cast<std::size_t>(std::count_if(next.begin(), next.end(), [](std::uint32_t q) { return q != absent; })));
    joint.read(tuple, choices);
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < next.size(); ++i) {
      if (next[i] == absent) continue;
      const Branch* branch = parts_[i].branch(choices[at++]);
      next[i] = branch == nullptr ? absent : branch->target;
      if (branch != nullptr) marks = marks | parts_[i].shifted(branch->marks);
    }
    State target = settled(state.question, std::move(next));
    if (questions_[target.question].over.op() == Condition::Op::False) return Choices::none;
    const std::uint32_t number = numbering_.of(std::move(target), budget_);
    return early_.choices.intern({{number, marks}});
  }

  // By component of the early product: the late parts that the answer depends on there.
  std::vector<Marks> needed(const BranchGraph& graph, const Components& found) const {
    BranchGraph inside;
    for (std::uint32_t s = 0; s < graph.size(); ++s) inside.add_state();
    std::vector<bool> cyclic(found.count, false);
    for (std::uint32_t s = 0; s < graph.size(); ++s)
      for (const Branch& b : graph.branches(s)) {
        if (found.of[s] != found.of[b.target]) continue;
        inside.add(s, b);
        cyclic[found.of[s]] = true;
      }
    std::vector<Condition> over(found.count, Condition::constant(true));
    for (std::uint32_t s = 0; s < graph.size(); ++s) over[found.of[s]] = questions_[numbering_[s].question].over;
    Marks late;
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i].late) {
        late = late | Marks::of(i);
        continue;
      }
      const std::vector<bool> yes = accepting(inside, found, parts_[i].condition());
      const std::vector<bool> no = accepting(inside, found, parts_[i].condition().negated());
      for (std::uint32_t c = 0; c < found.count; ++c)
        if (yes[c] != no[c]) over[c] = over[c].replaced(i, yes[c]);
    }
    std::vector<Marks> out;
    for (std::uint32_t c = 0; c < found.count; ++c) out.push_back(cyclic[c] ? over[c].marks() & late : Marks());
    return out;
  }
  // By component: some cycle inside satisfies the condition.
  static std::vector<bool> accepting(const BranchGraph& inside, const Components& found, const Condition& condition) {
    const LiveComponents live = live_components(inside, condition);
    std::vector<bool> out(found.count, false);
    for (std::uint32_t s = 0; s < inside.size(); ++s)
      if (live.accepting[live.components.of[s]]) out[found.of[s]] = true;
    return out;
  }

  void make_late() {
    const BranchGraph graph(early_);
    found_ = components(graph);
    needed_ = needed(graph, found_);
    for (Followed& part : parts_) part.move_to(late_.diagram);
    const std::vector<Node> roots = late_.diagram.import(
        early_.diagram, early_.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
        [](Mtbdd::Variable v) { return v; });
    JointChoices joint(late_.diagram, budget_);
    Numbering<State> numbering;
    numbering.of(entered(early_.initial), budget_);
    for (std::size_t s = 0; s < numbering.size(); ++s) {  // doubles as the queue
      const State& state = numbering[s];
      Node tuples = joint.extended(JointChoices::empty(), roots[state.question]);
      for (std::uint32_t i : needed_[found_.of[state.question]].members())
        tuples = joint.extended(tuples, parts_[i].roots[state.states[i]]);
      late_.roots.push_back(
          joint.settled(tuples, [&](std::uint32_t tuple) { return late_choice(state, joint, tuple, numbering); }));
    }
  }
  State entered(std::uint32_t early) const {
    States states(parts_.size(), absent);
    for (std::uint32_t i : needed_[found_.of[early]].members()) states[i] = parts_[i].automaton.initial;
    return {early, std::move(states)};
  }
  std::uint32_t late_choice(const State& state, const JointChoices& joint, std::uint32_t tuple,
                            Numbering<State>& numbering) {
    const std::uint32_t component = found_.of[state.question];
    const std::vector<std::uint32_t> late = needed_[component].members();
    std::vector<std::uint32_t> choices(1 + late.size());
    joint.read(tuple, choices);
    if (choices[0] == Choices::none) return Choices::none;
    const Branch& b = early_.choices[choices[0]].front();
    if (found_.of[b.target] != component) return late_.choices.intern({{numbering.of(entered(b.target), budget_), {}}});
    State next{b.target, States(parts_.size(), absent)};
    Marks marks = b.marks;
    for (std::size_t k = 0; k < late.size(); ++k) {
      const Branch* branch = parts_[late[k]].branch(choices[1 + k]);
      if (branch == nullptr) throw std::invalid_argument("combination: a late part that is settled by a prefix");
      next.states[late[k]] = branch->target;
      marks = marks | parts_[late[k]].shifted(branch->marks);
    }
    const std::uint32_t number = numbering.of(std::move(next), budget_);
    return late_.choices.intern({{number, marks}});
  }

  Budget& budget_;
  Condition over_;
  std::vector<Followed> parts_;
  std::uint32_t sets_ = 0;
  TransitionRelation early_, late_;
  std::vector<Question> questions_;
  std::vector<Marks> answers_;  // by question: the settled parts that accept
  std::map<std::string, std::uint32_t> question_;
  Numbering<State> numbering_;  // of the early product
  Components found_;            // of the early product
  std::vector<Marks> needed_;
};

}  // namespace

TransitionRelation combination(const std::vector<Operand>& parts, const Condition& over, Budget& budget) {
  return Combination(parts, over, budget).run();
}

}  // namespace waymark::automata
