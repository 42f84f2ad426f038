#include "tools/verify_value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "libltl/structure/fragment.hpp"
#include "tools/shell/json.hpp"
#include "tools/walk_referee.hpp"

namespace waymark::tools {
namespace {

struct OfQuery {
  std::string_view query, words;
  Optimum optimum, opposite;  // of a safe formula: of its negation, from 1
};
constexpr std::array of_queries{
    OfQuery{"pmax", "the greatest probability", Optimum::GreatestProbability, Optimum::LeastProbability},
    OfQuery{"pmin", "the least probability", Optimum::LeastProbability, Optimum::GreatestProbability},
    OfQuery{"rmin", "the least expected cost", Optimum::LeastCost, Optimum::LeastCost},
    OfQuery{"rmax", "the greatest expected cost", Optimum::GreatestCost, Optimum::GreatestCost},
    OfQuery{"steps", "the least cost", Optimum::LeastCost, Optimum::LeastCost}};

const OfQuery* find(std::string_view query) {
  const auto* known =
      std::find_if(of_queries.begin(), of_queries.end(), [&](const auto& q) { return q.query == query; });
  return known == of_queries.end() ? nullptr : known;
}

}  // namespace

std::string_view value_in_words(std::string_view query) {
  const OfQuery* known = find(query);
  return known == nullptr ? std::string_view() : known->words;
}

std::optional<Judged> judge(const plan::PlanningCase& model, ltl::Formula formula, ltl::Semantics semantics,
                            std::string_view query, const ltl::Limits& limits) {
  if (ltl::has_past(formula)) return std::nullopt;
  const ltl::Fragments known = ltl::fragments(formula, ltl::Semantics::Infinite);
  const bool negated = semantics == ltl::Semantics::Infinite && !known.cosafety;
  if (negated && (!known.safety || query[0] != 'p')) return std::nullopt;
  auto product = product_by_progression(model, negated ? ltl::negate(formula) : formula, semantics, limits);
  if (!product) return std::nullopt;
  return Judged{std::move(*product), negated};
}

Bracket bracket_of(const Judged& judged, std::string_view query, const std::stop_token& stop) {
  if (query == "steps") {
    const double least = least_cost(judged.product);
    return {least, least};
  }
  const OfQuery& known = *find(query);
  if (!judged.negated) return bracket(judged.product, known.optimum, stop);
  const Bracket found = bracket(judged.product, known.opposite, stop);
  return {1 - found.above, 1 - found.below};
}

std::optional<bool> is_possible(const plan::PlanningCase& model, ltl::Formula formula, ltl::Semantics semantics,
                                std::string_view query, const ltl::Limits& limits) {
  const bool by_chance = query == "pmax" || query == "discounted";
  const auto judged = judge(model, formula, semantics, by_chance ? "pmax" : query, limits);
  if (!judged) {
    const bool none = by_chance && semantics == ltl::Semantics::Infinite && has_walk(model, formula, limits) == false;
    return none ? std::optional(false) : std::nullopt;
  }
  const std::vector<bool>& goal = judged->product.goal;
  if (by_chance && !judged->negated) return std::find(goal.begin(), goal.end(), true) != goal.end();
  if (by_chance)
    return std::isinf(bracket(judged->product, Optimum::GreatestCost, limits.stop).below);  // may be missed
  const Bracket found = bracket_of(*judged, "rmin", limits.stop);
  if (std::isinf(found.below)) return false;
  return std::isfinite(found.above) ? std::optional(true) : std::nullopt;
}

void compare(Claims& claims, const std::string& what, double lower, double upper, const Bracket& found) {
  const auto slack = [](double a) { return std::isinf(a) ? 0 : 1e-6 * std::max(1.0, std::abs(a)); };
  const auto decided = [&](bool proved, bool disproved) {
    return proved ? std::optional(true) : disproved ? std::optional(false) : std::nullopt;
  };
  const double low = lower - slack(lower), high = upper + slack(upper);
  claims.add(decided(found.below >= low, found.above < low),
             what + " is at least " + Json(lower).text() + ", up to 10⁻⁶");
  if (std::isfinite(upper))
    claims.add(decided(found.above <= high, found.below > high),
               what + " is at most " + Json(upper).text() + ", up to 10⁻⁶");
}

}  // namespace waymark::tools
