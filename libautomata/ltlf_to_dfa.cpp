#include "libautomata/ltlf_to_dfa.hpp"

#include <utility>

#include "libautomata/minimize.hpp"
#include "libautomata/residual.hpp"

namespace waymark::automata {
namespace {

struct Stopped {};  // thrown by the poll, caught below

// The leaves that the initial one reaches, closed under progression, as states.
Transitions close(ltl::Formula f, const std::vector<ltl::Proposition>& reads, const Residuals::Poll& poll) {
  Residuals residuals(f, reads, poll);
  std::vector<std::uint32_t> order{residuals.initial()}, number(residuals.leaves(), UINT32_MAX);
  number[residuals.initial()] = 0;
  std::vector<bool> visited;  // below a visited node every leaf is numbered already
  std::vector<Mtbdd::Node> stack, roots;
  for (std::size_t i = 0; i < order.size(); ++i) {
    poll(residuals.leaves());
    roots.push_back(residuals.successors(order[i]));
    number.resize(residuals.leaves(), UINT32_MAX);
    visited.resize(residuals.diagram().size(), false);
    stack.push_back(roots.back());
    while (!stack.empty()) {
      const Mtbdd::Node n = stack.back();
      stack.pop_back();
      if (Mtbdd::is_terminal(n)) {
        std::uint32_t& q = number[Mtbdd::payload(n)];
        if (q != UINT32_MAX) continue;
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

}  // namespace

std::variant<Dfa, Exhausted> ltlf_to_dfa(ltl::Formula f, const TranslationLimits& limits) {
  const std::vector<ltl::Proposition> reads = ltl::propositions(f);
  std::size_t made = 0;
  const auto poll = [&](std::size_t leaves) {
    made = leaves;
    if (leaves > limits.states || limits.stop.stop_requested()) throw Stopped{};
  };
  try {
    const Transitions closed = close(f, reads, poll);
    if (const std::optional<Transitions> minimal = minimize(closed, limits.stop))
      return as_dfa(canonical(*minimal), f.arena().vocabulary(), reads);
  } catch (const Stopped&) {
  }
  return Exhausted{made};
}

Dfa ltlf_to_dfa(ltl::Formula f) {
  return std::get<Dfa>(ltlf_to_dfa(f, TranslationLimits{.states = SIZE_MAX}));
}

}  // namespace waymark::automata
