// A helper executable run to its end: text in, text out.
#pragma once
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::tools {

struct Finished {
  int exit_code = 0;   // 128 + signal when it was killed
  std::string output;  // standard output; standard error goes where ours goes
};

struct HelperStopped {};  // thrown: the helper was ended before its time

// Throws std::system_error when the program cannot be started. A requested stop ends the helper, and throws
// HelperStopped. Ctrl-C, which all processes of a terminal get, and SIGTERM leave it alone: it is ours to end.
Finished run_helper(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                    std::string_view input, const std::stop_token& stop = {});

// As run_helper without a stop, of a program that handles signals by itself.
Finished run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                     std::string_view input);

// Sends the signal to all helpers that run: SIGKILL for the watcher of Ctrl-C, before it ends the process.
void signal_helpers(int signal);

}  // namespace waymark::tools
