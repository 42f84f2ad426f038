// A subcommand: options, setup, run. One file each; main.cpp and lab/main.cpp declare them and hold the tables.
//
// setup_x adds the options of x to its CLI11 command and returns what to run once they are parsed.
#pragma once
#include <functional>
#include <set>
#include <stop_token>
#include <string>

#include "tools/shell/command.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {

struct Session {         // what every subcommand is given
  std::stop_token stop;  // requested on Ctrl-C
  Terminal out;          // what standard output may show
  // A text for who keeps answers: the options that answers depend on, the checksums of the files that they name, and
  // the program. `without`: options that the answers that are kept do not depend on.
  std::function<std::string(const std::set<std::string>& without)> settings = {};
};

using Runner = std::function<ExitCode(const Session&)>;

struct Subcommand {  // a row in the table of a program
  const char* name;
  const char* summary;
  Runner (*setup)(Command);        // nullptr: another program runs it, and it is only listed here
  const char* examples = nullptr;  // two command lines, which close its help; without the name of the program
};

// What `waymark` and its helpers say of commands that the helpers run.
inline constexpr const char* serve_summary = "the studio, a page in the browser to see what formulas mean";
inline constexpr const char* serve_examples = "serve\nserve --port 8080";
inline constexpr const char* experiment_summary = "a whole table of results, which goes on where it was stopped";
inline constexpr const char* tune_summary = "which settings of training validate best";
inline constexpr const char* experiment_examples =
    "experiment feedback-cost --sentences 2 --candidates 4\n"
    "experiment compare-systems --corpus DIR --checkpoints DIR2 --json";
inline constexpr const char* tune_examples =
    "tune --corpus DIR --grid epochs=4,8\n"
    "tune --corpus DIR --grid rate=0.1,0.2 --json";
inline constexpr const char* generate_summary = "random maps to plan on";
inline constexpr const char* corpus_summary = "instructions with trajectories and formulas";

}  // namespace waymark::tools
