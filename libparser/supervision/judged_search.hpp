// The search for programs where trajectories were judged.
//
// Judgements tell programs apart that lead along one route, so the search can list more of them than
// constrained_search.hpp: the gold route need not be cut into plans of units. A prefix of a program stands for the set
// of positions of the gold route at which it can be done; a program is listed when it can be done at the end, its plan
// ends there, and no judged trajectory refutes it.
//   budget       a thing is the goal of no more steps, and the guard or condition of no more, than the sentence has
//                words for it; a wall ahead need not be mentioned; a side counts for literals of that side
//   steps        forward k; next and face of a turn, reach, advance, face, past and advance_k of a mentioned thing
//   guards       `without` and `keep` of a mentioned thing, of `reach`
//   conditions   where the sentence says "if"; "otherwise" tells `whether` from `when`
// Of these, those are kept that disagree least with the sentence: by the lexical-overlap penalty, by words that are not
// used, and little by directions, steps and things in another order.
#pragma once
#include <string>
#include <vector>

#include "libparser/model/program_language.hpp"
#include "libparser/supervision/judged.hpp"
#include "libparser/supervision/search.hpp"

namespace waymark::parser {

// At most `most`. `language`: of the temporal dialect. None of a route of more than 63 actions.
std::vector<Consistent> judged_programs(const Executor& executor, const ProgramLanguage& language,
                                        const GoldRoute& gold, const std::vector<std::string>& tokens,
                                        const Judged& judged, std::size_t most = 100);

}  // namespace waymark::parser
