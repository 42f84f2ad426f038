// waymark move: a formula and a map → a certified motion of a robot with a body.
//
// The route comes from the corridor (or from a file, or is left to OMPL's LTLPlanner), the motion from the helper
// waymark-motion, the certificate from here: the word of the motion's own geometry ⊨ φ, whatever the helper did.
#include <iostream>
#include <memory>

#include "libautomata/hoa/dot_finite.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/print.hpp"
#include "libplan/motion/read_motion.hpp"
#include "tools/answer.hpp"
#include "tools/render/motion_picture.hpp"
#include "tools/render/page.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/process.hpp"
#include "tools/shell/robot_options.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/tour.hpp"

namespace waymark::tools {
namespace {

struct MoveOptions {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, route, workspace, clearance = "centre", svg;
  RobotOptions robot;
  SearchOptions search;
  ShapeOptions shape;
  bool json = false;
};

bool is_wide(const plan::Robot& robot, double hallway) {
  const auto* disc = std::get_if<plan::Disc>(&robot);
  return disc != nullptr ? !(disc->radius < hallway / 2) : !(std::get<plan::Car>(robot).width < hallway);
}

plan::Workspace workspace_of(const plan::Map& map, const MoveOptions& options) {
  try {
    plan::Workspace workspace(map, {options.shape.width, options.shape.furniture});
    if (is_wide(robot_of(options.robot), workspace.width()))
      throw UsageError("a robot of that size is wider than the hallways");
    return workspace;
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

// The answer of waymark-motion; its messages, if any, are on standard error already.
Finished sample(const MoveOptions& options, const plan::Route& route, ltl::Formula formula, const plan::Map& map) {
  const auto program = needed_helper("waymark-motion", "finds motions by OMPL");
  std::vector<std::string> arguments = arguments_of(options.robot, options.search, options.shape);
  arguments.insert(arguments.end(), {"--map", options.map.map, "--data", data_directory(options.map.data).string(),
                                     "--formula", ltl::print(formula)});
  return run_helper(program, arguments, show(route, map) + '\n');
}

struct Moved {
  Answer answer;
  std::optional<plan::CertifiedMotion> motion = {};  // absent: no route, or none found along it
  double sample = 0, certify = 0;                    // seconds
};

JsonObject motion_json(const Moved& moved, const MoveOptions& options, const plan::Map& map) {
  const CorridorRun& corridor_run = moved.answer.corridor_run;
  JsonObject json;
  json.add("formula", ltl::print(*moved.answer.formula)).add("map", map.name());
  json.add("robot", options.robot.robot);
  add_robot(json, robot_of(options.robot));
  json.add("planner", options.search.planner);
  if (moved.motion)
    json.add("status", "solved")
        .add("route", json_of(moved.motion->route().route(), map))
        .add("motion", line_of(moved.motion->motion()))
        .add("length", plan::length(moved.motion->motion()))
        .add("certified", true)
        .add("certified_for", "centre");
  else if (const plan::Route* route = route_of(corridor_run))
    json.add("status", "exhausted").add("route", json_of(*route, map)).add("certified", false);
  else
    json.add("status", "infeasible").add("reason", std::get<plan::Infeasible>(corridor_run.destination).reason);
  const Seconds& s = corridor_run.seconds;
  return json.add("seconds", JsonObject()
                                 .add("load", s.load)
                                 .add("translate", s.translate)
                                 .add("compose", s.compose)
                                 .add("solve", s.solve)
                                 .add("certify", s.certify + moved.certify)
                                 .add("sample", moved.sample)
                                 .add("total", s.total() + moved.certify + moved.sample));
}

// The states of the automaton while the motion goes on: after the letter of the start, then after every action.
std::vector<render::Visit> visits_of(const plan::CertifiedMotion& motion, const automata::Dfa& dfa,
                                     const plan::Map& map) {
  std::vector<render::Visit> visits;
  automata::StateId q = dfa.initial();
  for (const ltl::Letter& letter : word_of(motion.route().route(), map)) {
    q = dfa.next(q, letter);
    visits.push_back({q.index, visits.empty() ? 0 : motion.times()[visits.size() - 1]});
  }
  return visits;
}

void draw_motion(const Moved& moved, const MoveOptions& options, const plan::Map& map, const automata::Dfa& dfa) {
  render::Page page{.map = &map};
  page.formula = ltl::print(*moved.answer.formula, ltl::Style::Unicode);
  page.caption = "map " + map.name();
  automata::DotOptions look;
  look.trap = automata::DotOptions::Trap::Omit;
  std::string left_out;
  page.automaton = render::lay_out_or_leave_out(automata::write_dot(dfa, look), {}, left_out);
  const AutomatonSize size = size_of(dfa);
  page.automaton_caption = counted(size.states, "state") + ", " + counted(size.edges, "edge");
  if (!page.automaton) complain("note", "the automaton is left out of the picture: " + left_out);
  if (moved.motion) {
    page.motion = moved.motion;
    const plan::Motion& motion = moved.motion->motion();
    page.caption +=
        ", motion of " + in_words(motion.robot) + ", length " + fixed(plan::length(motion), 2) + ", certified";
    if (page.automaton) render::light_up(*page.automaton, motion, visits_of(*moved.motion, dfa, map));
  }
  write_file(options.svg, render::draw_page(page));
}

void print(const Moved& moved, const MoveOptions& options, const Session& session, const plan::Map& map) {
  print(std::cout, session.out, moved.answer, map);
  const std::string label = session.out.paint(Paint::Bold, "motion       ");
  if (moved.motion)
    std::cout << label << "of " << in_words(robot_of(options.robot)) << ", "
              << counted(moved.motion->motion().configurations.size(), "configuration") << ", length "
              << fixed(plan::length(moved.motion->motion()), 2) << ", " << session.out.paint(Paint::Green, "certified")
              << " by definition for the centre, sampled in " << fixed(1000 * moved.sample, 1) << " ms\n";
}

// Fills in the motion along the route, if it is found; the verdict of the helper.
ExitCode move_along(const plan::Route& route, const MoveOptions& options, const plan::Workspace& workspace,
                    ltl::Formula formula, Moved& moved) {
  StopWatch watch;
  const Finished finished = sample(options, route, formula, workspace.map());
  moved.sample = watch.lap();
  const auto code = static_cast<ExitCode>(finished.exit_code);
  if (code == ExitCode::Done)
    moved.motion = plan::certify(plan::parse_motion(finished.output, "waymark-motion"), workspace, formula);
  moved.certify = watch.lap();
  return code;
}

// The route of the corridor, or the one given, which must satisfy the formula.
CorridorRun corridor_run_of(const MoveOptions& options, const plan::Map& map, const automata::Dfa& dfa,
                            ltl::Formula formula, const Session& session) {
  if (options.route.empty()) return run_corridor(map, dfa, formula, start_poses(options.start, map), session.stop);
  StopWatch watch;
  CorridorRun corridor_run{size_of(dfa), 0, 0, plan::Infeasible{}, {}};
  const plan::Route route =
      priced(plan::parse_trajectory(read_file(options.route), map, source_name(options.route)), map);
  if (ltl::holds(word_for(formula, route, map), formula))
    corridor_run.destination = CheckedRoute(certify(route, map, formula));
  else
    corridor_run.destination = plan::Infeasible{"the route given does not satisfy the formula"};
  corridor_run.seconds.certify = watch.lap();
  return corridor_run;
}

ExitCode run_move(const MoveOptions& options, const Session& session) {
  TextOptions text = options.text;
  if (text.arguments.empty() && text.file.empty() && !options.route.empty()) text.arguments = {"true"};
  TextReader texts(text, "formula");
  if (texts.is_batch()) throw UsageError("waymark move takes one formula, as an argument");
  const Text formula_text = texts.next().value();
  if (!options.workspace.empty())
    return run_tour({formula_text, options.notation, options.workspace, options.start, options.robot, options.search,
                     options.clearance, options.svg, options.json},
                    session);
  if (options.clearance == "body")
    throw UsageError("--clearance body goes with --workspace: on a map, letters are of the poses of the centre");
  StopWatch watch;
  const plan::Map map = read_map(options.map);
  const plan::Workspace workspace = workspace_of(map, options);
  const double load = watch.lap();
  ltl::Arena arena(map.vocabulary());
  const auto formula = parse_formula(formula_text, arena, parse_options(options.notation, ltl::Unknown::Reject));
  const automata::Dfa dfa = translate(formula, session.stop);
  const double translating = watch.lap();
  Moved moved{.answer = {.formula = formula, .corridor_run = corridor_run_of(options, map, dfa, formula, session)}};
  moved.answer.corridor_run.seconds.load = load;
  moved.answer.corridor_run.seconds.translate = translating;
  const plan::Route* route = route_of(moved.answer.corridor_run);
  const ExitCode code = route == nullptr ? ExitCode::No : move_along(*route, options, workspace, formula, moved);
  const bool answered = code == ExitCode::Done || code == ExitCode::No || code == ExitCode::GaveUp;
  if (!answered) return code;  // the helper has said why
  if (options.json)
    std::cout << motion_json(moved, options, map).text() << '\n';
  else
    print(moved, options, session, map);
  if (!options.svg.empty()) draw_motion(moved, options, map, dfa);
  return code;
}

}  // namespace

Runner setup_move(Command command) {
  const auto options = std::make_shared<MoveOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  command.add_option("--route", options->route, "move along this route, not along the plan of the formula")
      .type_name("FILE");
  command
      .add_option("--workspace", options->workspace,
                  "move through the polygons of this file, not on a map; --start is then a point of it")
      .type_name("FILE");
  command
      .add_option("--clearance", options->clearance,
                  "with --workspace: what keeps off regions that the formula avoids, the centre or the whole body")
      .one_of({"centre", "body"})
      .show_default();
  add_robot_options(command, options->robot);
  add_shape_options(command, options->shape);
  add_search_options(command, options->search);
  command.in("Output").add_flag("--json", options->json, "one JSON object");
  command.in("Output").add_option("--svg", options->svg, "draw the motion on the map").type_name("FILE");
  return [options](const Session& session) { return run_move(*options, session); };
}

}  // namespace waymark::tools
