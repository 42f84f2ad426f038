// Models in the language of PRISM [KNP11], as far as docs/formats/prism.md says.
//
// An mdp or a dtmc of modules that synchronise on their actions; constants, formulas, labels, rewards; bounded whole
// numbers and truth values; guarded commands with probabilistic updates. Labels become propositions, rewards become
// costs: the structure named "cost" or "steps", else the first; 1 a choice when there is none. A state in which no
// command is enabled gets a choice that stays, "stay", as in PRISM.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "libltl/limits.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/model/prism/prism_model.hpp"

namespace waymark::plan {

inline constexpr std::size_t most_model_states = 50'000'000;  // beyond so many a text is refused

struct PrismOptions {        // of reading a model
  PrismConstants constants;  // of those that the text gives no value
  std::string rewards;       // the structure that becomes costs; empty: as said above
};

// States are numbered breadth first, in the order of commands and updates. Throws ltl::SyntaxError with the place, also
// for what PRISM has and this reader has not, and for more states than the limit; ReadingStopped.
Mdp parse_prism(std::string_view text, std::string_view source = "",
                const ltl::Limits& limits = {.states = most_model_states}, const PrismOptions& options = {});

// The structure that becomes costs: the one asked for; else "cost" or "steps" before others, the first of equals.
// Throws the error of the text where there is none of the name.
std::optional<std::size_t> cost_structure(const PrismProgram& program, const std::string& wanted,
                                          const ModelText& text);

}  // namespace waymark::plan
