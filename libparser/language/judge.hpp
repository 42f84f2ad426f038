// Trajectories that a sentence of our own does not allow, and further ones that it does.
//
// They are what a person can walk or show without knowing formulas: the good route stopped early; one action left out,
// put in or exchanged; a turn there and back; a few steps aside and back; the way to any place, or to the end by way of
// any place; for good ones, also the route from another start. The program that was meant judges them. Of these, those
// are taken that tell the meant program apart from the others that the search for programs finds, the one that refutes
// most of the rest first.
#pragma once
#include <cstddef>

#include "libparser/supervision/judged_search.hpp"

namespace waymark::parser {

struct JudgedLimits {
  std::size_t refused = 0, also_good = 0;  // how many of each kind
};

// Of a sentence whose meant program has the plan `gold` on the executor's map. Fewer where there are no more walks.
Judged judged_trajectories(const Executor& executor, const ProgramLanguage& language, const GoldRoute& gold,
                           const Program& meant, const std::vector<std::string>& tokens, const JudgedLimits& limits);

}  // namespace waymark::parser
