// Answers about moves that may slip: the value of every pose between proved bounds, and what a learner comes to.
#pragma once
#include "tools/shell/json.hpp"
#include "tools/studio/context.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {

tools::JsonObject value_poses(const Request& request, const Context& context);
// The product, in PRISM's language.
tools::JsonObject write_product(const Request& request, const Context& context);
tools::JsonObject learn_task(const Request& request, const Context& context);

}  // namespace waymark::studio
