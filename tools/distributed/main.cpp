// waymark-distributed: planning cases among the ranks of mpirun. `waymark` becomes this program there. The one program
// that links PETSc.
#include <array>
#include <ios>

#include "tools/distributed/ranks.hpp"
#include "tools/shell/program.hpp"

namespace waymark::tools {

Runner setup_shared_plan(Command);

namespace {

constexpr std::array rows{
    Subcommand{"plan", "a planning case → values between proved bounds, by all ranks of mpirun", setup_shared_plan,
               "plan --case FILE --task seq --json\n"
               "plan --case FILE --checkpoints DIR --checkpoint-seconds 10"},
};

}  // namespace
}  // namespace waymark::tools

// A wrong command line is wrong at every rank: rank 0 says so.
int main(int argc, char** argv) {
  using namespace waymark::tools;
  std::ios::sync_with_stdio(false);
  const PetscLife life;
  return static_cast<int>(guarded([&] {
    try {
      return run_subcommand(rows, argc, argv);
    } catch (const UsageError&) {
      if (Ranks().rank() != 0) return ExitCode::Usage;
      throw;
    }
  }));
}
