#include "libautomata/routes.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

#include "libautomata/minimize.hpp"
#include "libautomata/product.hpp"
#include "libautomata/residual.hpp"
#include "libautomata/told_apart.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Op;
using Reads = std::vector<ltl::Proposition>;

// The leaves that the initial one reaches, closed under progression, as states.
Transitions close(Formula f, const Reads& reads, Effort& effort) {
  constexpr std::uint32_t unseen = UINT32_MAX;
  Residuals residuals(f, reads, effort);
  std::vector<std::uint32_t> order{residuals.initial()}, number(residuals.leaves(), unseen);
  number[residuals.initial()] = 0;
  std::vector<bool> visited;  // below a visited node every leaf is numbered already
  std::vector<Mtbdd::Node> stack, roots;
  for (std::size_t i = 0; i < order.size(); ++i) {
    effort.step();
    roots.push_back(residuals.successors(order[i]));
    number.resize(residuals.leaves(), unseen);
    visited.resize(residuals.diagram().size(), false);
    stack.push_back(roots.back());
    while (!stack.empty()) {
      const Mtbdd::Node n = stack.back();
      stack.pop_back();
      if (Mtbdd::is_terminal(n)) {
        std::uint32_t& q = number[Mtbdd::payload(n)];
        if (q != unseen) continue;
        q = static_cast<std::uint32_t>(order.size());
        order.push_back(Mtbdd::payload(n));
      } else if (!visited[n.id]) {
        visited[n.id] = true;
        stack.push_back(residuals.diagram().high(n));
        stack.push_back(residuals.diagram().low(n));
      }
    }
  }
  Transitions out;
  out.roots = out.diagram.import(
      residuals.diagram(), roots, [&](std::uint32_t leaf) { return Mtbdd::terminal(number[leaf]); },
      [](Mtbdd::Variable v) { return v; }, Mtbdd::Images::StayApart);
  for (std::uint32_t leaf : order) out.accepting.push_back(residuals.leaf(leaf).may_stop);
  return out;
}

// φ as a Boolean function of smaller formulas: verdicts of products, folded over the operands.
struct Decomposition {
  std::vector<Formula> operands;
  enum class By : std::uint8_t { Both, Either, One } by;
};
std::optional<Decomposition> decompose(Formula f) {
  using By = Decomposition::By;
  const bool negated = f.op() == Op::Not;
  const Formula g = negated ? f[0] : f;
  std::vector<Formula> operands(g.operands().begin(), g.operands().end());
  if (g.op() == Op::Iff) {  // φ ↔ ψ = φ ⊕ ¬ψ: the empty word stays out
    if (!negated) operands[1] = ltl::negate(operands[1]);
    return Decomposition{operands, By::One};
  }
  if (g.op() != Op::And && g.op() != Op::Or) return std::nullopt;
  if (negated)
    for (Formula& operand : operands) operand = ltl::negate(operand);
  return Decomposition{operands, (g.op() == Op::And) != negated ? By::Both : By::Either};
}

Verdict verdict_of(Decomposition::By by) {
  switch (by) {
    case Decomposition::By::Both: return [](bool p, bool q) { return p && q; };
    case Decomposition::By::Either: return [](bool p, bool q) { return p || q; };
    case Decomposition::By::One: return [](bool p, bool q) { return p != q; };
  }
  throw std::logic_error("a decomposition without a verdict");
}

// Operands that share propositions, directly or through others, joined to one formula each.
std::vector<Formula> disjoint_groups(const Decomposition& parts, const Reads& reads) {
  std::vector<std::size_t> group(parts.operands.size()), reader(reads.size(), SIZE_MAX);
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (std::size_t i = 0; i < parts.operands.size(); ++i) {
    for (const ltl::Proposition p : ltl::propositions(parts.operands[i])) {
      const auto at = std::lower_bound(reads.begin(), reads.end(), p) - reads.begin();
      std::size_t& first = reader[static_cast<std::size_t>(at)];
      if (first == SIZE_MAX) first = i;
      const std::size_t one = find(first), other = find(i);
      group[std::max(one, other)] = std::min(one, other);
    }
  }
  std::vector<std::vector<Formula>> members(parts.operands.size());
  for (std::size_t i = 0; i < parts.operands.size(); ++i) members[find(i)].push_back(parts.operands[i]);
  std::vector<Formula> out;
  for (const std::vector<Formula>& some : members) {
    if (some.empty()) continue;
    ltl::Arena& arena = some[0].arena();
    out.push_back(parts.by == Decomposition::By::Both ? ltl::conjunction(arena, some)
                                                      : ltl::disjunction(arena, some));
  }
  return out;
}

// A minimal automaton on its way into products.
struct Part {
  Transitions automaton;
  std::vector<bool> reads;         // by variable: may depend on it
  std::optional<bool> told_apart;  // at each length; none: not looked at yet
  std::size_t weight() const { return automaton.roots.size() + automaton.diagram.size(); }
};
using Known = std::shared_ptr<Part>;

bool share(const Part& a, const Part& b) {
  for (std::size_t v = 0; v < a.reads.size(); ++v)
    if (a.reads[v] && b.reads[v]) return true;
  return false;
}

bool told_apart(Part& part) {
  if (!part.told_apart) part.told_apart = told_apart_at_each_length(part.automaton);
  return *part.told_apart;
}

class Translation {
 public:
  Translation(const Reads& reads, const RouteLimits& limits, std::size_t& made)
      : reads_(reads), limits_(limits), made_(made) {}

  Transitions run(Formula f) {
    for (std::size_t purse = first_purse;; purse = purse > SIZE_MAX / 4 ? SIZE_MAX : 4 * purse) {
      more_steps_may_help_ = false;
      if (const Known found = attempt(f, purse)) return std::move(found->automaton);
      if (!more_steps_may_help_) throw Effort::Spent{Effort::Spent::Reason::States};
    }
  }

 private:
  static constexpr std::size_t first_purse = 1U << 12U;  // under a millisecond
  using By = Decomposition::By;

  // What is known of a formula from round to round.
  struct Task {
    Known found;
    bool direct_is_hopeless = false, opened = false, composable = false, disjoint = false;
    By by = By::Both;
    std::vector<Formula> operands;  // not translated yet, last first
    std::vector<Known> waiting;     // for a product
    std::size_t most_pairs = 1;     // of states of all operands
  };

  Known attempt(Formula f, std::size_t purse) {
    Task& task = tasks_[f];
    if (!task.found && !task.direct_is_hopeless) direct(f, task, purse);
    if (!task.found && compose(f, task, purse)) task.found = std::exchange(task.waiting, {}).front();
    return task.found;
  }

  void direct(Formula f, Task& task, std::size_t purse) {
    if (task.disjoint) return;
    const auto construct = [&](Effort& effort) {
      Part part{minimize(close(f, reads_, effort), effort), std::vector<bool>(reads_.size(), false), {}};
      for (const ltl::Proposition p : ltl::propositions(f)) part.reads[position(p)] = true;
      return part;
    };
    const Outcome outcome = within(task.composable ? purse / 4 : purse, construct);
    task.found = outcome.made;
    const bool beaten = task.composable && task.operands.empty() && outcome.states > task.most_pairs;
    task.direct_is_hopeless = outcome.out_of_states || beaten;
  }

  // One automaton in task.waiting, or false.
  bool compose(Formula f, Task& task, std::size_t purse) {
    open(f, task);
    if (!task.composable) return false;
    for (; !task.operands.empty(); task.operands.pop_back()) {
      const Known operand = attempt(task.operands.back(), purse);
      if (!operand) return false;
      const std::size_t states = operand->automaton.roots.size();
      task.most_pairs = task.most_pairs > SIZE_MAX / states ? SIZE_MAX : task.most_pairs * states;
      task.waiting.push_back(operand);
    }
    while (task.waiting.size() > 1)
      if (!multiply(task, purse)) return false;
    return true;
  }

  void open(Formula f, Task& task) {
    if (std::exchange(task.opened, true)) return;
    std::optional<Decomposition> parts = decompose(f);
    if (!parts) return;
    task.composable = true;
    task.by = parts->by;
    task.operands = std::move(parts->operands);
    if (parts->by != By::One) {
      std::vector<Formula> groups = disjoint_groups({task.operands, parts->by}, reads_);
      task.disjoint = groups.size() > 1;
      if (task.disjoint) task.operands = std::move(groups);
    }
    std::reverse(task.operands.begin(), task.operands.end());
  }

  // The smallest one, and the smallest that shares a proposition with it if there is one: their product.
  bool multiply(Task& task, std::size_t purse) {
    std::vector<Known>& waiting = task.waiting;
    std::stable_sort(waiting.begin(), waiting.end(),
                     [](const Known& a, const Known& b) { return a->weight() < b->weight(); });
    auto second = waiting.begin() + 1;
    if (!task.disjoint)
      second =
          std::find_if(second, waiting.end(), [&](const Known& b) { return share(*waiting.front(), *b); });
    if (second == waiting.end()) second = waiting.begin() + 1;
    Part &a = *waiting.front(), &b = **second;
    const bool minimal = task.by != By::One && !share(a, b) && told_apart(a) && told_apart(b);
    const Outcome outcome = within(purse, [&](Effort& effort) {
      Part part{product(a.automaton, b.automaton, verdict_of(task.by), effort), a.reads, {}};
      for (std::size_t v = 0; v < b.reads.size(); ++v)
        if (b.reads[v]) part.reads[v] = true;
      if (minimal) {
        part.automaton.initial = initial_class(part.automaton);
        part.told_apart = true;
      } else {
        part.automaton = minimize(part.automaton, effort);
      }
      return part;
    });
    if (!outcome.made) return false;
    waiting.erase(second);
    waiting.front() = outcome.made;
    return true;
  }

  struct Outcome {
    Known made;  // null: the purse or the states do not suffice
    std::size_t states = 0;
    bool out_of_states = false;
  };
  // Being stopped ends the translation.
  template <class Construction>
  Outcome within(std::size_t purse, const Construction& construction) {
    Effort effort(purse, limits_.states, limits_.stop);
    Outcome outcome;
    try {
      outcome.made = std::make_shared<Part>(construction(effort));
    } catch (const Effort::Spent& spent) {
      made_ = std::max(made_, effort.states());
      if (spent.reason == Effort::Spent::Reason::Stopped) throw;
      outcome.out_of_states = spent.reason == Effort::Spent::Reason::States;
      more_steps_may_help_ = more_steps_may_help_ || !outcome.out_of_states;
    }
    outcome.states = effort.states();
    return outcome;
  }

  std::size_t position(ltl::Proposition p) const {
    return static_cast<std::size_t>(std::lower_bound(reads_.begin(), reads_.end(), p) - reads_.begin());
  }

  const Reads& reads_;
  const RouteLimits& limits_;
  std::size_t& made_;
  std::unordered_map<Formula, Task> tasks_;
  bool more_steps_may_help_ = false;
};

}  // namespace

Transitions minimal_automaton(Formula f, const Reads& reads, const RouteLimits& limits, std::size_t& made) {
  return Translation(reads, limits, made).run(f);
}

}  // namespace waymark::automata
