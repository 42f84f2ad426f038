#include "libautomata/ltlf_to_dfa.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libautomata/effort.hpp"
#include "libautomata/minimize.hpp"
#include "libautomata/product.hpp"
#include "libautomata/residual.hpp"

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
      [](Mtbdd::Variable v) { return v; });
  for (std::uint32_t leaf : order) out.accepting.push_back(residuals.leaf(leaf).may_stop);
  return out;
}

// φ as a Boolean function of smaller formulas: verdicts of products, folded over the operands.
struct Decomposition {
  std::vector<Formula> operands;
  Verdict verdict;
};
std::optional<Decomposition> decompose(Formula f) {
  constexpr Verdict both = [](bool p, bool q) { return p && q; };
  constexpr Verdict either = [](bool p, bool q) { return p || q; };
  constexpr Verdict one = [](bool p, bool q) { return p != q; };
  const bool negated = f.op() == Op::Not;
  const Formula g = negated ? f[0] : f;
  std::vector<Formula> operands(g.operands().begin(), g.operands().end());
  if (g.op() == Op::Iff) {  // φ ↔ ψ = φ ⊕ ¬ψ: the empty word stays out
    if (!negated) operands[1] = ltl::negate(operands[1]);
    return Decomposition{operands, one};
  }
  if (g.op() != Op::And && g.op() != Op::Or) return std::nullopt;
  if (negated)
    for (Formula& operand : operands) operand = ltl::negate(operand);
  return Decomposition{operands, (g.op() == Op::And) != negated ? both : either};
}

// Two routes to the minimal automaton: directly, or from the minimal automata of the operands. Neither is always the
// better one, so each round gives both the same number of steps, and the next round four times as many: against the
// better route a small factor is lost.
class Translation {
 public:
  Translation(const Reads& reads, const TranslationLimits& limits) : reads_(reads), limits_(limits) {}

  Transitions run(Formula f) {
    for (std::size_t purse = first_purse;; purse = purse > SIZE_MAX / 4 ? SIZE_MAX : 4 * purse) {
      more_steps_may_help_ = false;
      std::size_t left = purse;
      if (std::optional<Transitions> found = attempt(f, left)) return *std::move(found);
      if (!more_steps_may_help_) throw Effort::Spent{Effort::Spent::Reason::States};
    }
  }
  std::size_t states() const { return states_; }

 private:
  static constexpr std::size_t first_purse = 1U << 18U;  // some tens of milliseconds

  // Half of the purse goes to the direct route where there is another one. What is spent is taken out.
  std::optional<Transitions> attempt(Formula f, std::size_t& purse) {
    const std::optional<Decomposition> parts = decompose(f);
    std::size_t half = parts ? purse / 2 : purse;
    purse -= half;
    const auto direct = [&](Effort& effort) { return minimize(close(f, reads_, effort), effort); };
    std::optional<Transitions> found = within(half, direct);
    purse += half;
    if (!found && parts) found = compose(*parts, purse);
    return found;
  }

  // Smallest first, every intermediate automaton minimised.
  std::optional<Transitions> compose(const Decomposition& parts, std::size_t& purse) {
    std::vector<Transitions> waiting;
    for (Formula operand : parts.operands) {
      std::optional<Transitions> part = attempt(operand, purse);
      if (!part) return std::nullopt;
      waiting.push_back(*std::move(part));
    }
    const auto larger = [](const Transitions& a, const Transitions& b) {
      return a.roots.size() > b.roots.size();
    };
    while (waiting.size() > 1) {
      std::stable_sort(waiting.begin(), waiting.end(), larger);
      const Transitions a = std::move(waiting.back());
      waiting.pop_back();
      const Transitions b = std::move(waiting.back());
      waiting.pop_back();
      const auto both = [&](Effort& effort) {
        return minimize(product(a, b, parts.verdict, effort), effort);
      };
      std::optional<Transitions> made = within(purse, both);
      if (!made) return std::nullopt;
      waiting.push_back(*std::move(made));
    }
    return std::move(waiting.front());
  }

  // nullopt when the purse or the states do not suffice; being stopped ends the translation.
  template <class Construction>
  std::optional<Transitions> within(std::size_t& purse, const Construction& construction) {
    Effort effort(purse, limits_.states, limits_.stop);
    std::optional<Transitions> made;
    try {
      made = construction(effort);
    } catch (const Effort::Spent& spent) {
      states_ = std::max(states_, effort.states());
      if (spent.reason == Effort::Spent::Reason::Stopped) throw;
      more_steps_may_help_ = more_steps_may_help_ || spent.reason == Effort::Spent::Reason::Steps;
    }
    purse = effort.steps_left();
    return made;
  }

  const Reads& reads_;
  const TranslationLimits& limits_;
  std::size_t states_ = 0;  // made by the construction that made most
  bool more_steps_may_help_ = false;
};

}  // namespace

std::variant<Dfa, Exhausted> ltlf_to_dfa(Formula f, const TranslationLimits& limits) {
  const Reads reads = ltl::propositions(f);
  if (reads.size() > Mtbdd::max_variables) return Exhausted{};
  Translation translation(reads, limits);
  try {
    return as_dfa(canonical(translation.run(f)), f.arena().vocabulary(), reads);
  } catch (const Effort::Spent&) {
    return Exhausted{translation.states()};
  }
}

Dfa ltlf_to_dfa(Formula f) {
  auto found = ltlf_to_dfa(f, TranslationLimits{.states = SIZE_MAX});
  if (Dfa* dfa = std::get_if<Dfa>(&found)) return std::move(*dfa);
  throw std::length_error("a formula with too many propositions or temporal operators for one automaton");
}

}  // namespace waymark::automata
