#include "tools/lab/rerun.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stop_token>
#include <system_error>

#include "libparser/model/whole_file.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/process.hpp"
#include "tools/shell/terminal.hpp"
#include "tools/shell/transcript.hpp"

namespace waymark::tools {
namespace {

namespace fs = std::filesystem;

class WorkFolder {  // a new one, where the process then is
 public:
  WorkFolder() { fs::current_path(folder_.path()); }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder() {
    std::error_code ignored;
    fs::current_path(before_, ignored);
  }

 private:
  fs::path before_ = fs::current_path();
  parser::TemporaryFolder folder_{"waymark-experiment-"};
};

// Built, waymark lies beside this program; installed, the one is in libexec/waymark and the other in bin.
fs::path waymark() {
  const fs::path folder = executable().parent_path();
  for (const fs::path& path : std::array{folder / "waymark", folder / "../../bin/waymark"})
    if (fs::exists(path)) return path;
  throw UsageError("there is no waymark beside " + executable().string());
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

class Rerun {
 public:
  Rerun(const RerunOptions& options, const Session& session)
      : options_(options),
        session_(session),
        transcript_(data_directory(options.data) / "experiments" / (options.name + ".transcript")),
        steps_(parse_transcript(read_file(transcript_.string()), transcript_.string())) {}

  ExitCode run() {
    const WorkFolder folder;
    for (const TranscriptStep& step : steps_) {
      if (options_.fast && step.slow) break;
      repeat(step);
    }
    if (!options_.check) return ExitCode::Done;
    std::cout << (differ_ == 0 ? "all " + std::to_string(same_) + " lines agree"
                               : std::to_string(same_) + " lines agree, " + std::to_string(differ_) + " differ")
              << "; " << fixed(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count(), 1)
              << " s\n";
    return differ_ == 0 ? ExitCode::Done : ExitCode::No;
  }

 private:
  void repeat(const TranscriptStep& step) {
    const std::stop_callback ended(session_.stop, [] { signal_helpers(SIGTERM); });  // it has helpers of its own
    const Finished finished = run_program(waymark_, step.arguments, "");
    if (session_.stop.stop_requested()) throw Interrupted();
    if (!step.output.empty()) write_file(step.output, finished.output);
    const std::vector<std::string> now = step.output.empty() ? lines_of(finished.output) : std::vector<std::string>();
    if (!options_.check) {
      for (const std::string& line : now) std::cout << line << '\n';
      std::cout.flush();
      return;
    }
    compare(step.line, step.printed, now);
    const auto code = [](int number) { return "[exit " + std::to_string(number) + ']'; };
    const std::size_t last = step.line + step.printed.size();
    compare(last, {code(step.exit_code)}, {code(finished.exit_code)});
  }
  void compare(std::size_t before, const std::vector<std::string>& printed, const std::vector<std::string>& now) {
    for (std::size_t i = 0; i < std::max(printed.size(), now.size()); ++i) {
      if (i < printed.size() && i < now.size() && agrees(printed[i], now[i])) {
        ++same_;
        continue;
      }
      ++differ_;
      std::cout << transcript_.filename().string() << ':' << before + 1 + i << '\n'
                << "  said  " << (i < printed.size() ? printed[i] : "nothing") << '\n'
                << "  now   " << (i < now.size() ? now[i] : "nothing") << std::endl;
    }
  }

  const RerunOptions& options_;
  const Session& session_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  fs::path waymark_ = waymark(), transcript_;
  std::vector<TranscriptStep> steps_;
  std::size_t same_ = 0, differ_ = 0;
};

}  // namespace

void add_rerun_options(Command command, RerunOptions& options) {
  command.add_flag("--check", options.check,
                   "make again what was recorded, and say which lines differ: exit code 10 when one does");
  command.add_flag("--fast", options.fast, "with --check: only what takes a minute or so");
}

ExitCode rerun(const RerunOptions& options, const Session& session) { return Rerun(options, session).run(); }

}  // namespace waymark::tools
