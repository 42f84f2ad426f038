#include "tools/tour.hpp"

#include <iostream>
#include <optional>

#include "libautomata/hoa/dot_finite.hpp"
#include "libltl/text/print.hpp"
#include "libplan/motion/clearance.hpp"
#include "libplan/motion/read_motion.hpp"
#include "libplan/motion/read_terrain.hpp"
#include "libplan/motion/tour.hpp"
#include "tools/answer.hpp"
#include "tools/render/terrain_picture.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

struct TourAnswer {
  ltl::Formula formula;
  std::string reason = {};                                            // of an infeasible task
  std::optional<plan::CertifiedTour> tour = {};                       // absent: infeasible, or none was found
  double load = 0, translate = 0, plan = 0, sample = 0, certify = 0;  // seconds
};

JsonArray letter_json(const ltl::Letter& letter, const ltl::Vocabulary& names) {
  JsonArray out;
  for (const ltl::Proposition p : letter.members()) out.add(names.name(p));
  return out;
}

JsonObject tour_json(const TourAnswer& answer, const TourRequest& request, const plan::Terrain& terrain) {
  JsonObject json;
  json.add("formula", ltl::print(answer.formula)).add("workspace", terrain.name());
  json.add("robot", request.robot.robot);
  add_robot(json, robot_of(request.robot));
  json.add("planner", request.search.planner);
  if (answer.tour) {
    JsonArray word;
    for (const ltl::Letter& letter : answer.tour->word().letters) word.add(letter_json(letter, terrain.vocabulary()));
    json.add("status", "solved")
        .add("word", word)
        .add("motion", line_of(answer.tour->motion()))
        .add("length", plan::length(answer.tour->motion()))
        .add("certified", true)
        .add("certified_for", request.clearance);
  } else if (answer.reason.empty()) {
    json.add("status", "exhausted").add("certified", false);
  } else {
    json.add("status", "infeasible").add("reason", answer.reason);
  }
  return json.add("seconds",
                  JsonObject()
                      .add("load", answer.load)
                      .add("translate", answer.translate)
                      .add("plan", answer.plan)
                      .add("sample", answer.sample)
                      .add("certify", answer.certify)
                      .add("total", answer.load + answer.translate + answer.plan + answer.sample + answer.certify));
}

void print(const TourAnswer& answer, const TourRequest& request, const plan::Terrain& terrain,
           const Terminal& terminal) {
  const auto label = [&](const std::string& text) {
    return terminal.paint(Paint::Bold, text + std::string(13 - text.size(), ' '));
  };
  std::cout << label("formula") << terminal.paint(Paint::Blue, shown(answer.formula, terminal)) << '\n';
  if (!answer.reason.empty()) std::cout << label("motion") << "none: " << answer.reason << '\n';
  if (!answer.tour) return;
  std::cout << label("word") << ltl::show(ltl::Trace(answer.tour->word().letters), terrain.vocabulary()) << '\n'
            << label("motion") << "of " << in_words(robot_of(request.robot)) << ", "
            << counted(answer.tour->motion().configurations.size(), "configuration") << ", length "
            << fixed(plan::length(answer.tour->motion()), 2) << ", " << terminal.paint(Paint::Green, "certified")
            << " by definition for the " << (request.clearance == "body" ? "whole body" : "centre") << ", sampled in "
            << fixed(1000 * answer.sample, 1) << " ms\n";
}

void draw_tour(const TourAnswer& answer, const TourRequest& request, const plan::Terrain& terrain,
               const automata::Dfa& dfa) {
  render::TerrainPage page{.terrain = &terrain};
  page.formula = ltl::print(answer.formula, ltl::Style::Unicode);
  page.caption = terrain.name();
  automata::DotOptions look;
  look.trap = automata::DotOptions::Trap::Omit;
  std::string left_out;
  page.automaton = render::lay_out_or_leave_out(automata::write_dot(dfa, look), {}, left_out);
  if (!page.automaton) complain("note", "the automaton is left out of the picture: " + left_out);
  if (answer.tour) {
    page.motion = answer.tour;
    const plan::Motion& motion = answer.tour->motion();
    page.caption += ", motion of " + in_words(motion.robot) + ", length " + fixed(plan::length(motion), 2) +
                    ", certified for the " + (request.clearance == "body" ? "whole body" : "centre");
    std::vector<render::Visit> visits;
    automata::StateId q = dfa.initial();
    const plan::TimedWord& word = answer.tour->word();
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
      q = dfa.next(q, word.letters[i]);
      visits.push_back({q.index, word.times[i]});
    }
    if (page.automaton) render::light_up(*page.automaton, motion, visits);
  }
  write_file(request.svg, render::draw_page(page));
}

// As terrains are written (docs/formats/terrains.md).
std::string text_of(const plan::Terrain& terrain) {
  const auto polygon = [](const plan::Polygon& corners) {
    JsonArray out;
    for (const plan::Point& p : corners) out.add(JsonArray().add(p.x).add(p.y));
    return out;
  };
  JsonArray obstacles, regions;
  for (const plan::Polygon& obstacle : terrain.obstacles()) obstacles.add(polygon(obstacle));
  for (const plan::NamedRegion& region : terrain.regions())
    regions.add(JsonObject().add("name", region.name).add("polygon", polygon(region.border)));
  return JsonObject()
      .add("name", terrain.name())
      .add("boundary", polygon(terrain.border()))
      .add("obstacles", obstacles)
      .add("regions", regions)
      .text();
}

// With a clearance of the body, regions that the formula avoids are wider by the reach of the robot.
plan::Terrain with_clearance(plan::Terrain terrain, ltl::Formula formula, const TourRequest& request) {
  if (request.clearance != "body") return terrain;
  try {
    std::vector<std::string> names;
    for (const ltl::Proposition p : plan::avoided(formula)) names.push_back(formula.arena().vocabulary().name(p));
    return plan::widened(terrain, names, plan::reach(robot_of(request.robot)));
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--clearance body: ") + error.what());
  }
}

Finished sample(const TourRequest& request, const plan::Terrain& terrain, ltl::Formula formula) {
  const auto program = needed_helper("waymark-motion", "finds motions by OMPL");
  std::vector<std::string> arguments = arguments_of(request.robot, request.search, ShapeOptions{});
  arguments.insert(arguments.end(), {"--workspace", "-", "--start", request.start, "--formula", ltl::print(formula)});
  return run_helper(program, arguments, text_of(terrain));
}

// Fills in the tour, if it is found; the verdict of the helper.
ExitCode find_tour(const TourRequest& request, const plan::Terrain& terrain, TourAnswer& answer) {
  StopWatch watch;
  const Finished finished = sample(request, terrain, answer.formula);
  answer.sample = watch.lap();
  const auto code = static_cast<ExitCode>(finished.exit_code);
  if (code == ExitCode::Done)
    answer.tour = plan::certify(plan::parse_motion(finished.output, "waymark-motion"), terrain, answer.formula);
  answer.certify = watch.lap();
  return code;
}

}  // namespace

ExitCode run_tour(const TourRequest& request, const Session& session) {
  StopWatch watch;
  const plan::Terrain given = plan::parse_terrain(read_file(request.workspace), source_name(request.workspace));
  ltl::Arena arena(given.vocabulary());
  const ltl::Formula formula =
      parse_formula(request.formula, arena, parse_options(request.notation, ltl::Unknown::Reject));
  const plan::Terrain terrain = with_clearance(given, formula, request);
  const plan::Configuration start = plan::parse_configuration(request.start);
  const plan::TerrainCells cells(terrain);
  const auto first = cells.at(position(start));
  if (!first || !admits(terrain, start, robot_of(request.robot)))
    throw ltl::FormatError("", 0, 0, "the robot does not fit at " + request.start);
  const double load = watch.lap();
  const automata::Dfa dfa = translate(formula, session.stop);
  TourAnswer answer{.formula = formula, .load = load};
  answer.translate = watch.lap();
  if (!plan::plan_tour(dfa, cells, *first))
    answer.reason = "no way through the free space has a word that satisfies it";
  answer.plan = watch.lap();
  const ExitCode code = answer.reason.empty() ? find_tour(request, terrain, answer) : ExitCode::No;
  if (code != ExitCode::Done && code != ExitCode::No && code != ExitCode::GaveUp) return code;
  if (request.json)
    std::cout << tour_json(answer, request, terrain).text() << '\n';
  else
    print(answer, request, terrain, session.out);
  if (!request.svg.empty()) draw_tour(answer, request, given, dfa);
  return code;
}

}  // namespace waymark::tools
