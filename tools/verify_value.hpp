// Values that answers claim of a formula on a model, judged by progression (progression_values.hpp).
#pragma once
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "tools/claims.hpp"
#include "tools/progression_values.hpp"

namespace waymark::tools {

// "the greatest probability" of pmax; empty where no value is judged.
std::string_view value_in_words(std::string_view query);

struct Judged {
  ProgressionProduct product;
  bool negated = false;  // of a safe formula over infinite words: that of its negation
};
// Nothing: progression does not settle the formula, or a limit was met.
std::optional<Judged> judge(const plan::PlanningCase& model, ltl::Formula formula, ltl::Semantics semantics,
                            std::string_view query, const ltl::Limits& limits);
// Of pmax, pmin, rmin, rmax, and of steps where every choice has one outcome.
Bracket bracket_of(const Judged& judged, std::string_view query, const std::stop_token& stop);

// Can the formula be met as the query asks: with a chance (pmax, discounted) or surely (rmin, steps)? Nothing: not
// decided.
std::optional<bool> is_possible(const plan::PlanningCase& model, ltl::Formula formula, ltl::Semantics semantics,
                                std::string_view query, const ltl::Limits& limits);

// Both bounds of a claim, up to 10⁻⁶.
void compare(Claims& claims, const std::string& what, double lower, double upper, const Bracket& found);

}  // namespace waymark::tools
