// What an answer of `plan --properties` claims of a property of PRISM or JANI.
#pragma once
#include "libltl/limits.hpp"
#include "tools/case_options.hpp"
#include "tools/claims.hpp"

namespace waymark::tools {

// `of`: the model, its constants, and the file of the properties; without one the property is read as the answer has
// it. Throws ltl::FormatError for an answer that is none.
void examine_property(Claims& claims, const plan::JsonReader& in, const CaseChoice& of, const ltl::Limits& limits);

}  // namespace waymark::tools
