// The lexically constrained search for programs of the temporal dialect.
//
// A trajectory shows little of what was avoided, kept or asked about: far too many programs lead along it. The search
// lists only programs that are made of what the sentence mentions, unit by unit along the gold route:
//   literals     here, ahead, to the left or right; of several programs that say as much, those with fewer directions
//   steps        forward k; next, reach, advance, advance_k, past and face of a mentioned thing or of a wall ahead
//   guards       `without` and `keep` of a mentioned thing, where the route would be another one without them
//   conditions   where the sentence says "if": of a mentioned thing; the step that they prevent is any of the above.
//                "otherwise" tells `whether` from `when`
// The words "if" and "otherwise" are given, like the lexicon. The search reads no formula.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "libparser/model/program_language.hpp"
#include "libparser/supervision/search.hpp"

namespace waymark::parser {

// Plans of units by where they start: many sentences ask for the same. Of one map, for one thread.
using UnitPlans = std::map<std::pair<plan::PoseId, Program>, std::optional<Plan>>;

// Those that disagree least with the sentence, at most `most`. `language`: of the temporal dialect.
std::vector<Consistent> said_programs(const Executor& executor, const ProgramLanguage& language, const GoldRoute& gold,
                                      const std::vector<std::string>& tokens, UnitPlans& plans, std::size_t most = 100);

}  // namespace waymark::parser
