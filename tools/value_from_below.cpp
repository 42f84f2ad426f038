#include "tools/value_from_below.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/simplify.hpp"

namespace waymark::tools {
namespace {

template <class Model>
class Sweeps {
 public:
  Sweeps(const Model& model, FromBelow what, const ltl::Limits& limits) : model_(model), what_(what), limits_(limits) {}

  // The pairs that are reached; false: too many, or stopped.
  bool explore(ltl::Formula formula) {
    meet(model_.initial(), rest(formula, model_.initial_letter()));
    for (std::size_t at = 0; at < pairs_.size(); ++at) {
      if (pairs_.size() > limits_.states || limits_.stop.stop_requested()) return false;
      const auto [state, remains] = pairs_[at];
      Pair& row = rows_.emplace_back();
      const bool decided = remains.op() == ltl::Op::True || remains.op() == ltl::Op::False;
      for (std::uint32_t k = 0; !decided && k < model_.choices(state); ++k) {
        row.choices.push_back({model_.cost(state, k), {}});
        model_.for_each_outcome(state, k, [&, from = remains](std::uint32_t to, plan::LetterId letter, double p) {
          row.choices.back().outcomes.emplace_back(meet(to, rest(from, letter)), p);
        });
      }
      values_[at] = begin(remains);
    }
    return true;
  }

  double sweep_until(double enough) {
    constexpr int most = 1'000'000;
    for (int i = 0; i < most && values_[0] < enough && !limits_.stop.stop_requested(); ++i) {
      double change = 0;
      for (std::size_t at = 0; at < rows_.size(); ++at) {
        const double now = raised(rows_[at], values_[at]);
        if (now != values_[at]) change = std::max(change, std::isinf(now) ? 1 : now - values_[at]);
        values_[at] = now;
      }
      if (change < 1e-14) break;
    }
    return values_[0];
  }

 private:
  struct Choice {
    double cost;
    std::vector<std::pair<std::size_t, double>> outcomes;
  };
  struct Pair {
    std::vector<Choice> choices = {};
  };

  ltl::Formula rest(ltl::Formula formula, plan::LetterId letter) const {
    return ltl::simplify(ltl::progress(formula, model_.letters()[letter], ltl::Semantics::Infinite),
                         ltl::Over::Infinite);
  }

  std::size_t meet(std::uint32_t state, ltl::Formula remains) {
    const auto [at, fresh] = numbers_.emplace(std::pair(state, remains), pairs_.size());
    if (fresh) {
      pairs_.emplace_back(state, remains);
      values_.push_back(0);
    }
    return at->second;
  }

  double begin(ltl::Formula remains) const {
    if (what_ == FromBelow::LeastCost) return remains.op() == ltl::Op::False ? INFINITY : 0;
    return remains.op() == ltl::Op::True ? 1 : 0;
  }

  double raised(const Pair& pair, double before) const {
    if (pair.choices.empty()) return before;
    const bool greatest = what_ == FromBelow::GreatestProbability;
    double best = greatest ? 0 : INFINITY;
    for (const Choice& choice : pair.choices) {
      double value = what_ == FromBelow::LeastCost ? choice.cost : 0;
      for (const auto& [to, p] : choice.outcomes) value += p * values_[to];
      best = greatest ? std::max(best, value) : std::min(best, value);
    }
    return std::max(best, before);
  }

  const Model& model_;
  FromBelow what_;
  const ltl::Limits& limits_;
  std::map<std::pair<std::uint32_t, ltl::Formula>, std::size_t> numbers_;
  std::vector<std::pair<std::uint32_t, ltl::Formula>> pairs_;
  std::vector<Pair> rows_;
  std::vector<double> values_;
};

}  // namespace

std::optional<double> value_from_below(const plan::PlanningCase& model, ltl::Formula formula, FromBelow what,
                                       double enough, const ltl::Limits& limits) {
  return std::visit(
      [&](const auto& m) -> std::optional<double> {
        Sweeps sweeps(m, what, limits);
        if (!sweeps.explore(formula)) return std::nullopt;
        return sweeps.sweep_until(enough);
      },
      model.model);
}

}  // namespace waymark::tools
