// waymark-lab: experiments. `waymark` starts it for the commands of this table and hands its own arguments on.
#include <array>

#include "tools/shell/program.hpp"

namespace waymark::tools {

Runner setup_experiment(Command);
Runner setup_tune(Command);
Runner setup_generate_corpus(Command);

namespace {

constexpr std::array rows{
    Subcommand{"experiment", experiment_summary, setup_experiment, experiment_examples},
    Subcommand{"tune", tune_summary, setup_tune, tune_examples},
    Subcommand{"generate", generate_summary, setup_generate_corpus},
};

}  // namespace
}  // namespace waymark::tools

int main(int argc, char** argv) {
  using namespace waymark::tools;
  std::ios::sync_with_stdio(false);
  return static_cast<int>(guarded([&] { return run_subcommand(rows, argc, argv); }));
}
