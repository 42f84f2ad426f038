// waymark-serve: the studio. `waymark serve` starts it and hands its own arguments on.
#include <array>

#include "tools/shell/program.hpp"

namespace waymark::tools {

Runner setup_serve(Command);

namespace {

constexpr std::array rows{Subcommand{"serve", serve_summary, setup_serve, "serve\nserve --port 8080"}};

}  // namespace
}  // namespace waymark::tools

int main(int argc, char** argv) {
  using namespace waymark::tools;
  std::ios::sync_with_stdio(false);
  return static_cast<int>(guarded([&] { return run_subcommand(rows, argc, argv); }));
}
