// A path formula over conditions on states, of PRISM or JANI, as a formula of ours over these conditions.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/model/prism/prism_program.hpp"

namespace waymark::plan {

// The formula in our syntax. Conditions join `labels` under the names that `name` gives them, quotes and line ends left
// out; queries are propositions of such names, and join nothing. "true" and "false" stand for themselves. Bounds on
// steps are numbers or X. Throws std::invalid_argument for what has no such formula: a temporal operator inside of an
// expression, W or R with bounds, a bound that is no whole number of steps; as the text of the expressions where a type
// is wrong.
std::string path_formula(PrismExpressions& expressions, PrismExpressions::Id path,
                         const std::function<std::string(PrismExpressions::Id)>& name,
                         std::vector<PrismProgram::Label>& labels);

// The text on one line and without quotes, so that it can stand between some.
std::string path_name(std::string_view text);

}  // namespace waymark::plan
