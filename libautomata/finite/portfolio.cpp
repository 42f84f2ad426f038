#include "libautomata/finite/portfolio.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "libautomata/finite/disjoint.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/finite/residual.hpp"
#include "libltl/structure/fragment.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Op;
using Reads = std::vector<ltl::Proposition>;

// What one construction may spend in a round. Settled on the sets of LTLf in docs/performance.md.
struct Rounds {
  std::size_t first_steps = 1U << 12U;  // under a millisecond
  std::size_t growth = 4;               // from round to round
  std::size_t direct_share = 8;         // of a round's steps for the direct construction, where a product is possible
  std::size_t next(std::size_t steps) const { return steps > SIZE_MAX / growth ? SIZE_MAX : growth * steps; }
};
constexpr Rounds rounds;

Transitions closed(Formula f, const Reads& reads, Budget& budget) {
  Residuals residuals(f, reads, budget);
  std::vector<std::uint32_t> leaves;
  return close(residuals, ltl::Semantics::Finite, leaves, budget);
}

std::size_t position(ltl::Proposition p, const Reads& reads) {
  return static_cast<std::size_t>(std::lower_bound(reads.begin(), reads.end(), p) - reads.begin());
}

bool is_propositional(Formula f) { return ltl::fragments(f, ltl::Semantics::Finite).propositional; }

// φ as a Boolean function of smaller formulas: verdicts of products, folded over the operands. Without temporal
// operators φ is one diagram, and stays whole.
struct Decomposition {
  std::vector<Formula> operands;
  enum class By : std::uint8_t { Both, Either, One } by;
};
std::optional<Decomposition> decompose(Formula f) {
  using By = Decomposition::By;
  const bool negated = f.op() == Op::Not;
  const Formula g = negated ? f[0] : f;
  if ((g.op() != Op::And && g.op() != Op::Or && g.op() != Op::Iff) || is_propositional(f)) return std::nullopt;
  std::vector<Formula> operands(g.operands().begin(), g.operands().end());
  if (g.op() == Op::Iff) {  // φ ↔ ψ = φ ⊕ ¬ψ: the empty word stays out
    if (!negated) operands[1] = ltl::negate(operands[1]);
    return Decomposition{operands, By::One};
  }
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

// Operands that share propositions, directly or through others, joined to one formula each; so are those without
// temporal operators. In the order of their propositions, for disjoint_product().
std::vector<Formula> disjoint_groups(const Decomposition& parts, const Reads& reads) {
  std::vector<std::size_t> group(parts.operands.size());
  std::vector<std::size_t> reader(reads.size() + 1, SIZE_MAX);  // by proposition; of no time but the present
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  const auto join = [&](std::size_t& first, std::size_t i) {
    if (first == SIZE_MAX) first = i;
    const std::size_t one = find(first), other = find(i);
    group[std::max(one, other)] = std::min(one, other);
  };
  for (std::size_t i = 0; i < parts.operands.size(); ++i) {
    for (const ltl::Proposition p : ltl::propositions(parts.operands[i])) join(reader[position(p, reads)], i);
    if (is_propositional(parts.operands[i])) join(reader.back(), i);
  }
  std::vector<std::vector<Formula>> members(parts.operands.size());
  for (std::size_t i = 0; i < parts.operands.size(); ++i) members[find(i)].push_back(parts.operands[i]);
  std::vector<std::pair<std::size_t, Formula>> groups;  // with the place of the first proposition
  for (const std::vector<Formula>& some : members) {
    if (some.empty()) continue;
    ltl::Arena& arena = some[0].arena();
    const Formula joined =
        parts.by == Decomposition::By::Both ? ltl::conjunction(arena, some) : ltl::disjunction(arena, some);
    const Reads asked = ltl::propositions(joined);
    groups.emplace_back(asked.empty() ? reads.size() : position(asked.front(), reads), joined);
  }
  std::sort(groups.begin(), groups.end());
  std::vector<Formula> out;
  for (const auto& [first, joined] : groups) out.push_back(joined);
  return out;
}

// A minimal automaton on its way into products.
struct Factor {
  Transitions automaton;
  std::vector<bool> reads;                     // by variable: may depend on it
  std::optional<AtEachLength> at_each_length;  // none: not looked at yet
  std::size_t weight() const { return automaton.roots.size() + automaton.diagram.size(); }
};
using Known = std::shared_ptr<Factor>;

bool share(const Factor& a, const Factor& b) {
  for (std::size_t v = 0; v < a.reads.size(); ++v)
    if (a.reads[v] && b.reads[v]) return true;
  return false;
}

// All variables of a stand above those of b.
bool is_above(const Factor& a, const Factor& b) {
  const auto last = std::find(a.reads.rbegin(), a.reads.rend(), true).base();
  const auto first = std::find(b.reads.begin(), b.reads.end(), true);
  return last - a.reads.begin() <= first - b.reads.begin();
}

AtEachLength properties(const Factor& factor, Budget& budget) {
  return factor.at_each_length ? *factor.at_each_length : at_each_length(factor.automaton, budget);
}

// The factors share no proposition, and their properties are known. The verdict is "both" or "either".
Factor disjoint_factor(const Factor& a, const Factor& b, Verdict verdict, Budget& budget) {
  Factor out;
  const AtEachLength first = *a.at_each_length, second = *b.at_each_length;
  const AtEachLength common{first.told_apart && second.told_apart, first.reached && second.reached,
                            first.own_roots && second.own_roots};
  if (common.told_apart && common.reached && common.own_roots && is_above(a, b)) {
    out.automaton = disjoint_product(a.automaton, b.automaton, verdict, budget);
  } else {
    const Alphabets alphabets = common.own_roots ? Alphabets::Disjoint : Alphabets::Any;
    out.automaton = product(a.automaton, b.automaton, verdict, budget, alphabets);
  }
  if (common.told_apart) {
    merge_initial(out.automaton, budget);
    out.at_each_length = common;
  } else {
    out.automaton = minimize(out.automaton, budget);
  }
  return out;
}

class Translation {
 public:
  Translation(const Reads& reads, const ltl::Limits& limits, std::size_t& made)
      : reads_(reads), limits_(limits), made_(made) {}

  Transitions run(Formula f) { return std::move(settle(f)->automaton); }

 private:
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

  // What the result cannot do without: in rounds, until it is there. Throws when no step more would help.
  Known settle(Formula f) {
    const bool elsewhere = more_steps_may_help_;
    for (std::size_t step_budget = rounds.first_steps;; step_budget = rounds.next(step_budget)) {
      more_steps_may_help_ = false;
      if (Known found = attempt(f, step_budget, true)) {
        more_steps_may_help_ = elsewhere;
        return found;
      }
      if (!more_steps_may_help_) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    }
  }

  // One round. Of what cannot be done without, a route that is the last one has all the steps that it takes.
  Known attempt(Formula f, std::size_t step_budget, bool is_needed) {
    Task& task = tasks_[f];
    if (!task.found && !task.direct_is_hopeless) direct(f, task, step_budget);
    if (!task.found) open(f, task);
    if (!task.found && !task.direct_is_hopeless && !task.composable && is_needed) direct(f, task, SIZE_MAX);
    if (!task.found && task.composable && compose(task, step_budget, is_needed && task.direct_is_hopeless))
      task.found = std::exchange(task.waiting, {}).front();
    return task.found;
  }

  void direct(Formula f, Task& task, std::size_t step_budget) {
    const auto construct = [&](Budget& budget) {
      Factor factor{minimize(closed(f, reads_, budget), budget), std::vector<bool>(reads_.size(), false), {}};
      for (const ltl::Proposition p : ltl::propositions(f)) factor.reads[position(p, reads_)] = true;
      return factor;
    };
    const Outcome outcome = within(task.composable ? step_budget / rounds.direct_share : step_budget, construct);
    task.found = outcome.made;
    const bool beaten = task.composable && task.operands.empty() && outcome.states > task.most_pairs;
    task.direct_is_hopeless = outcome.out_of_states || beaten;
  }

  // One automaton in task.waiting, or false.
  bool compose(Task& task, std::size_t step_budget, bool is_needed) {
    for (; !task.operands.empty(); task.operands.pop_back()) {
      const Formula next = task.operands.back();
      const Known operand = is_needed ? settle(next) : attempt(next, step_budget, false);
      if (!operand) return false;
      const std::size_t states = operand->automaton.roots.size();
      task.most_pairs = task.most_pairs > SIZE_MAX / states ? SIZE_MAX : task.most_pairs * states;
      task.waiting.push_back(operand);
    }
    while (task.waiting.size() > 1) {
      if (multiply(task, is_needed ? SIZE_MAX : step_budget)) continue;
      if (is_needed) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
      return false;
    }
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
      task.direct_is_hopeless = task.direct_is_hopeless || task.disjoint;
    }
    std::reverse(task.operands.begin(), task.operands.end());
  }

  bool multiply(Task& task, std::size_t step_budget) {
    const auto [first, second] = task.disjoint ? neighbours(task.waiting) : relatives(task.waiting);
    Factor &a = *task.waiting[first], &b = *task.waiting[second];
    const Outcome outcome = within(step_budget, [&](Budget& budget) {
      Factor factor;
      if (task.disjoint) {
        a.at_each_length = properties(a, budget);
        b.at_each_length = properties(b, budget);
        factor = disjoint_factor(a, b, verdict_of(task.by), budget);
      } else {
        factor.automaton = minimize(product(a.automaton, b.automaton, verdict_of(task.by), budget), budget);
      }
      factor.reads = a.reads;
      for (std::size_t v = 0; v < b.reads.size(); ++v)
        if (b.reads[v]) factor.reads[v] = true;
      return factor;
    });
    if (outcome.out_of_states) task.composable = false;  // nor would it be the next time
    if (!outcome.made) return false;
    task.waiting[first] = outcome.made;
    task.waiting.erase(task.waiting.begin() + static_cast<std::ptrdiff_t>(second));
    return true;
  }

  using Places = std::pair<std::size_t, std::size_t>;  // ascending

  // Two that follow each other, of least weight.
  static Places neighbours(const std::vector<Known>& waiting) {
    std::size_t best = 0, least = SIZE_MAX;
    for (std::size_t i = 0; i + 1 < waiting.size(); ++i) {
      const std::size_t weight = waiting[i]->weight() + waiting[i + 1]->weight();
      if (weight >= least) continue;
      least = weight;
      best = i;
    }
    return {best, best + 1};
  }

  // The one of least weight, and of those that share a proposition with it, if there are any, the one of least weight.
  static Places relatives(const std::vector<Known>& waiting) {
    const auto lighter = [&](std::size_t i, std::size_t j) { return waiting[i]->weight() < waiting[j]->weight(); };
    std::size_t first = 0;
    for (std::size_t i = 1; i < waiting.size(); ++i)
      if (lighter(i, first)) first = i;
    std::optional<std::size_t> second;
    bool sharing = false;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (i == first) continue;
      const bool shares = share(*waiting[first], *waiting[i]);
      if (second && (sharing > shares || (sharing == shares && !lighter(i, *second)))) continue;
      second = i;
      sharing = shares;
    }
    return std::minmax(first, *second);
  }

  struct Outcome {
    Known made;  // null: the step_budget or the states do not suffice
    std::size_t states = 0;
    bool out_of_states = false;
  };
  // Being stopped ends the translation.
  template <class Construction>
  Outcome within(std::size_t step_budget, const Construction& construction) {
    Budget budget(step_budget, limits_.states, limits_.stop);
    Outcome outcome;
    try {
      outcome.made = std::make_shared<Factor>(construction(budget));
    } catch (const Budget::Exceeded& spent) {
      made_ = std::max(made_, budget.states());
      if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
      outcome.out_of_states = spent.reason == Budget::Exceeded::Reason::States;
      more_steps_may_help_ = more_steps_may_help_ || !outcome.out_of_states;
    }
    outcome.states = budget.states();
    return outcome;
  }

  const Reads& reads_;
  const ltl::Limits& limits_;
  std::size_t& made_;
  std::unordered_map<Formula, Task> tasks_;
  bool more_steps_may_help_ = false;
};

}  // namespace

Transitions minimal_automaton(Formula f, const Reads& reads, const ltl::Limits& limits, std::size_t& made) {
  return Translation(reads, limits, made).run(f);
}

}  // namespace waymark::automata
