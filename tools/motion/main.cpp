// waymark-motion: a route on standard input, a motion along it on standard output (docs/formats/motion.md); or, with
// --planner ltl, a motion from where the route starts that satisfies --formula; or, with --workspace, a tour through
// polygons that does.
//
// A helper that `waymark move` starts, as git starts its subcommands: so that commands which move nothing never load
// OMPL. It certifies nothing; whoever reads its answer does.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <exception>
#include <iostream>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/motion/explore.hpp"
#include "libplan/motion/read_motion.hpp"
#include "libplan/motion/read_terrain.hpp"
#include "libplan/motion/realize.hpp"
#include "libplan/motion/realize_tour.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/robot_options.hpp"
#include "tools/shell/terminal.hpp"
#include "tools/shell/with_parent.hpp"

namespace waymark::tools {
namespace {

struct Options {
  MapOptions map;
  RobotOptions robot;
  SearchOptions search;
  ShapeOptions shape;
  std::string formula = "true";
  std::string workspace, start;  // of a tour
};

plan::Sampling sampling_of(const Options& options) {
  return {.iterations = options.search.iterations,
          .seed = options.search.seed,
          .robot = robot_of(options.robot),
          .sampler = options.search.sampler == "bitstar" ? plan::Sampler::BitStar : plan::Sampler::InformedRrtStar};
}

plan::Exploration exploration_of(const Options& options) {
  return {.seconds = options.search.seconds, .seed = options.search.seed, .robot = robot_of(options.robot)};
}

automata::Dfa automaton_of(const Options& options, ltl::Arena& arena) {
  return automata::ltlf_to_dfa(ltl::parse(options.formula, arena));
}

ExitCode answer(const plan::Motion& motion) {
  JsonObject json;
  json.add("motion", line_of(motion));
  add_robot(json, motion.robot);
  std::cout << json.text() << '\n';
  return ExitCode::Done;
}

ExitCode follow(const plan::Trajectory& route, const plan::Workspace& workspace, const Options& options) {
  const plan::Realization outcome = plan::realize(route, workspace, sampling_of(options));
  if (const auto* motion = std::get_if<plan::Motion>(&outcome)) return answer(*motion);
  const auto& unreached = std::get<plan::Unreached>(outcome);
  const plan::Map& map = workspace.map();
  complain("error", "no way found from " + show(map.pose(unreached.from)) + " to " + show(map.pose(unreached.to)) +
                        " in " + std::to_string(unreached.iterations) + " iterations: allow more, or a smaller robot");
  return ExitCode::GaveUp;
}

ExitCode answer(const plan::Explored& outcome) {
  if (const auto* motion = std::get_if<plan::Motion>(&outcome)) return answer(*motion);
  if (std::holds_alternative<plan::NoRun>(outcome)) return ExitCode::No;
  const double seconds = std::get<plan::OutOfTime>(outcome).seconds;
  complain("error", seconds > 0 ? "no motion found in " + fixed(seconds, 1) + " seconds: allow more, or --planner route"
                                : std::string("no motion found: the ways that would do look too narrow for the robot"));
  return ExitCode::GaveUp;
}

ExitCode tour(const Options& options) {
  const plan::Terrain terrain = plan::parse_terrain(read_file(options.workspace), source_name(options.workspace));
  const plan::Configuration start = plan::parse_configuration(options.start);
  ltl::Arena arena(terrain.vocabulary());
  const automata::Dfa dfa = automaton_of(options, arena);
  if (options.search.planner == "ltl") return answer(plan::explore(dfa, terrain, start, exploration_of(options)));
  const plan::TourOutcome outcome = plan::realize(dfa, terrain, start, sampling_of(options));
  if (const auto* motion = std::get_if<plan::Motion>(&outcome)) return answer(*motion);
  if (std::holds_alternative<plan::NoRun>(outcome)) return ExitCode::No;
  complain("error", "no way found along " + std::to_string(std::get<plan::NotFound>(outcome).attempts) +
                        " runs through the cells: allow more iterations, or a smaller robot");
  return ExitCode::GaveUp;
}

ExitCode run(const Options& options) {
  if (!options.workspace.empty()) return tour(options);
  const plan::Map map = read_map(options.map);
  const plan::Trajectory route = plan::parse_trajectory(read_file("-"), map, source_name("-"));
  const plan::Workspace workspace(map, {options.shape.width, options.shape.furniture});
  if (options.search.planner == "route") return follow(route, workspace, options);
  ltl::Arena arena(map.vocabulary());
  return answer(plan::explore(automaton_of(options, arena), workspace, route.poses.front(), exploration_of(options)));
}

ExitCode parse_and_run(int argc, char** argv) {
  Options options;
  CLI::App app{"waymark-motion: route on standard input → motion, by OMPL"};
  Command command(app);
  add_map_options(command, options.map);
  add_robot_options(command, options.robot);
  add_search_options(command, options.search);
  add_shape_options(command, options.shape);
  command.add_option("--formula", options.formula, "what the motion is to satisfy, with --planner ltl or --workspace");
  command.add_option("--workspace", options.workspace, "polygons to move through; standard input is not read then");
  command.add_option("--start", options.start, "x,y,heading in the workspace");
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

int main(int argc, char** argv) {
  waymark::tools::end_with_parent();
  return static_cast<int>(waymark::tools::guarded_main(argc, argv));
}
