// Answers about maps: which there are, and one of them with its drawing.
#pragma once
#include "tools/shell/json.hpp"
#include "tools/studio/context.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {

tools::JsonObject list_maps(const Context& context);
tools::JsonObject show_map(const Request& request, const Context& context);
// The body is the file.
tools::JsonObject add_map(std::string_view file, const Context& context);

}  // namespace waymark::studio
