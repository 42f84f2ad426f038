// Maps and routes: poses, letters, certified plans, pictures.
#include <algorithm>

#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libltl/text/print.hpp"
#include "libplan/certify.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/plan_of.hpp"
#include "libplan/solve/least_lasso.hpp"
#include "libplan/solve/route_planner.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "libplan/world/read_map.hpp"
#include "python/handles.hpp"
#include "tools/render/page.hpp"

namespace waymark::python {
namespace {

using MapPointer = std::shared_ptr<plan::Map>;

// A route on its map, with what it was certified by. A lasso repeats its last `repeated` actions for ever.
struct RouteHandle {
  MapPointer map;
  plan::Trajectory walk;
  double cost = 0;
  std::size_t repeated = 0;
  std::string certified_by;
};
struct NoRoute {
  std::string reason;
};
using Planned = std::variant<RouteHandle, NoRoute>;

py::tuple tuple_of(const plan::Pose& pose) { return py::make_tuple(pose.x, pose.y, pose.heading); }

plan::PoseId pose_of(const plan::Map& map, const std::tuple<int, int, int>& pose) {
  const auto [x, y, heading] = pose;
  if (const auto found = map.find({x, y, heading})) return *found;
  throw py::value_error("(" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(heading) +
                        ") is no pose of the map " + map.name());
}

plan::Action action_of(const std::string& name) {
  if (const auto action = plan::parse_action(name)) return *action;
  throw py::value_error("an action is FORWARD, LEFT or RIGHT, not '" + name + "'");
}

py::array_t<int> array_of(const plan::Map& map, const std::vector<plan::PoseId>& poses) {
  py::array_t<int> out({poses.size(), std::size_t{3}});
  auto cells = out.mutable_unchecked<2>();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const plan::Pose pose = map.pose(poses[i]);
    const auto row = static_cast<py::ssize_t>(i);
    cells(row, 0) = pose.x, cells(row, 1) = pose.y, cells(row, 2) = pose.heading;
  }
  return out;
}

py::array_t<int> all_poses(const plan::Map& map) {
  std::vector<plan::PoseId> poses;
  for (std::uint32_t p = 0; p < map.poses(); ++p) poses.push_back({p});
  return array_of(map, poses);
}

// The formula over the vocabulary of the map. Throws FormatError on a proposition that the map lacks.
ltl::Formula on_map(const FormulaHandle& f, ltl::Arena& arena, const plan::Map& map) {
  const ltl::Formula own = ltl::transfer(f.formula, arena);
  for (const ltl::Proposition p : ltl::propositions(own))
    if (p.index >= map.vocabulary().size()) throw plan::unknown_proposition(map, arena.vocabulary().name(p));
  return own;
}

Planned plan_formula(const FormulaHandle& f, const MapPointer& map, const std::string& start) {
  const auto starts = plan::parse_start(start, *map);
  ltl::Arena arena(map->vocabulary());
  const ltl::Formula own = on_map(f, arena, *map);
  return interruptible([&](std::stop_token stop) -> Planned {
    const auto planned = plan::plan_of(*map, own, starts, {.stop = std::move(stop)});
    if (const auto* no = std::get_if<plan::Infeasible>(&planned)) return NoRoute{no->reason};
    if (std::holds_alternative<plan::Exhausted>(planned)) throw LimitMet("gave up: the automaton is too large");
    const plan::Route& route = std::get<plan::CertifiedRoute>(planned).route();
    return RouteHandle{map, route, route.cost, 0, "definition"};
  });
}

Planned plan_automaton(const automata::Dfa& dfa, const MapPointer& map, const std::string& start) {
  const auto starts = plan::parse_start(start, *map);
  return interruptible([&](const std::stop_token& stop) -> Planned {
    plan::RoutePlanner planner(*map, dfa);
    plan::RoutePlanner::Result answer = planner.plan(starts, stop);
    if (const auto* no = std::get_if<plan::Infeasible>(&answer)) return NoRoute{no->reason};
    if (std::holds_alternative<plan::Exhausted>(answer)) throw LimitMet("the search was stopped");
    const auto accepted = plan::certify_acceptance(std::get<plan::Route>(std::move(answer)), *map, dfa);
    return RouteHandle{map, accepted.route(), accepted.route().cost, 0, "automaton"};
  });
}

plan::LassoOrder order_of(const std::string& name) {
  for (const auto order : {plan::LassoOrder::Prefix, plan::LassoOrder::Cycle, plan::LassoOrder::Mean})
    if (plan::name(order) == name) return order;
  throw py::value_error("order is 'prefix', 'cycle' or 'mean', not '" + name + "'");
}

void append(plan::Trajectory& walk, const plan::ChoiceRoute& route, const plan::Map& map) {
  for (std::size_t i = 0; i < route.places.size(); ++i) {
    const plan::PoseId pose{route.places[i]};
    if (i == 0 && !walk.poses.empty()) continue;  // the cycle begins where the prefix ends
    if (i > 0) walk.actions.push_back(plan::action_between(map, walk.poses.back(), pose).value());
    walk.poses.push_back(pose);
  }
}

// From the first start that has a lasso.
Planned plan_lasso(const FormulaHandle& f, const MapPointer& map, const std::string& start, const std::string& order) {
  const auto starts = plan::parse_start(start, *map);
  const plan::LassoOrder by = order_of(order);
  ltl::Arena arena(map->vocabulary());
  const ltl::Formula own = on_map(f, arena, *map);
  return interruptible([&](const std::stop_token& stop) -> Planned {
    const auto automaton = plan::lasso_automaton(own, {.stop = stop});
    if (!automaton) throw LimitMet("gave up: no automaton within the limits");
    for (const plan::PoseId from : starts) {
      const plan::Mdp mdp = plan::mdp_of(*map, from);
      auto answer = plan::least_lasso(mdp, *automaton, by, {.states = 100'000'000, .stop = stop});
      if (!answer) throw LimitMet("the search for a lasso met its limit");
      if (!answer->route) continue;
      const auto lasso = plan::certify(std::move(*answer->route), mdp, own);
      RouteHandle out{map,
                      {},
                      lasso.route().prefix.cost + lasso.route().cycle.cost,
                      lasso.route().cycle.choices.size(),
                      "definition"};
      append(out.walk, lasso.route().prefix, *map);
      append(out.walk, lasso.route().cycle, *map);
      return out;
    }
    return NoRoute{"no walk without end satisfies the formula"};
  });
}

// The page that `waymark plan --svg` draws. `automaton`: an SVG of Graphviz, or "".
std::string page(const plan::Map& map, const RouteHandle* route, const std::string& instruction,
                 const FormulaHandle* formula, const std::string& automaton) {
  render::Page page{.map = &map, .instruction = instruction, .caption = "map " + map.name()};
  if (route != nullptr) {
    page.route = route->walk;
    page.caption += ", " + std::to_string(route->walk.actions.size()) + " actions";
    if (route->repeated > 0) page.caption += ", the last " + std::to_string(route->repeated) + " for ever";
    if (!route->certified_by.empty()) page.caption += ", certified";
  }
  if (formula != nullptr) page.formula = ltl::print(formula->formula, ltl::Style::Unicode);
  if (!automaton.empty()) page.automaton = render::drawing_of(automaton);
  return render::draw_page(page);
}

std::string first_place(const plan::Map& map) {
  const auto& nodes = map.nodes();
  std::size_t best = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (nodes[i].place && (!nodes[best].place || *nodes[i].place < *nodes[best].place)) best = i;
  return std::to_string(nodes[best].x) + "," + std::to_string(nodes[best].y) + ",0";
}

void bind_map(py::module_& m) {
  using plan::Map;
  py::class_<Map, MapPointer>(m, "Map", "A map of hallways: poses, actions, and what holds at each pose.")
      .def(py::init([](const std::string& name, const std::string& data) {
             return std::make_shared<Map>(plan::read_map(name, data));
           }),
           py::arg("name_or_file"), py::arg("data"))
      .def_property_readonly("name", &Map::name, "The name of the map.")
      .def_property_readonly(
          "propositions", [](const Map& map) { return map.vocabulary().names(); },
          "The names of all propositions of the map.")
      .def_property_readonly("poses", &all_poses, "All poses, one a row: x, y, heading.")
      .def_property_readonly(
          "places",
          [](const Map& map) {
            py::dict out;
            for (const plan::Node& node : map.nodes())
              if (node.place) out[py::int_(*node.place)] = py::make_tuple(node.x, node.y);
            return out;
          },
          "The numbered places: number → (x, y).")
      .def_property_readonly("first_start", &first_place, "The start where none is given, as text.")
      .def(
          "label",
          [](const Map& map, const std::tuple<int, int, int>& pose) {
            return names_of(map.label(pose_of(map, pose)), map.vocabulary());
          },
          py::arg("pose"), "The propositions that hold at the pose.")
      .def(
          "letter",
          [](const Map& map, const std::tuple<int, int, int>& pose, const std::string& by) {
            return names_of(map.letter(pose_of(map, pose), action_of(by)), map.vocabulary());
          },
          py::arg("pose"), py::arg("action"), "The letter of an action that leads to the pose.")
      .def(
          "successor",
          [](const Map& map, const std::tuple<int, int, int>& pose, const std::string& by) -> py::object {
            const auto to = map.successor(pose_of(map, pose), action_of(by));
            return to ? py::object(tuple_of(map.pose(*to))) : py::none();
          },
          py::arg("pose"), py::arg("action"), "The pose after the action; None in front of a wall.");
}

py::array_t<int> poses_between(const RouteHandle& r, std::size_t begin, std::size_t end) {
  return array_of(*r.map, {r.walk.poses.begin() + static_cast<std::ptrdiff_t>(begin),
                           r.walk.poses.begin() + static_cast<std::ptrdiff_t>(end)});
}

void bind_route(py::module_& m) {
  py::class_<RouteHandle>(m, "Route", "A route on a map; `certified_by` says what the certificate rests on.")
      .def_readonly("map", &RouteHandle::map, "The map.")
      .def_readonly("cost", &RouteHandle::cost, "The sum over the actions; of a lasso, with one round of the cycle.")
      .def_readonly("certified_by", &RouteHandle::certified_by,
                    "'definition' or 'automaton'; '' of a walk that was only followed.")
      .def_property_readonly(
          "poses", [](const RouteHandle& r) { return array_of(*r.map, r.walk.poses); },
          "All poses, one a row: x, y, heading; of a lasso, prefix and one round of the cycle.")
      .def_property_readonly(
          "actions",
          [](const RouteHandle& r) {
            std::vector<std::string> out;
            for (const plan::Action a : r.walk.actions) out.emplace_back(plan::name(a));
            return out;
          },
          "The actions, one fewer than poses.")
      .def_property_readonly(
          "word", [](const RouteHandle& r) { return letters_of(plan::word_of(r.walk, *r.map), r.map->vocabulary()); },
          "The letters, the label of the start first.")
      .def_property_readonly(
          "is_lasso", [](const RouteHandle& r) { return r.repeated > 0; }, "Does the walk go on for ever?")
      .def_property_readonly(
          "prefix", [](const RouteHandle& r) { return poses_between(r, 0, r.walk.poses.size() - r.repeated); },
          "The poses before the cycle, with the pose where the cycle begins.")
      .def_property_readonly(
          "cycle",
          [](const RouteHandle& r) {
            const std::size_t n = r.walk.poses.size();
            return r.repeated > 0 ? poses_between(r, n - r.repeated - 1, n) : poses_between(r, n, n);
          },
          "The poses of the cycle, the first one again at the end; empty without a cycle.")
      .def("__len__", [](const RouteHandle& r) { return r.walk.actions.size(); })
      .def("__str__", [](const RouteHandle& r) { return plan::show(r.walk, *r.map); });
  py::class_<NoRoute>(m, "NoRoute", "The proof that there is no route; false in conditions.")
      .def_readonly("reason", &NoRoute::reason, "Why there is none.")
      .def("__bool__", [](const NoRoute&) { return false; })
      .def("__repr__",
           [](const NoRoute& n) { return "NoRoute(" + py::repr(py::str(n.reason)).cast<std::string>() + ")"; });
}

}  // namespace

void bind_maps(py::module_& m) {
  bind_map(m);
  bind_route(m);
  m.def("plan_formula", &plan_formula, py::arg("formula"), py::arg("map"), py::arg("start"),
        "The certified route of least cost.");
  m.def("plan_automaton", &plan_automaton, py::arg("automaton"), py::arg("map"), py::arg("start"),
        "The route of least cost that the automaton accepts.");
  m.def("plan_lasso", &plan_lasso, py::arg("formula"), py::arg("map"), py::arg("start"), py::arg("order") = "prefix",
        "The certified lasso that comes first in the order.");
  m.def(
      "follow",
      [](const MapPointer& map, const std::string& text) {
        plan::Trajectory walk = plan::parse_trajectory(text, *map);
        const auto cost = static_cast<double>(walk.actions.size());
        return RouteHandle{map, std::move(walk), cost, 0, ""};
      },
      py::arg("map"), py::arg("text"), "A walk from text: a start pose and actions, or a JSON list of poses.");
  m.def("page", &page, py::arg("map"), py::arg("route") = nullptr, py::arg("instruction") = "",
        py::arg("formula") = nullptr, py::arg("automaton") = "", "The picture of a map, as SVG.");
}

}  // namespace waymark::python
