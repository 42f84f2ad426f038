#include <algorithm>
#include <array>
#include <unordered_map>

#include "libautomata/hoa/omega.hpp"
#include "libautomata/hoa/written_graph.hpp"
#include "libautomata/omega/alternation.hpp"
#include "libltl/diagnostic.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class AutomatonBuilder {
 public:
  AutomatonBuilder(HoaAutomaton file, std::string_view source, Budget& budget)
      : file_(std::move(file)), source_(source), budget_(budget) {}

  Automaton build() {
    if (file_.aborted) refuse(file_.acceptance_at, "the automaton was aborted by its writer");
    read_acceptance();
    rank_states();
    TransitionRelation out = is_alternating() ? without_alternation(alternating_buchi(), budget_) : nondeterministic();
    std::vector<ltl::Proposition> reads;
    for (std::uint32_t p = 0; p < file_.propositions.size(); ++p) reads.push_back({p});
    return as_automaton(out, ltl::Vocabulary(file_.propositions), reads);
  }

 private:
  [[noreturn]] void refuse(const HoaToken& at, std::string_view message) const {
    throw ltl::FormatError(source_, at.line, at.column, message);
  }

  void read_acceptance() {
    find_complemented(file_.acceptance);
    const std::uint64_t sets = file_.sets + complemented_.size();
    if (sets > Marks::most)
      refuse(file_.acceptance_at,
             "at most 64 acceptance sets are read (a complemented one counts as another), not " + std::to_string(sets));
    acceptance_ = {static_cast<std::uint32_t>(sets), translated(file_.acceptance)};
  }

  void find_complemented(const HoaCondition& condition) {
    const auto known = std::find(complemented_.begin(), complemented_.end(), condition.set);
    if (condition.complemented && known == complemented_.end()) complemented_.push_back(condition.set);
    for (const HoaCondition& operand : condition.operands) find_complemented(operand);
  }

  std::uint32_t mark_of(const HoaCondition& leaf) const {
    if (!leaf.complemented) return static_cast<std::uint32_t>(leaf.set);
    const auto at = std::find(complemented_.begin(), complemented_.end(), leaf.set);
    return static_cast<std::uint32_t>(file_.sets) + static_cast<std::uint32_t>(at - complemented_.begin());
  }

  Condition translated(const HoaCondition& condition) const {
    using Op = HoaCondition::Op;
    std::vector<Condition> operands;
    for (const HoaCondition& operand : condition.operands) operands.push_back(translated(operand));
    switch (condition.op) {
      case Op::True: return Condition::constant(true);
      case Op::False: return Condition::constant(false);
      case Op::Inf: return Condition::inf(mark_of(condition));
      case Op::Fin: return Condition::fin(mark_of(condition));
      case Op::And: return Condition::all_of(std::move(operands));
      case Op::Or: return Condition::any_of(std::move(operands));
    }
    return Condition::constant(false);  // unreachable: -Werror=switch
  }

  // With the sets that stand for the complement of another one.
  Marks completed(std::uint64_t bits) const {
    for (std::size_t i = 0; i < complemented_.size(); ++i)
      if (((bits >> complemented_[i]) & 1U) == 0) bits |= std::uint64_t{1} << (file_.sets + i);
    return Marks::from_bits(bits);
  }
  Marks marks_of(const HoaAutomaton::State& state, const HoaAutomaton::Edge& edge) const {
    std::uint64_t bits = 0;
    for (const auto* marks : {&state.marks, &edge.marks})
      for (std::uint64_t mark : *marks) bits |= std::uint64_t{1} << mark;
    return completed(bits);
  }

  // States in the order of their numbers; a number that does not occur costs nothing.
  void rank_states() {
    std::vector<std::uint64_t> numbers;
    for (const auto& start : file_.starts) numbers.insert(numbers.end(), start.begin(), start.end());
    for (const HoaAutomaton::State& state : file_.states) {
      numbers.push_back(state.number);
      for (const HoaAutomaton::Edge& edge : state.edges)
        numbers.insert(numbers.end(), edge.targets.begin(), edge.targets.end());
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for (std::uint32_t i = 0; i < numbers.size(); ++i) rank_.emplace(numbers[i], i);
  }
  std::vector<std::uint32_t> ranks(const std::vector<std::uint64_t>& numbers) const {
    std::vector<std::uint32_t> out;
    for (std::uint64_t number : numbers) out.push_back(rank_.at(number));
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  bool is_alternating() const {
    const auto several = [](const std::vector<std::uint64_t>& states) { return states.size() > 1; };
    return std::any_of(file_.starts.begin(), file_.starts.end(), several) ||
           std::any_of(file_.states.begin(), file_.states.end(), [&](const HoaAutomaton::State& state) {
             return std::any_of(state.edges.begin(), state.edges.end(),
                                [&](const HoaAutomaton::Edge& edge) { return several(edge.targets); });
           });
  }

  AlternatingBuchi alternating_buchi() {
    const HoaGraph graph(file_);
    const Condition::Op op = acceptance_.condition.op();
    const bool is_buchi = op == Condition::Op::Inf || op == Condition::Op::True || op == Condition::Op::False;
    const auto& components = graph.components();
    if (!is_buchi &&
        !std::all_of(components.begin(), components.end(), [](const HoaGraph::Component& c) { return c.uniform; }))
      refuse(file_.acceptance_at,
             "universal branches are removed from automata that are weak or have Büchi acceptance, no others");
    AlternatingBuchi out;
    out.edges.resize(rank_.size());
    for (const HoaAutomaton::State& state : file_.states)
      for (const HoaAutomaton::Edge& edge : state.edges) {
        const HoaGraph::Component& component = components[graph.component_of(state.number)];
        const bool marked = acceptance_.condition.holds(is_buchi ? marks_of(state, edge) : completed(component.marks));
        out.edges[rank_.at(state.number)].push_back({edge.label, ranks(edge.targets), marked});
      }
    for (const auto& start : file_.starts) out.starts.push_back(ranks(start));
    out.diagram = std::move(file_.labels);
    return out;
  }

  TransitionRelation nondeterministic() {
    out_.acceptance = acceptance_;
    std::vector<Node> roots(rank_.size(), Mtbdd::terminal(Choices::none));
    for (const HoaAutomaton::State& state : file_.states) roots[rank_.at(state.number)] = root(state);
    if (file_.starts.size() == 1) {
      out_.initial = rank_.at(file_.starts.front().front());
    } else {
      out_.initial = static_cast<std::uint32_t>(roots.size());
      roots.push_back(root_of_starts(roots));
    }
    out_.roots = out_.diagram.import(
        file_.labels, roots, [](std::uint32_t choice) { return Mtbdd::terminal(choice); },
        [](Mtbdd::Variable v) { return v; });
    return std::move(out_);
  }

  Node root(const HoaAutomaton::State& state) {
    Node all = Mtbdd::terminal(Choices::none);
    for (const HoaAutomaton::Edge& edge : state.edges) {
      budget_.step();
      const Branch branch{rank_.at(edge.targets.front()), marks_of(state, edge)};
      const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
        if (n[0] == Boolean::constant(false)) return n[1];
        if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
        const auto known = out_.choices[Mtbdd::payload(n[1])];
        std::vector<Branch> more(known.begin(), known.end());
        more.push_back(branch);
        return Mtbdd::terminal(out_.choices.intern(std::move(more)));
      };
      all = file_.labels.apply(file_.labels.operation(), std::array{edge.label, all}, decide);
    }
    return all;
  }

  // One initial state that may do what any of them may.
  Node root_of_starts(const std::vector<Node>& roots) {
    const Mtbdd::Operation unite = file_.labels.operation();
    const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
      if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
      const auto a = out_.choices[Mtbdd::payload(n[0])], b = out_.choices[Mtbdd::payload(n[1])];
      std::vector<Branch> both(a.begin(), a.end());
      both.insert(both.end(), b.begin(), b.end());
      return Mtbdd::terminal(out_.choices.intern(std::move(both)));
    };
    Node all = Mtbdd::terminal(Choices::none);
    for (const auto& start : file_.starts)
      all = file_.labels.apply(unite, std::array{roots[rank_.at(start.front())], all}, decide);
    return all;
  }

  HoaAutomaton file_;
  std::string_view source_;
  Budget& budget_;
  Acceptance acceptance_;
  std::vector<std::uint64_t> complemented_;  // sets k of which Inf(!k) or Fin(!k) occurs
  std::unordered_map<std::uint64_t, std::uint32_t> rank_;
  TransitionRelation out_;
};

}  // namespace

Automaton to_automaton(HoaAutomaton file, std::string_view source, Budget& budget) {
  return AutomatonBuilder(std::move(file), source, budget).build();
}

Automaton read_omega_hoa(std::string_view text, std::string_view source) {
  Budget budget;
  return to_automaton(parse_hoa(text, source), source, budget);
}

}  // namespace waymark::automata
