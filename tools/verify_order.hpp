// That a lasso comes first in its order, as an answer claims.
#pragma once
#include <string>

#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libltl/word.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "tools/claims.hpp"

namespace waymark::tools {

struct ToldLasso {
  double prefix_cost = 0, cycle_cost = 0, rounds = 1;
  ltl::Lasso word;
};
// The order must be one that there is.
void examine_order(Claims& claims, const std::string& order, const ToldLasso& lasso, const plan::PlanningCase& model,
                   ltl::Formula formula, const ltl::Limits& limits);

}  // namespace waymark::tools
