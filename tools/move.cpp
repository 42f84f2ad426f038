// waymark move: a formula and a map → a certified motion of a robot with a body.
//
// The route comes from the corridor, the motion from the helper waymark-motion, the certificate from here: the word
// of the motion's own geometry ⊨ φ, whatever the helper did.
#include <CLI/App.hpp>
#include <iostream>
#include <memory>

#include "libltl/print.hpp"
#include "libplan/motion/read_motion.hpp"
#include "tools/answer.hpp"
#include "tools/render/page.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/process.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, svg, robot = "disc";
  double radius = 0.05;
  plan::WorkspaceShape shape;
  std::size_t iterations = 1'000;
  std::uint64_t seed = 1;
  bool json = false;
};

double radius_of(const Options& options) {
  if (options.robot == "car")
    throw UsageError("--robot car is not there yet: a car cannot turn in place; there are point and disc");
  return options.robot == "point" ? 0 : options.radius;
}

plan::Workspace workspace_of(const plan::Map& map, const Options& options) {
  try {
    plan::Workspace workspace(map, options.shape);
    if (!(radius_of(options) < workspace.width() / 2))
      throw UsageError("a robot of that radius is wider than the hallways");
    return workspace;
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

// The answer of waymark-motion; its messages, if any, are on standard error already.
Finished sample(const Options& options, const plan::Route& route, const plan::Map& map) {
  const auto program = helper("waymark-motion");
  if (program.empty()) throw UsageError("the helper waymark-motion, which links OMPL, is not installed");
  const auto text = [](double value) { return Json(value).text(); };
  return run_helper(program,
                    {"--map", options.map.map, "--data", data_directory(options.map.data).string(), "--width",
                     text(options.shape.width), "--furniture", text(options.shape.furniture), "--radius",
                     text(radius_of(options)), "--iterations", std::to_string(options.iterations), "--seed",
                     std::to_string(options.seed)},
                    show(route, map) + '\n');
}

struct Moved {
  Answer answer;
  std::optional<plan::CertifiedMotion> motion = {};  // absent: no route, or none found along it
  double sample = 0, certify = 0;                    // seconds
};

JsonArray json_of(const plan::Motion& motion) {
  JsonArray line;
  for (const plan::Configuration& c : motion.configurations)
    line.add(JsonArray().add(c.x).add(c.y).add(c.heading));
  return line;
}

JsonArray json_of(const plan::Route& route, const plan::Map& map) {
  JsonArray poses;
  for (const plan::PoseId id : route.poses) {
    const plan::Pose pose = map.pose(id);
    poses.add(JsonArray().add(pose.x).add(pose.y).add(pose.heading));
  }
  return poses;
}

JsonObject json_of(const Moved& moved, const Options& options, const plan::Map& map) {
  const Journey& journey = moved.answer.journey;
  JsonObject json;
  json.add("formula", ltl::print(*moved.answer.formula)).add("map", map.name());
  json.add("robot", options.robot).add("radius", radius_of(options));
  if (moved.motion)
    json.add("status", "solved")
        .add("route", json_of(moved.motion->route().route(), map))
        .add("motion", json_of(moved.motion->motion()))
        .add("length", plan::length(moved.motion->motion()))
        .add("certified", true);
  else if (const plan::Route* route = route_of(journey))
    json.add("status", "exhausted").add("route", json_of(*route, map)).add("certified", false);
  else
    json.add("status", "infeasible").add("reason", std::get<plan::Infeasible>(journey.destination).reason);
  const Seconds& s = journey.seconds;
  return json.add("seconds", JsonObject()
                                 .add("load", s.load)
                                 .add("translate", s.translate)
                                 .add("compose", s.compose)
                                 .add("solve", s.solve)
                                 .add("certify", s.certify + moved.certify)
                                 .add("sample", moved.sample)
                                 .add("total", s.total() + moved.certify + moved.sample));
}

std::string in_words(const Options& options) {
  return options.robot == "point" ? "a point" : "a disc of radius " + fixed(options.radius, 2);
}

void draw(const Moved& moved, const Options& options, const plan::Map& map) {
  render::Page page{.map = &map};
  page.formula = ltl::print(*moved.answer.formula, ltl::Style::Unicode);
  page.caption = "map " + map.name();
  if (moved.motion) {
    page.motion = moved.motion->motion();
    page.caption += ", motion of " + in_words(options) + ", length " + fixed(plan::length(*page.motion), 2) +
                    ", certified";
  }
  write_file(options.svg, render::draw_page(page));
}

void print(const Moved& moved, const Options& options, const Session& session, const plan::Map& map) {
  print(std::cout, session.out, moved.answer, map);
  const std::string label = session.out.paint(Paint::Bold, "motion       ");
  if (moved.motion)
    std::cout << label << "of " << in_words(options) << ", "
              << counted(moved.motion->motion().configurations.size(), "configuration") << ", length "
              << fixed(plan::length(moved.motion->motion()), 2) << ", "
              << session.out.paint(Paint::Green, "certified") << " by definition, sampled in "
              << fixed(1000 * moved.sample, 1) << " ms\n";
}

// Fills in the motion along the route, if it is found; the verdict of the helper.
ExitCode move_along(const plan::Route& route, const Options& options, const plan::Workspace& workspace,
                    ltl::Formula formula, Moved& moved) {
  StopWatch watch;
  const Finished finished = sample(options, route, workspace.map());
  moved.sample = watch.lap();
  const auto code = static_cast<ExitCode>(finished.exit_code);
  if (code == ExitCode::Done)
    moved.motion = plan::certify(plan::parse_motion(finished.output, "waymark-motion"), workspace, formula);
  moved.certify = watch.lap();
  return code;
}

ExitCode run_move(const Options& options, const Session& session) {
  TextReader texts(options.text, "formula");
  if (texts.is_batch()) throw UsageError("waymark move takes one formula, as an argument");
  StopWatch watch;
  const plan::Map map = read_map(options.map);
  const plan::Workspace workspace = workspace_of(map, options);
  const auto starts = start_poses(options.start, map);
  const double load = watch.lap();
  ltl::Arena arena(map.vocabulary());
  const auto formula =
      parse_formula(texts.next().value(), arena, parse_options(options.notation, ltl::Unknown::Reject));
  const automata::Dfa dfa = translate(formula, session.stop);
  const double translating = watch.lap();
  Moved moved{.answer = {.formula = formula, .journey = travel(map, dfa, formula, starts, session.stop)}};
  moved.answer.journey.seconds.load = load;
  moved.answer.journey.seconds.translate = translating;
  const plan::Route* route = route_of(moved.answer.journey);
  const ExitCode code =
      route == nullptr ? ExitCode::No : move_along(*route, options, workspace, formula, moved);
  const bool answered = code == ExitCode::Done || code == ExitCode::No || code == ExitCode::GaveUp;
  if (!answered) return code;  // the helper has said why
  if (options.json)
    std::cout << json_of(moved, options, map).text() << '\n';
  else
    print(moved, options, session, map);
  if (!options.svg.empty()) draw(moved, options, map);
  return code;
}

}  // namespace

Runner setup_move(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  command.add_option("--robot", options->robot, "what moves")
      ->check(CLI::IsMember({"point", "disc", "car"}))
      ->capture_default_str();
  command.add_option("--radius", options->radius, "of the disc, where neighbouring places are 1 apart")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--width", options->shape.width, "of hallways")->capture_default_str();
  command.add_option("--furniture", options->shape.furniture, "radius of every piece; 0: none")
      ->capture_default_str();
  command.add_option("--iterations", options->iterations, "of sampling, for each leg that needs it")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000'000}))
      ->capture_default_str();
  command.add_option("--seed", options->seed, "of the sampling; the same seed gives the same motion")
      ->capture_default_str();
  command.add_flag("--json", options->json, "one JSON object");
  command.add_option("--svg", options->svg, "draw the motion on the map")->type_name("FILE");
  return [options](const Session& session) { return run_move(*options, session); };
}

}  // namespace waymark::tools
