#include "tools/answer.hpp"

#include <iomanip>
#include <ostream>

#include "libltl/text/print.hpp"

namespace waymark::tools {
namespace {

JsonObject seconds_json(const Seconds& seconds, bool grounded) {
  JsonObject json;
  json.add("load", seconds.load);
  if (grounded) json.add("ground", seconds.ground);
  return json.add("translate", seconds.translate)
      .add("compose", seconds.compose)
      .add("solve", seconds.solve)
      .add("certify", seconds.certify)
      .add("total", seconds.total());
}

std::string place(const plan::Pose& pose) { return '(' + std::to_string(pose.x) + ',' + std::to_string(pose.y) + ')'; }

// "FORWARD to (1,8) over brick, at the lamp"
std::string step_in_words(plan::Action action, plan::PoseId from, plan::PoseId to, const plan::Map& map) {
  const plan::Pose pose = map.pose(to);
  std::string words(plan::name(action));
  if (action != plan::Action::Forward) return words + " to face " + heading_name(pose.heading);
  words += " to " + place(pose);
  const plan::Edge* hallway = map.hallway(map.node_of(from), map.pose(from).heading);
  if (hallway != nullptr && !hallway->floor.empty()) words += " over " + hallway->floor;
  if (const auto& object = map.nodes()[map.node_of(to)].object) words += ", at the " + *object;
  return words;
}

}  // namespace

std::string milliseconds(double seconds) { return fixed(1000 * seconds, 2) + " ms"; }

JsonArray json_of(const plan::Trajectory& trajectory, const plan::Map& map) {
  JsonArray poses;
  for (const plan::PoseId id : trajectory.poses) {
    const plan::Pose pose = map.pose(id);
    poses.add(JsonArray().add(pose.x).add(pose.y).add(pose.heading));
  }
  return poses;
}

void print_start(std::ostream& out, const Terminal& terminal, plan::PoseId start, const plan::Map& map) {
  const plan::Pose pose = map.pose(start);
  out << "    " << terminal.paint(Paint::Dim, "start") << " at " << place(pose) << " facing "
      << heading_name(pose.heading) << '\n';
}

void print_steps(std::ostream& out, const plan::Trajectory& trajectory, const plan::Map& map, std::size_t first) {
  for (std::size_t i = 0; i < trajectory.actions.size(); ++i)
    out << std::setw(5) << first + i << "  "
        << step_in_words(trajectory.actions[i], trajectory.poses[i], trajectory.poses[i + 1], map) << '\n';
}

std::string heading_name(int heading) {
  switch (heading) {
    case 0: return "north";
    case 90: return "east";
    case 180: return "south";
    default: return "west";
  }
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

std::string shown(ltl::Formula formula, const Terminal& terminal) {
  return ltl::print(formula, terminal.unicode ? ltl::Style::Unicode : ltl::Style::Ascii);
}

JsonObject json_of(const AutomatonSize& size) {
  return JsonObject()
      .add("states", size.states)
      .add("edges", size.edges)
      .add("symbolic_nodes", size.symbolic_nodes)
      .add("propositions", size.propositions);
}

JsonObject json_of(const Answer& answer, const plan::Map& map) {
  JsonObject json;
  if (answer.id) json.add("id", *answer.id);
  if (answer.instruction) json.add("instruction", *answer.instruction);
  if (answer.understood) json.add("understood", *answer.understood);
  json.add("formula", answer.formula ? Json(ltl::print(*answer.formula)) : Json());
  if (answer.instruction) {
    JsonArray readings;
    for (const WeighedFormula& reading : answer.readings)
      readings.add(JsonObject().add("formula", ltl::print(reading.formula)).add("probability", reading.probability));
    json.add("readings", readings);
    if (answer.alternatives) json.add("alternatives", *answer.alternatives);
  }
  const CorridorRun& corridor_run = answer.corridor_run;
  json.add("map", map.name()).add("automaton", json_of(corridor_run.automaton));
  json.add("product", JsonObject().add("states", corridor_run.product_states).add("edges", corridor_run.product_edges));
  if (const plan::Route* route = route_of(corridor_run)) {
    json.add("status", "solved").add("route", json_of(*route, map)).add("cost", route->cost);
    add_certificate(json, *shown(corridor_run));
  } else {
    json.add("status", "infeasible").add("reason", std::get<plan::Infeasible>(corridor_run.destination).reason);
    json.add("starts", json_of(plan::Trajectory{corridor_run.starts, {}}, map));
  }
  return json.add("seconds", seconds_json(corridor_run.seconds, answer.instruction.has_value()));
}

void print(std::ostream& out, const Terminal& terminal, const Answer& answer, const plan::Map& map) {
  const auto label = [&](const std::string& text) {
    return terminal.paint(Paint::Bold, text + std::string(13 - text.size(), ' '));
  };
  const CorridorRun& corridor_run = answer.corridor_run;
  if (answer.instruction) out << label("instruction") << *answer.instruction << '\n';
  if (answer.understood) out << label("understood") << *answer.understood << '\n';
  if (answer.formula) out << label("formula") << terminal.paint(Paint::Blue, shown(*answer.formula, terminal)) << '\n';
  if (answer.readings.size() > 1)
    for (const WeighedFormula& reading : answer.readings)
      out << label("  reading") << fixed(100 * reading.probability, 1) << " %  " << shown(reading.formula, terminal)
          << '\n';
  out << label("automaton") << counted(corridor_run.automaton.states, "state") << ", "
      << counted(corridor_run.automaton.edges, "edge") << '\n';
  if (corridor_run.product_states > 0)  // a route that was given needs none
    out << label("product") << counted(corridor_run.product_states, "state") << " met, "
        << counted(corridor_run.product_edges, "edge") << ", with the map " << map.name() << '\n';
  if (const plan::Route* route = route_of(corridor_run)) {
    out << label("route") << counted(route->actions.size(), "action") << ", cost " << Json(route->cost).text() << ", "
        << terminal.paint(Paint::Green, "certified") << " by " << *certifier(*shown(corridor_run)) << '\n';
    print_start(out, terminal, route->poses.front(), map);
    print_steps(out, *route, map);
  } else {
    out << label("route") << "none: " << std::get<plan::Infeasible>(corridor_run.destination).reason << '\n';
  }
  const Seconds& s = corridor_run.seconds;
  out << label("time") << "load " << milliseconds(s.load);
  if (answer.instruction) out << ", ground " << milliseconds(s.ground);
  out << ", translate " << milliseconds(s.translate) << ", compose " << milliseconds(s.compose) << ", solve "
      << milliseconds(s.solve) << ", certify " << milliseconds(s.certify) << '\n';
}

}  // namespace waymark::tools
