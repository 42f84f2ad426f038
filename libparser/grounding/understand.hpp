// What a text means on a map: a route instruction read as a program, a command read as a formula, or neither.
//
// The reader of commands (lifted/) says how likely the text is a route instruction, a command, or nothing that was
// understood. Readings of both kinds share the probability; formulas that two readings have in common add up.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "libparser/ground.hpp"
#include "libparser/grounding/missing_name.hpp"

namespace waymark::parser {

struct Understanding {            // readings, or what was missing
  std::vector<Reading> readings;  // best first; empty: not understood
  double probability = 1;         // that the text was understood at all
  bool ongoing = false;           // the first reading speaks of what goes on for ever: read over infinite words
  std::vector<std::string> words_not_understood;  // of the text
  std::optional<MissingName> missing;             // of a text that was not understood
};

inline constexpr double least_understood = 0.65;  // refuses 95 % of texts that are no instructions

struct UnderstandOptions {                      // how texts are read
  GroundOptions ground = {.one_an_end = true};  // of route instructions
  double least = least_understood;              // probability of having understood below which there is no reading
};

Understanding understand(const Grounder& grounder, const std::string& text, const Executor& executor,
                         std::span<const plan::PoseId> starts, ltl::Arena& arena,
                         const UnderstandOptions& options = {});

}  // namespace waymark::parser
