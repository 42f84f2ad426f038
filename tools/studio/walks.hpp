// Answers about trajectories: what each letter leaves of a formula, and whether the trajectory satisfies it.
#pragma once
#include "tools/shell/json.hpp"
#include "tools/studio/context.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {

tools::JsonObject check_walk(const Request& request, const Context& context);

}  // namespace waymark::studio
