// Why nothing satisfies a formula, as answers say it: the conjuncts that they name are examined, and what they drop.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "tools/claims.hpp"

namespace waymark::tools {

struct ReasonReferee {
  std::vector<std::string> heads;                                // of the sentence: "no walk without end satisfies "
  std::function<std::optional<bool>(ltl::Formula)> is_possible;  // nothing: not decided
  std::function<std::vector<std::string>(ltl::Formula)> never_seen;
  const ltl::Limits& limits;
};

// A sentence of another form was not examined.
void examine_reason(Claims& claims, const std::string& reason, ltl::Formula formula, const ReasonReferee& referee);

// The fewest conjuncts without which the rest can be met.
void examine_dropped(Claims& claims, const std::vector<std::string>& dropped, ltl::Formula formula,
                     const ReasonReferee& referee);

}  // namespace waymark::tools
