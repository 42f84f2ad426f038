// A subcommand: options, setup, run. One file each; main.cpp holds the table.
//
// setup_x adds the options of x to its CLI11 command and returns what to run once they are parsed.
#pragma once
#include <functional>
#include <stop_token>

#include "tools/shell/exit_code.hpp"
#include "tools/shell/terminal.hpp"

namespace CLI {
class App;
}

namespace waymark::tools {

struct Session {         // what every subcommand is given
  std::stop_token stop;  // requested on Ctrl-C
  Terminal out;          // what standard output may show
};

using Runner = std::function<ExitCode(const Session&)>;

Runner setup_run(CLI::App& command);
Runner setup_ground(CLI::App& command);
Runner setup_translate(CLI::App& command);
Runner setup_automaton(CLI::App& command);
Runner setup_compose(CLI::App& command);
Runner setup_plan(CLI::App& command);
Runner setup_check(CLI::App& command);
Runner setup_compare(CLI::App& command);
Runner setup_train(CLI::App& command);
Runner setup_evaluate(CLI::App& command);
Runner setup_experiment(CLI::App& command);
Runner setup_tune(CLI::App& command);
Runner setup_import(CLI::App& command);
Runner setup_corpus(CLI::App& command);
Runner setup_move(CLI::App& command);
Runner setup_generate(CLI::App& command);
Runner setup_draw(CLI::App& command);
Runner setup_patterns(CLI::App& command);
Runner setup_random(CLI::App& command);
Runner setup_version(CLI::App& command);

}  // namespace waymark::tools
