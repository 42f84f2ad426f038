// Set traces of navi [AZ13]: blocks of an id, properties, and pairs of a sentence and its trace.
#pragma once
#include <string_view>
#include <vector>

#include "libparser/corpus/import/released.hpp"

namespace waymark::parser {

// Places x (goal) and y (start) are put into `goal_place` and `start_place`. Comments (//) may stand anywhere.
struct SettrcParagraph {
  ReleasedParagraph paragraph;          // of the block
  int start_place = 0, goal_place = 0;  // as the block names them
};
std::vector<SettrcParagraph> parse_settrc(std::string_view text,
                                          std::string_view file);  // throws ltl::FormatError

}  // namespace waymark::parser
