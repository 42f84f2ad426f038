#include "tools/verify_order.hpp"

#include <algorithm>
#include <cmath>

#include "tools/shell/json.hpp"
#include "tools/walk_referee.hpp"

namespace waymark::tools {

void examine_order(Claims& claims, const std::string& order, const ToldLasso& lasso, const plan::PlanningCase& model,
                   ltl::Formula formula, const ltl::Limits& limits) {
  using plan::LassoOrder;
  const LassoOrder of = order == "prefix"  ? LassoOrder::Prefix
                        : order == "cycle" ? LassoOrder::Cycle
                                           : LassoOrder::Mean;
  const std::string rounds = "rounds is " + Json(lasso.rounds).text();
  if (of != LassoOrder::Mean)
    claims.add(lasso.rounds == 1, rounds);
  else if (const auto possible = rounds_on(lasso.word, formula, limits))
    claims.add(possible->contains(static_cast<std::uint64_t>(std::max(0.0, lasso.rounds))) &&
                   lasso.rounds == std::floor(lasso.rounds) && lasso.rounds >= 1,
               rounds);
  else
    claims.add(std::nullopt, rounds);
  LassoRank rank{lasso.prefix_cost, lasso.cycle_cost};
  if (of == LassoOrder::Cycle) rank = {lasso.cycle_cost, lasso.prefix_cost};
  if (of == LassoOrder::Mean) rank = {lasso.cycle_cost / lasso.rounds, lasso.prefix_cost};
  const bool is_rank = lasso.rounds >= 1;
  claims.add(is_rank ? comes_first(model, formula, of, rank, limits) : std::optional(false),
             "no other walk comes first in the order \"" + order + '"');
}

}  // namespace waymark::tools
