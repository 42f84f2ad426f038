// A helper executable run to its end: text in, text out.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::tools {

struct Finished {
  int exit_code = 0;   // 128 + signal when it was killed
  std::string output;  // standard output; standard error goes where ours goes
};

// Throws std::system_error when the program cannot be started.
Finished run_helper(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                    std::string_view input);

// Sends the signal to the helper that runs, if one does: SIGKILL for the watcher of Ctrl-C, before it ends the process.
void signal_helper(int signal);

}  // namespace waymark::tools
