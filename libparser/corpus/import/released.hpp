// A corpus as a release has it, before it is put into the shape of ours.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/world/hallways.hpp"

namespace waymark::parser {

struct Irregularity {
  std::string file;           // where it is
  std::size_t line = 0;       // from 1
  std::string kind, message;  // one word for the kind, and what is odd
};

struct ReleasedTrace {                   // where somebody walked
  std::vector<plan::Pose> poses;         // heading −1: left open
  std::vector<std::size_t> mislabelled;  // k: the action after pose k is another one than the poses say; sorted
};

struct ReleasedSentence {  // an instruction
  std::string id, text;    // id: "2-1", or empty where the release numbers nothing
  ReleasedTrace trace;     // of the sentence
  std::string file;        // where it stands
  std::size_t line = 0;    // from 1
};

struct ReleasedParagraph {                  // instructions for one route
  std::string id, map, text;                // id: the name of its file, without "Cleaned-" and ".txt"; map: lower case
  int number = 0;                           // of the source; 0: it has none
  std::string file;                         // where it stands
  std::size_t line = 0;                     // from 1
  std::optional<plan::Pose> start, goal;    // heading 0, for places
  std::vector<plan::Pose> path;             // of the whole paragraph; empty: the release has none
  std::vector<ReleasedSentence> sentences;  // in order
  std::map<std::string, std::string> properties;  // what a set trace says beyond map and places
  std::vector<Irregularity> noted;                // found while files were put together
};

struct ReleasedMap {       // a map
  std::string name, file;  // lower case
  // As the release has them.
  std::vector<plan::Node> nodes;
  std::vector<plan::Edge> edges;
  std::vector<std::string> objects, floors, walls;  // values used, sorted; nodes and edges point into them
};

// "[(3, 5, -1), (3, 5, 180)]" and "RIGHT(1,6,0);(1, 6, 90)". The text begins in that line, at a column that is not
// known, or at `column`. Throw ltl::FormatError.
std::vector<plan::Pose> parse_pose_list(std::string_view text, std::string_view file, std::size_t line);
ReleasedTrace parse_trace(std::string_view text, std::string_view file, std::size_t line, std::size_t column);

// "FORWARD", "LEFT" or "RIGHT": the one action that leads from a to b; empty: none does. Headings are known.
std::string_view action_between(const plan::Pose& a, const plan::Pose& b);

std::string lower(std::string text);  // A–Z alone

}  // namespace waymark::parser
