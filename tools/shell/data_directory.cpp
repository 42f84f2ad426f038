#include "tools/shell/data_directory.hpp"

#include <cstdlib>

#include "libltl/diagnostic.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::tools {

namespace fs = std::filesystem;

fs::path executable() { return fs::read_symlink("/proc/self/exe"); }

namespace {

// share/waymark beside bin/, where waymark stands, or beside libexec/, where its helpers stand in a folder of their
// own.
fs::path shipped_data() {
  const fs::path above = executable().parent_path().parent_path();
  return (above.filename() == "libexec" ? above.parent_path() : above) / "share" / "waymark";
}

}  // namespace

fs::path data_directory(const std::string& option) {
  const char* variable = std::getenv("WAYMARK_DATA");
  const bool from_variable = option.empty() && variable != nullptr && *variable != '\0';
  const fs::path directory = !option.empty() ? fs::path(option) : from_variable ? fs::path(variable) : shipped_data();
  std::error_code ignored;
  if (fs::is_directory(directory, ignored)) return directory;
  const std::string_view origin = !option.empty() ? "--data"
                                  : from_variable ? "the environment variable WAYMARK_DATA"
                                                  : "the place of the executable";
  throw ltl::FormatError(directory.string(), 0, 0, "no data directory here (named by " + std::string(origin) + ")");
}

fs::path helper(std::string_view name) {
  const fs::path here = executable().parent_path();
  for (const fs::path& candidate : {here / name, here.parent_path() / "libexec" / "waymark" / name}) {
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) return candidate;
  }
  return {};
}

fs::path needed_helper(std::string_view name, std::string_view what_it_does) {
  fs::path program = helper(name);
  if (program.empty())
    throw UsageError(std::string(name) + ", which " + std::string(what_it_does) +
                     ", is not built; to build it: ./dev setup motion pictures studio tests && ./dev build release");
  return program;
}

}  // namespace waymark::tools
