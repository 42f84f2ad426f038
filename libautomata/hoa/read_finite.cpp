#include <algorithm>
#include <unordered_map>
#include <utility>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/hoa/syntax.hpp"
#include "libltl/diagnostic.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// States of the DFA are pairs (state of the file, may the word stop). The pair that fits the mark on the state (for
// the initial one: must not stop) has the state's own rank, the other one is appended when an edge asks for it.
class DfaBuilder {
 public:
  DfaBuilder(HoaAutomaton file, std::string_view source) : file_(std::move(file)), source_(source) {}

  Dfa build() {
    check_shape();
    number_states();
    for (std::size_t i = 0; i < order_.size(); ++i) roots_.push_back(root(order_[i]));
    for (std::size_t i = 0; i < extra_.size(); ++i) roots_.push_back(roots_[extra_[i]]);
    return finish_in_order();
  }

 private:
  [[noreturn]] void refuse(const HoaToken& at, std::string_view message) const {
    throw ltl::FormatError(source_, at.line, at.column, message);
  }

  void check_shape() const {
    using Op = HoaCondition::Op;
    const HoaCondition& condition = file_.acceptance;
    if (condition.op != Op::True && condition.op != Op::False && (condition.op != Op::Inf || condition.complemented))
      refuse(file_.acceptance_at,
             "the acceptance of a DFA is Büchi, 1 Inf(0), its mark saying where the word may stop (or t, or f)");
    if (file_.starts.size() > 1) refuse(file_.second_start_at, "several initial states: the automaton is no DFA");
    if (!file_.starts.empty() && file_.starts.front().size() > 1)
      throw ltl::FormatError(source_, 0, 0, "the initial states are a conjunction: alternating automata are no DFAs");
    for (const HoaAutomaton::State& state : file_.states)
      for (const HoaAutomaton::Edge& edge : state.edges)
        if (edge.targets.size() > 1) refuse(edge.at, "a universal branch: alternating automata are no DFAs");
  }

  // Ranks the numbers that occur; a missing one costs nothing.
  void number_states() {
    std::vector<std::uint64_t> numbers;
    for (const auto& start : file_.starts) numbers.push_back(start.front());
    for (const HoaAutomaton::State& state : file_.states) {
      numbers.push_back(state.number);
      for (const HoaAutomaton::Edge& edge : state.edges) numbers.push_back(edge.targets.front());
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    order_.assign(numbers.size(), nullptr);
    for (std::uint32_t i = 0; i < numbers.size(); ++i) rank_.emplace(numbers[i], i);
    for (const HoaAutomaton::State& state : file_.states) order_[rank_.at(state.number)] = &state;
    for (const HoaAutomaton::State* state : order_) may_stop_.push_back(state != nullptr && marked(state->marks));
    if (!file_.starts.empty()) {
      initial_ = rank_.at(file_.starts.front().front());
      marked_initial_ = may_stop_[initial_];
      may_stop_[initial_] = false;
    } else {  // no initial state: the empty language
      initial_ = static_cast<std::uint32_t>(order_.size());
      order_.push_back(nullptr);
      may_stop_.push_back(false);
    }
    states_ = static_cast<std::uint32_t>(order_.size());
  }

  bool marked(const std::vector<std::uint64_t>& marks) const {
    using Op = HoaCondition::Op;
    if (file_.acceptance.op != Op::Inf) return file_.acceptance.op == Op::True;
    return std::find(marks.begin(), marks.end(), file_.acceptance.set) != marks.end();
  }

  // The terminal of an edge; 0 is kept for "no edge here".
  Node target(const HoaAutomaton::Edge& edge) {
    const std::uint32_t rank = rank_.at(edge.targets.front());
    const bool on_state = rank == initial_ ? marked_initial_ : may_stop_[rank];
    const bool stop = on_state || marked(edge.marks);
    if (stop == may_stop_[rank]) return Mtbdd::terminal(rank + 1);
    const auto [at, fresh] = twin_.try_emplace(rank, states_ + static_cast<std::uint32_t>(extra_.size()));
    if (fresh) extra_.push_back(rank);
    return Mtbdd::terminal(at->second + 1);
  }

  Node root(const HoaAutomaton::State* state) {
    const Node missing = Mtbdd::terminal(0);
    Node all = missing;
    if (state == nullptr) return all;
    for (const HoaAutomaton::Edge& edge : state->edges) {
      const Node to = target(edge);
      bool clash = false;
      // if label then `to` (unless another edge was there) else what was there
      const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
        if (n[0] == Boolean::constant(false)) return n[1];
        if (n[0] != Boolean::constant(true) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
        clash = clash || (n[1] != missing && n[1] != to);
        return to;
      };
      all = file_.labels.apply(file_.labels.operation(), std::array{edge.label, all}, decide);
      if (clash) refuse(edge.at, "nondeterministic: another edge of this state shares a letter with this one");
    }
    return all;
  }

  Dfa finish_in_order() {
    Transitions out;
    const auto trap = static_cast<std::uint32_t>(roots_.size());
    bool incomplete = false;
    out.roots = out.diagram.import(
        file_.labels, roots_,
        [&](std::uint32_t payload) {
          incomplete = incomplete || payload == 0;
          return Mtbdd::terminal(payload == 0 ? trap : payload - 1);
        },
        [](Mtbdd::Variable v) { return v; });
    out.accepting = may_stop_;
    for (std::uint32_t rank : extra_) out.accepting.push_back(!may_stop_[rank]);
    if (incomplete) {
      out.roots.push_back(Mtbdd::terminal(trap));
      out.accepting.push_back(false);
    }
    out.initial = initial_;
    std::vector<ltl::Proposition> reads;
    for (std::uint32_t p = 0; p < file_.propositions.size(); ++p) reads.push_back({p});
    return as_dfa(std::move(out), ltl::Vocabulary(file_.propositions), reads);
  }

  HoaAutomaton file_;
  std::string_view source_;
  std::vector<const HoaAutomaton::State*> order_;  // by rank; null when the file does not define it
  std::unordered_map<std::uint64_t, std::uint32_t> rank_, twin_;
  std::vector<bool> may_stop_;        // by rank
  std::vector<std::uint32_t> extra_;  // ranks whose other pair was appended
  std::vector<Node> roots_;
  std::uint32_t initial_ = 0, states_ = 0;
  bool marked_initial_ = false;
};

}  // namespace

Dfa to_dfa(HoaAutomaton file, std::string_view source) { return DfaBuilder(std::move(file), source).build(); }

Dfa read_hoa(std::string_view text, std::string_view source) { return to_dfa(parse_hoa(text, source), source); }

}  // namespace waymark::automata
