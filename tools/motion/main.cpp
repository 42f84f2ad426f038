// waymark-motion: a route on standard input, a motion along it on standard output (docs/formats/motion.md); or, with
// --planner ltl, a motion from where the route starts that satisfies --formula.
//
// A helper that `waymark move` starts, as git starts its subcommands: so that commands which move nothing never load
// OMPL. It certifies nothing; whoever reads its answer does.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <exception>
#include <iostream>

#include "libautomata/ltlf_to_dfa.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/parse.hpp"
#include "libplan/motion/explore.hpp"
#include "libplan/motion/realize.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/robot_options.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

struct Options {
  MapOptions map;
  RobotOptions robot;
  SearchOptions search;
  ShapeOptions shape;
  std::string formula = "true";
};

ExitCode answer(const plan::Motion& motion) {
  JsonObject json;
  json.add("motion", line_of(motion));
  add_robot(json, motion.robot);
  std::cout << json.text() << '\n';
  return ExitCode::Done;
}

ExitCode follow(const plan::Trajectory& route, const plan::Workspace& workspace, const Options& options) {
  const plan::Realization outcome =
      plan::realize(route, workspace,
                    {.iterations = options.search.iterations,
                     .seed = options.search.seed,
                     .robot = robot_of(options.robot),
                     .sampler = options.search.sampler == "bitstar" ? plan::Sampler::BitStar
                                                                    : plan::Sampler::InformedRrtStar});
  if (const auto* motion = std::get_if<plan::Motion>(&outcome)) return answer(*motion);
  const auto& unreached = std::get<plan::Unreached>(outcome);
  const plan::Map& map = workspace.map();
  complain("error", "no way found from " + show(map.pose(unreached.from)) + " to " +
                        show(map.pose(unreached.to)) + " in " + std::to_string(unreached.iterations) +
                        " iterations: allow more, or a smaller robot");
  return ExitCode::GaveUp;
}

ExitCode explore(plan::PoseId start, const plan::Workspace& workspace, const Options& options) {
  ltl::Arena arena(workspace.map().vocabulary());
  const auto dfa = automata::ltlf_to_dfa(ltl::parse(options.formula, arena));
  const plan::Explored outcome = plan::explore(
      dfa, workspace, start,
      {.seconds = options.search.seconds, .seed = options.search.seed, .robot = robot_of(options.robot)});
  if (const auto* motion = std::get_if<plan::Motion>(&outcome)) return answer(*motion);
  if (std::holds_alternative<plan::NoRun>(outcome)) return ExitCode::No;
  complain("error", "no motion found in " + fixed(options.search.seconds, 1) +
                        " seconds: allow more, or --planner route");
  return ExitCode::GaveUp;
}

ExitCode run(const Options& options) {
  const plan::Map map = read_map(options.map);
  const plan::Trajectory route = plan::parse_trajectory(read_file("-"), map, source_name("-"));
  const plan::Workspace workspace(map, {options.shape.width, options.shape.furniture});
  return options.search.planner == "ltl" ? explore(route.poses.front(), workspace, options)
                                         : follow(route, workspace, options);
}

ExitCode parse_and_run(int argc, char** argv) {
  Options options;
  CLI::App app{"waymark-motion: route on standard input → motion, by OMPL"};
  add_map_options(app, options.map);
  add_robot_options(app, options.robot);
  add_search_options(app, options.search);
  add_shape_options(app, options.shape);
  app.add_option("--formula", options.formula, "what the motion is to satisfy, with --planner ltl");
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
  } catch (const ltl::SyntaxError& error) {
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
