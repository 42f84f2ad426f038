// Commands run by sh, as transcripts and the tutorial show them.
#pragma once
#include <filesystem>
#include <string>

namespace waymark::golden {

struct CommandResult {
  std::string output;  // both streams, ending in a line break if there is any; times are SECONDS, model sizes SIZE
  int exit = -1;       // −1: killed by a signal
};

// `waymark` is the program of this build; standard input is empty.
CommandResult run(const std::string& command, const std::filesystem::path& folder);

std::string read(const std::filesystem::path& file);  // empty when it cannot be read
// In a run with WAYMARK_GOLDEN=write the expected text is written anew, otherwise it is compared.
void compare(const std::filesystem::path& file, const std::string& expected, const std::string& now);

}  // namespace waymark::golden
