// What shells and manuals know of the command line: completions for bash, zsh and fish, and a manual page for each
// subcommand, all made from the definitions that the parser of the command line uses.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tools/shell/command.hpp"

namespace waymark::tools {

struct CommandText {
  std::string name, summary;
  std::vector<OptionText> options;
  std::vector<std::string> examples;  // whole command lines
};

// Writes bash/waymark, zsh/_waymark, fish/waymark.fish, man1/waymark.1 and man1/waymark-NAME.1 below the folder. Throws
// ltl::FormatError when a file cannot be written.
void write_shell_files(std::span<const CommandText> commands, const std::filesystem::path& folder);

}  // namespace waymark::tools
