// waymark-farm: one rank of a farm. `waymark` becomes this program when mpirun has started it for a command whose work
// can be shared; its first argument is the path of `waymark`. The one program that links MPI.
#include <unistd.h>

#include <algorithm>
#include <boost/mpi/environment.hpp>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "tools/farm/farm.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/program.hpp"

namespace waymark::tools {
namespace {

volatile std::sig_atomic_t stopped = 0;
volatile std::sig_atomic_t exit_code = 0;

extern "C" void on_stop(int number) { stopped = number; }
// MPI_Finalize may wait for a rank that was killed.
extern "C" void on_alarm(int) { ::_exit(exit_code); }

void check_ranks(int ranks) {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* variable = std::getenv(name);
    if (variable != nullptr && std::string_view(variable) != std::to_string(ranks))
      throw UsageError(std::string(variable) + " ranks were started (" + name + "), but MPI knows of " +
                       std::to_string(ranks) + ": mpirun and waymark-farm are of different implementations of MPI");
  }
}

ExitCode run(const FarmCommand& command) {
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, on_stop);
  std::signal(SIGPIPE, SIG_IGN);
  const boost::mpi::communicator ranks;
  check_ranks(ranks.size());
  const std::vector<std::string>& given = command.arguments;
  const bool is_batch = given.front() == "translate" || given.front() == "ground";
  const auto is_kept = [](const std::string& argument) { return argument.starts_with("--checkpoints"); };
  if (!is_batch && std::none_of(given.begin(), given.end(), is_kept)) {
    if (ranks.rank() != 0) return ExitCode::Usage;
    throw UsageError("ranks share an experiment in its folder of checkpoints: give --checkpoints DIR");
  }
  return static_cast<ExitCode>(is_batch ? share_texts(command, ranks, stopped)
                                        : share_checkpoints(command, ranks, stopped));
}

}  // namespace
}  // namespace waymark::tools

int main(int argc, char** argv) {
  using namespace waymark::tools;
  if (argc < 2) {
    std::cerr << "error: waymark starts this program, people start waymark: mpirun -np 4 waymark translate -F FILE\n";
    return static_cast<int>(ExitCode::Usage);
  }
  const FarmCommand command{argv[0], {argv + 1, argv + argc}};
  std::signal(SIGALRM, on_alarm);
  {
    const boost::mpi::environment mpi(boost::mpi::threading::single, false);
    exit_code = static_cast<int>(guarded([&] { return run(command); }));
    ::alarm(5);
  }
  return exit_code;
}
