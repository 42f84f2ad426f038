// What an answer of `plan` or `run` on a map claims, examined on the map: steps one by one, formulas by the definition
// of ⊨, least costs by progression. Neither an automaton nor the planner is used.
#pragma once
#include "libltl/limits.hpp"
#include "libplan/world/map.hpp"
#include "tools/claims.hpp"
#include "tools/shell/input.hpp"
#include "tools/verify_reading.hpp"

namespace waymark::tools {

// `limits` bounds the pairs of a pose and what remains of the formula. Throws ltl::FormatError for an answer that is
// none, ltl::SyntaxError for its formula.
void examine_on_map(Claims& claims, const plan::JsonReader& in, const Claims::Value& answer, const Text& text,
                    const plan::Map& map, TextReferee& texts, const ltl::Limits& limits);

}  // namespace waymark::tools
