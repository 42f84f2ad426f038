// Commands and what they printed, as data/experiments and the tests keep them: lines "$ waymark …", the lines printed,
// "[exit N]". Lines that begin with # before a command are comments; "# slow" says that what follows takes long.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::tools {

struct TranscriptStep {
  std::size_t line = 0;                // of the command in the transcript, from 1
  std::vector<std::string> arguments;  // behind `waymark`, quotes removed
  std::string output;                  // file that standard output goes to; empty: it is printed
  std::vector<std::string> printed;    // lines
  int exit_code = 0;
  bool slow = false;
};

// Throws ltl::FormatError with the place.
std::vector<TranscriptStep> parse_transcript(std::string_view text, std::string_view source);

// Is `line` the one that was recorded? Runs of blanks are alike, MEASURED stands for any number, {MEASURED} for
// anything up to the next }.
bool agrees(std::string_view recorded, std::string_view line);

}  // namespace waymark::tools
