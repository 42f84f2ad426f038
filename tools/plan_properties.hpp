// waymark plan --model FILE --properties FILE: what properties of PRISM or JANI ask of a model, and whether the answers
// are those of their comments.
#pragma once
#include <string>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/model/formats/prism_properties.hpp"
#include "tools/plan_case.hpp"

namespace waymark::tools {

// Those of the file, and those of a text in the language of PRISM. JANI has them in the document of the model.
std::vector<plan::PrismProperty> read_properties(const CaseChoice& choice, const ltl::Limits& limits);
std::vector<plan::PrismProperty> properties_in(const CaseChoice& choice, const plan::PrismSource& text,
                                               const ltl::Limits& limits);

ExitCode plan_properties(const CaseChoice& choice, const Session& session);

}  // namespace waymark::tools
