// Models in the language of PRISM [KNP11], as far as grid worlds are written in it (docs/formats/prism.md).
//
// An mdp of one module; constants, formulas, labels, rewards; bounded whole numbers and truth values; guarded commands
// with probabilistic updates. Labels become propositions, rewards become costs: the structure named "cost" or "steps",
// else the first; 1 a choice when there is none. A state in which no command is enabled gets a choice that stays,
// "stay", as in PRISM.
#pragma once
#include <cstddef>
#include <stop_token>
#include <string_view>

#include "libltl/limits.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan {

struct ReadingStopped {};  // thrown

inline constexpr std::size_t most_model_states = 50'000'000;  // beyond so many a text is refused

// States are numbered breadth first, in the order of commands and updates. Throws ltl::SyntaxError with the place, also
// for what PRISM has and this reader has not, and for more states than the limit.
Mdp parse_prism(std::string_view text, std::string_view source = "",
                const ltl::Limits& limits = {.states = most_model_states});

}  // namespace waymark::plan
