// A subcommand: options, setup, run. One file each; main.cpp and lab/main.cpp hold the tables.
//
// setup_x adds the options of x to its CLI11 command and returns what to run once they are parsed.
#pragma once
#include <functional>
#include <stop_token>

#include "tools/shell/command.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {

struct Session {         // what every subcommand is given
  std::stop_token stop;  // requested on Ctrl-C
  Terminal out;          // what standard output may show
};

using Runner = std::function<ExitCode(const Session&)>;

struct Subcommand {  // a row in the table of a program
  const char* name;
  const char* summary;
  Runner (*setup)(Command);  // nullptr: another program runs it, and it is only listed here
};

Runner setup_run(Command command);
Runner setup_ground(Command command);
Runner setup_translate(Command command);
Runner setup_automaton(Command command);
Runner setup_compose(Command command);
Runner setup_plan(Command command);
Runner setup_check(Command command);
Runner setup_explain(Command command);
Runner setup_compare(Command command);
Runner setup_train(Command command);
Runner setup_evaluate(Command command);
Runner setup_import(Command command);
Runner setup_corpus(Command command);
Runner setup_move(Command command);
Runner setup_generate(Command command);
Runner setup_draw(Command command);
Runner setup_patterns(Command command);
Runner setup_random(Command command);
Runner setup_version(Command command);

// Of waymark-lab.
Runner setup_experiment(Command command);
Runner setup_tune(Command command);
Runner setup_generate_corpus(Command command);

// What both programs say of the commands of waymark-lab.
inline constexpr const char* experiment_summary =
    "a whole table of results, which goes on where it was stopped";
inline constexpr const char* tune_summary = "which settings of training validate best";
inline constexpr const char* generate_summary = "random maps to plan on";
inline constexpr const char* corpus_summary = "instructions with trajectories and formulas";

}  // namespace waymark::tools
