// What the comment "RESULT: …" before a property of PRISM says.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "libplan/model/prism/prism_program.hpp"

namespace waymark::plan {

// "RESULT: value" or "RESULT (N=2,K=4): value" among the comments before a property: the value of the first that is
// about these constants.
std::optional<std::string> result_before(std::string_view comments, const PrismConstants& constants);

// Does the comment say that the property is an error? "Error:range" says which, and is taken for any.
inline bool expects_error(const std::string& result) { return result.starts_with("Error"); }

// Does the value agree with what a RESULT comment says: a number, a fraction, Infinity, true or false? Numbers agree
// up to a relative difference of 10⁻⁵, PRISM's own measure, or an absolute one of 10⁻⁷. nullopt: the comment says
// something else.
std::optional<bool> agrees(const std::string& result, double value, std::optional<bool> verdict,
                           std::optional<double> range = {});

}  // namespace waymark::plan
