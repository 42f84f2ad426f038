// waymark version: what this executable is.
#include <iostream>
#include <memory>

#include "tools/shell/data_directory.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

Runner setup_version(Command command) {
  const auto json = std::make_shared<bool>(false);
  command.add_flag("--json", *json, "one JSON object");
  return [json](const Session&) {
    if (*json) {
      JsonObject helpers;
      for (const char* name : {"waymark-lab", "waymark-layout", "waymark-motion", "waymark-serve"})
        helpers.add(name, !helper(name).empty());
      std::cout
          << JsonObject().add("version", WAYMARK_VERSION).add("compiler", __VERSION__).add("helpers", helpers).text()
          << '\n';
      return ExitCode::Done;
    }
    std::cout << "waymark " WAYMARK_VERSION " (" __VERSION__ ")\n";
    std::cout << "drawing of automata: " << (helper("waymark-layout").empty() ? "not built" : "waymark-layout") << '\n';
    return ExitCode::Done;
  };
}

}  // namespace waymark::tools
