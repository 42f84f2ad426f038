// waymark version: what this executable is.
#include <iostream>

#include "tools/shell/data_directory.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

Runner setup_version(Command) {
  return [](const Session&) {
    std::cout << "waymark " WAYMARK_VERSION " (" __VERSION__ ")\n";
    std::cout << "drawing of automata: " << (helper("waymark-layout").empty() ? "not built" : "waymark-layout") << '\n';
    return ExitCode::Done;
  };
}

}  // namespace waymark::tools
