// waymark-motion: a route on standard input, a motion along it on standard output (docs/formats/motion.md).
//
// A helper that `waymark move` starts, as git starts its subcommands: so that commands which move nothing never load
// OMPL. It is told no formula and certifies nothing; whoever reads its answer does.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <exception>
#include <iostream>

#include "libltl/diagnostic.hpp"
#include "libplan/motion/realize.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

struct Options {
  MapOptions map;
  plan::WorkspaceShape shape;
  plan::Sampling sampling;
};

JsonObject json_of(const plan::Motion& motion) {
  JsonArray line;
  for (const plan::Configuration& c : motion.configurations)
    line.add(JsonArray().add(c.x).add(c.y).add(c.heading));
  return JsonObject().add("motion", line).add("radius", motion.radius);
}

ExitCode run(const Options& options) {
  const plan::Map map = read_map(options.map);
  const plan::Trajectory route = plan::parse_trajectory(read_file("-"), map, source_name("-"));
  const plan::Workspace workspace(map, options.shape);
  const plan::Realization outcome = plan::realize(route, workspace, options.sampling);
  if (const auto* unreached = std::get_if<plan::Unreached>(&outcome)) {
    complain("error", "no way found from " + show(map.pose(unreached->from)) + " to " +
                          show(map.pose(unreached->to)) + " in " + std::to_string(unreached->iterations) +
                          " iterations: allow more, or a smaller robot");
    return ExitCode::GaveUp;
  }
  std::cout << json_of(std::get<plan::Motion>(outcome)).text() << '\n';
  return ExitCode::Done;
}

ExitCode parse_and_run(int argc, char** argv) {
  Options options;
  CLI::App app{"waymark-motion: route on standard input → motion, sampled by OMPL"};
  add_map_options(app, options.map);
  app.add_option("--width", options.shape.width, "of hallways, where neighbouring places are 1 apart")
      ->capture_default_str();
  app.add_option("--furniture", options.shape.furniture, "radius of every piece")->capture_default_str();
  app.add_option("--radius", options.sampling.radius, "of the robot; 0: a point")->capture_default_str();
  app.add_option("--iterations", options.sampling.iterations, "for each leg")->capture_default_str();
  app.add_option("--seed", options.sampling.seed, "of the sampling")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help, std::cout, std::cerr);
    return ExitCode::Done;
  } catch (const CLI::ParseError& error) {
    complain("error", error.what());
    return ExitCode::Usage;
  }
  return run(options);
}

ExitCode guarded_main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const ltl::FormatError& error) {
    complain("error", error.what());
    return ExitCode::BadInput;
  } catch (const std::invalid_argument& error) {  // a shape or radius that fits nowhere
    complain("error", error.what());
    return ExitCode::BadInput;
  } catch (const std::exception& error) {
    complain("error", std::string("this is a bug in waymark: ") + error.what());
    return ExitCode::OurBug;
  }
}

}  // namespace
}  // namespace waymark::tools

int main(int argc, char** argv) { return static_cast<int>(waymark::tools::guarded_main(argc, argv)); }
