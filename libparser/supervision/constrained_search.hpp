// The search for programs of the temporal dialect, guided by what the sentence mentions.
//
// That something was avoided, kept or asked about leaves few traces in a trajectory: far too many programs lead along it.
// Only those are listed that are made of what the sentence mentions, unit by unit along the gold route:
//   literals     here, ahead, to the left or right; where several programs say as much, those with fewer directions first
//   steps        forward k; next, reach, advance, advance_k, past and face of a thing that is mentioned, or of a wall ahead
//   guards       `without` and `keep` of a thing that is mentioned, where the route would be another one without them
//   conditions   where the sentence says "if": of a thing that is mentioned; what they do not let happen is any step of the
//                kind above. "otherwise" tells `whether` from `when`
// "if" and "otherwise" are words that are given, like the lexicon. No formula is looked at.
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
std::vector<Consistent> said_programs(const Executor& executor, const ProgramLanguage& language,
                                      const GoldRoute& gold, const std::vector<std::string>& tokens,
                                      UnitPlans& plans, std::size_t most = 100);

}  // namespace waymark::parser
