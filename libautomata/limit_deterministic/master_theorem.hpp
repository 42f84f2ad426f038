// Guesses by the master theorem: an entry of the accepting part for each choice of what holds for ever.
//
// For one formula per language that can be left, each advice gives a deterministic Büchi automaton: the minimal one of
// its safety formula, beside a round through the co-safe formulas that must hold again and again, each waited for in
// turn. Sound for MDPs: in an end component of the product almost all words share X and Y, which holds for ever there
// and so from every state of it on [SEJK16], [EKS20]; the argument asks nothing of the formula but its
// language, so one formula for each language will do. Beside each entry stands one whose weak untils wait for nothing
// (Advice::narrow): no jump is owed to it, but one that covers several entries may serve them all (assembly.hpp).
#pragma once
#include <optional>
#include <vector>

#include "libautomata/limit_deterministic/assembly.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

// parity: complete, deterministic, of φ. Adds entries to the accepting part, with jumps for each state of `parity`. reads[v] is
// the proposition of variable v of both. nullopt when there are too many choices; throws what the budget throws.
std::optional<std::vector<Jump>> jump_by_master_theorem(ltl::Formula f, const TransitionRelation& parity,
                                                        const std::vector<ltl::Proposition>& reads,
                                                        AcceptingPart& accepting_part, Budget& budget);

}  // namespace waymark::automata
