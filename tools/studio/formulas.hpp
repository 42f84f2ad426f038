// Answers about formulas: as they are written, in English, by examples, and as automata in every format and drawn.
#pragma once
#include "tools/shell/json.hpp"
#include "tools/studio/context.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {

tools::JsonObject write_formula(const Request& request, const Context& context);
tools::JsonObject explain_formula(const Request& request, const Context& context);
tools::JsonObject translate_formula(const Request& request, const Context& context);
tools::JsonObject draw_automaton(const Request& request, const Context& context);

}  // namespace waymark::studio
