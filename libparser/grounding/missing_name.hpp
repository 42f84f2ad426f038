// The words of a text that was not understood which would be understood if they named something.
//
//   "go to the coffee machine", read with "coffee machine" as a place that is not there, is a command: so it is the
//   name that is missing. Each span of up to three words is tried.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "libparser/lifted/lifted_reader.hpp"
#include "libparser/mention/mention.hpp"

namespace waymark::parser {

struct MissingName {
  std::string words;                 // "coffee machine"
  std::vector<std::string> nearest;  // names of things in like words, the nearest first; three at most
};

// None where no span helps. O(words of the text) readings.
std::optional<MissingName> missing_name(const LiftedReader& reader, const LiftedText& text,
                                        const std::vector<NamedThing>& things);

}  // namespace waymark::parser
