// Jumps by the master theorem: one entry of the accepting part for each choice of what holds for ever.
//
// Each residual language has one formula. For this formula, each advice gives a deterministic Büchi automaton: the
// minimal automaton of its safety formula, in parallel with a round through the co-safe formulas that must hold
// infinitely often, each waited for in turn. Sound for MDPs: in an end component of the product, almost all words share
// X and Y, which hold for ever there and hence from each of its states on [SEJK16], [EKS20]. The proof uses only the
// language of the formula, so one formula for each language suffices. Beside each entry stands one without the waiting
// of weak untils (Advice::narrow): no jump needs this entry, but it may replace several entries at once (assembly.hpp).
#pragma once
#include <optional>
#include <vector>

#include "libautomata/limit_deterministic/assembly.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

// parity: complete, deterministic, of φ. Adds entries to the accepting part, with jumps for each state of `parity`.
// reads[v] is the proposition of variable v of both. nullopt when there are too many choices; throws what the budget
// throws.
std::optional<std::vector<Jump>> jump_by_master_theorem(ltl::Formula f, const TransitionRelation& parity,
                                                        const std::vector<ltl::Proposition>& reads,
                                                        AcceptingPart& accepting_part, Budget& budget);

}  // namespace waymark::automata
