// Answers about tasks on a map: an instruction read, a formula planned, and the picture of a plan. The objects are
// those of `waymark run`, `ground`, `plan` with --json.
#pragma once
#include "tools/shell/json.hpp"
#include "tools/studio/context.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {

tools::JsonObject run_instruction(const Request& request, const Context& context);
// Which words name things of the map, and what each symbol of the likeliest program attended to.
tools::JsonObject trace_words(const Request& request, const Context& context);
tools::JsonObject plan_formula(const Request& request, const Context& context);
tools::JsonObject draw_plan(const Request& request, const Context& context);

}  // namespace waymark::studio
