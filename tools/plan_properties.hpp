// waymark plan --model FILE --properties FILE: what properties of PRISM or JANI ask of a model, and whether the answers
// are those of their comments.
#pragma once
#include "tools/plan_case.hpp"

namespace waymark::tools {

ExitCode plan_properties(const CaseChoice& choice, const Session& session);

}  // namespace waymark::tools
