// Route instructions paired with the trajectories that people took: the only supervision of the grounding parser.
//
// The first heading of a paragraph is unknown in the SAIL corpus. A Convention says what is put in its place; it
// stands beside every number we publish (docs/conventions.md 8).
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/world/map.hpp"

namespace waymark::parser {

enum class Convention : std::uint8_t {  // what is put in the place of an unknown heading
  Absolute,                             // the unknown heading is north (0)
  Relative,                             // the unknown heading is 90° left of the first known one
};
std::string_view name(Convention convention);  // "absolute", "relative"

struct Sentence {                    // one instruction
  std::string id, text;              // as the corpus has them
  std::vector<std::string> tokens;   // of the text
  bool heading_unknown = false;      // the source left the start heading open
  std::vector<plan::Pose> absolute;  // trajectory under either convention; equal when the heading is known
  std::vector<plan::Pose> relative;  // under the relative convention
  std::string formula;  // what it means, where that is known: for scores and for training with supervision alone
  std::vector<std::vector<plan::Pose>> also_good = {};  // further trajectories that it allows; headings known
  std::vector<std::vector<plan::Pose>> refused = {};    // trajectories that it does not allow; headings known

  // The trajectory under the convention.
  const std::vector<plan::Pose>& path(Convention c) const { return c == Convention::Absolute ? absolute : relative; }
};

struct Paragraph {                  // sentences that one person said of one route
  std::string id, map, text;        // as the corpus has them; the name of the map
  std::vector<Sentence> sentences;  // empty: nobody segmented it
};

struct Corpus {
  std::vector<Paragraph> paragraphs;  // in the order of the file
  std::vector<plan::Map> maps;        // those that came with it, may be empty
  std::uint64_t checksum = 0;         // FNV-1a of the instruction file as read

  std::size_t sentences() const;  // of all paragraphs
};

}  // namespace waymark::parser
