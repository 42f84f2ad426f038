// Scores as a line of counts, to be kept and read again without loss.
#pragma once
#include <string>

#include "libparser/experiment/evaluate.hpp"

namespace waymark::parser {

std::string text_of(const Scores& scores);  // a line of counts
// Throws ltl::FormatError naming the source when it is no such line.
Scores scores_of(const std::string& line, const std::string& source);

}  // namespace waymark::parser
