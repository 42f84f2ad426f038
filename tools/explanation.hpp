// What a formula means: in English, by the name of its pattern, its class in the hierarchy, and by examples.
#pragma once
#include <optional>
#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libltl/meaning/semantics.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

// A word as letters and in English.
struct Example {
  std::string letters, english;
};

struct Explanation {
  std::string english;
  std::optional<std::string> pattern;
  std::string hierarchy;
  std::optional<Example> satisfying, violating;  // a shortest word; nullopt: there is none
};

// Thrown when a limit is met.
struct ExplanationLimit {};

// on_map: the vocabulary of the formula is that of a hallway map.
Explanation explain(ltl::Formula f, ltl::Semantics semantics, bool on_map, const ltl::Limits& limits);
JsonObject json_of(const Explanation& explanation, const std::string& formula, ltl::Semantics semantics);

}  // namespace waymark::tools
