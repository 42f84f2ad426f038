#include "tools/plan_walk.hpp"

#include <algorithm>
#include <ostream>

#include "libltl/limits.hpp"
#include "libltl/text/print.hpp"
#include "libplan/behavior_tree.hpp"
#include "libplan/certify.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/solve/drop_conjuncts.hpp"
#include "libplan/solve/least_lasso.hpp"
#include "libplan/solve/least_routes.hpp"
#include "tools/answer.hpp"
#include "tools/picture.hpp"
#include "tools/plan_case.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t most_vertices = 100'000'000;

std::pair<double, double> rank(const plan::LassoRoute& route, plan::LassoOrder order) {
  switch (order) {
    case plan::LassoOrder::Prefix: return {route.prefix.cost, route.cycle.cost};
    case plan::LassoOrder::Cycle: return {route.cycle.cost, route.prefix.cost};
    case plan::LassoOrder::Mean: break;
  }
  return {route.mean(), route.prefix.cost};
}

std::string label(const Terminal& terminal, const std::string& text) {
  return terminal.paint(Paint::Bold, text + std::string(13 - text.size(), ' '));
}

std::string poses_of(std::span<const plan::PoseId> starts, const plan::Map& map) {
  std::string out;
  for (const plan::PoseId start : starts) out += (out.empty() ? "" : ", ") + plan::show(map.pose(start));
  return out;
}

JsonArray starts_json(const WalkTask& task) {
  return json_of(plan::Trajectory{{task.starts.begin(), task.starts.end()}, {}}, task.map);
}

struct FoundLasso {
  std::optional<plan::CertifiedLasso> lasso;
  plan::Route prefix, cycle;
  plan::SearchStatistics statistics;  // of all starts
  double translating = 0, solving = 0;
};

class LassoPlanning {
 public:
  LassoPlanning(const WalkTask& task, const WalkOptions& options, const std::stop_token& stop)
      : task_(task), options_(options), stop_(stop), automaton_(translated()) {
    for (ltl::Proposition p : automaton_.reads())
      if (!task_.map.vocabulary().find(automaton_.vocabulary().name(p)))
        throw plan::unknown_proposition(task_.map, automaton_.vocabulary().name(p));
    for (const plan::PoseId start : task_.starts) search(start);
    found_.solving = watch_.lap();
  }

  PlannedLasso planned() && { return {json(), std::move(found_.lasso), std::move(automaton_)}; }

  ExitCode show(const Terminal& terminal, std::ostream& out) const {
    if (options_.json)
      out << json().text() << '\n';
    else
      print(terminal, out);
    if (!options_.svg.empty()) draw_lasso();
    if (!options_.tree.empty() && found_.lasso) write_tree();
    return found_.lasso ? ExitCode::Done : ExitCode::No;
  }

 private:
  automata::Automaton translated() {
    const ltl::Limits limits{.stop = stop_};
    auto made =
        task_.formula ? plan::lasso_automaton(*task_.formula, limits) : plan::lasso_automaton(*task_.given, limits);
    found_.translating = watch_.lap();
    if (made) return std::move(*made);
    if (stop_.stop_requested()) throw Interrupted();
    throw GaveUp("no automaton within the limits");
  }

  void search(plan::PoseId start) {
    const plan::LassoOrder order = order_of(options_.order);
    const plan::Mdp mdp = plan::mdp_of(task_.map, start);
    auto answer = plan::least_lasso(mdp, automaton_, order, {.states = most_vertices, .stop = stop_});
    if (!answer && stop_.stop_requested()) throw Interrupted();
    if (!answer) throw GaveUp("the search for a lasso met its limit");
    found_.statistics.met += answer->statistics.met;
    found_.statistics.edges += answer->statistics.edges;
    if (!answer->route) return;
    if (found_.lasso && !(rank(*answer->route, order) < rank(found_.lasso->route(), order))) return;
    found_.lasso = task_.formula ? plan::certify(std::move(*answer->route), mdp, *task_.formula)
                                 : plan::certify(std::move(*answer->route), mdp, automaton_);
    found_.prefix = route_of(found_.lasso->route().prefix, task_.map);
    found_.cycle = route_of(found_.lasso->route().cycle, task_.map);
  }

  std::string reason() const {
    const std::string none = "no walk without end from " + poses_of(task_.starts, task_.map) + " satisfies ";
    if (!task_.formula) return none + "the automaton";
    try {
      const plan::Violation violation =
          plan::fewest_dropped(*task_.formula, [&](ltl::Formula part) { return has_lasso(part); });
      return plan::conflict_behind(none, violation);
    } catch (const GaveUp&) {
      return none + "the formula";
    }
  }

  bool has_lasso(ltl::Formula part) const {
    const auto automaton = plan::lasso_automaton(part, {.stop = stop_});
    for (const plan::PoseId start : task_.starts) {
      if (!automaton) throw GaveUp("no automaton within the limits");
      const auto answer = plan::least_lasso(plan::mdp_of(task_.map, start), *automaton, order_of(options_.order),
                                            {.states = most_vertices, .stop = stop_});
      if (!answer) throw GaveUp("the search for a lasso met its limit");
      if (answer->route) return true;
    }
    return false;
  }

  JsonObject json() const {
    JsonObject out = options_.head;
    out.add("formula", task_.formula ? Json(ltl::print(*task_.formula)) : Json())
        .add("map", task_.map.name())
        .add("semantics", "infinite")
        .add("order", options_.order)
        .add("automaton", JsonObject()
                              .add("states", automaton_.states())
                              .add("edges", automata::count_edges(automaton_.transitions()))
                              .add("sets", automaton_.acceptance().sets)
                              .add("propositions", automaton_.reads().size()))
        .add("product", JsonObject().add("states", found_.statistics.met).add("edges", found_.statistics.edges));
    if (found_.lasso) {
      out.add("status", "solved");
      if (options_.adds_route)
        out.add("route", json_of(trajectory_of(ShownRoute(*found_.lasso), task_.map), task_.map))
            .add("cost", found_.prefix.cost + found_.cycle.cost);
      out.add("prefix", json_of(found_.prefix, task_.map))
          .add("cycle", json_of(found_.cycle, task_.map))
          .add("prefix_cost", found_.prefix.cost)
          .add("cycle_cost", found_.cycle.cost)
          .add("rounds", found_.lasso->route().rounds)
          .add("mean_cost", found_.lasso->route().mean());
      add_certificate(out, *found_.lasso);
    } else {
      out.add("status", "infeasible").add("reason", reason()).add("starts", starts_json(task_));
    }
    return out.add("seconds", JsonObject()
                                  .add("load", options_.load)
                                  .add("translate", found_.translating)
                                  .add("solve", found_.solving)
                                  .add("total", options_.load + found_.translating + found_.solving));
  }

  void print(const Terminal& terminal, std::ostream& out) const {
    if (task_.formula)
      out << label(terminal, "formula") << terminal.paint(Paint::Blue, shown(*task_.formula, terminal)) << '\n';
    out << label(terminal, "automaton") << counted(automaton_.states(), "state") << ", "
        << counted(automata::count_edges(automaton_.transitions()), "edge") << ", over infinite words\n"
        << label(terminal, "product") << counted(found_.statistics.met, "state") << ", "
        << counted(found_.statistics.edges, "edge") << ", with the map " << task_.map.name() << '\n';
    if (found_.lasso) {
      out << label(terminal, "prefix") << counted(found_.prefix.actions.size(), "action") << ", cost "
          << Json(found_.prefix.cost).text() << '\n';
      print_start(out, terminal, found_.prefix.poses.front(), task_.map);
      print_steps(out, found_.prefix, task_.map);
      out << label(terminal, "cycle") << counted(found_.cycle.actions.size(), "action") << ", cost "
          << Json(found_.cycle.cost).text();
      if (const std::uint64_t rounds = found_.lasso->route().rounds; rounds > 1) out << ", " << rounds << " rounds";
      out << ", for ever, " << terminal.paint(Paint::Green, "certified") << " by " << *certifier(*found_.lasso) << '\n';
      print_steps(out, found_.cycle, task_.map, found_.prefix.actions.size() + 1);
    } else {
      out << label(terminal, "route") << "none: " << reason() << '\n';
    }
    out << label(terminal, "time") << "load " << milliseconds(options_.load) << ", translate "
        << milliseconds(found_.translating) << ", solve " << milliseconds(found_.solving) << '\n';
  }

  void draw_lasso() const {
    Picture picture{.map = &task_.map, .omega = &automaton_, .formula = task_.formula};
    if (found_.lasso) picture.route = *found_.lasso;
    draw(picture, options_.svg, stop_);
  }

  void write_tree() const {
    const ShownRoute lasso = *found_.lasso;
    write_file(options_.tree, plan::write_behavior_tree(trajectory_of(lasso, task_.map), task_.map,
                                                        task_.formula ? ltl::print(*task_.formula) : "automaton",
                                                        repeated_actions(lasso)));
  }

  const WalkTask& task_;
  const WalkOptions& options_;
  const std::stop_token& stop_;
  StopWatch watch_;
  FoundLasso found_;
  automata::Automaton automaton_;
};

// Certified by the definition, or by the automaton where there is no formula.
CheckedRoute checked(plan::Route route, const WalkTask& task, const automata::Dfa& dfa) {
  if (task.formula) return plan::certify(std::move(route), task.map, *task.formula);
  return plan::certify_acceptance(std::move(route), task.map, dfa);
}

struct FoundRoutes {
  std::vector<CheckedRoute> routes;
  plan::SearchStatistics statistics;  // of all starts
  double solving = 0;
};

FoundRoutes cheapest(const WalkTask& task, const automata::Dfa& dfa, std::size_t most, const Session& session) {
  StopWatch watch;
  FoundRoutes found;
  for (const plan::PoseId start : task.starts) {
    const plan::Mdp mdp = plan::mdp_of(task.map, start);
    const auto answer = plan::least_routes(plan::Product(mdp, plan::TaskTable(dfa, mdp.letters())), most,
                                           {.states = most_vertices, .stop = session.stop});
    if (!answer && session.stop.stop_requested()) throw Interrupted();
    if (!answer) throw GaveUp("the search for routes met its limit");
    found.statistics.met += answer->statistics.met;
    found.statistics.edges += answer->statistics.edges;
    for (const plan::ChoiceRoute& route : answer->routes)
      found.routes.push_back(checked(route_of(route, task.map), task, dfa));
  }
  std::stable_sort(found.routes.begin(), found.routes.end(),
                   [](const CheckedRoute& a, const CheckedRoute& b) { return route_of(a).cost < route_of(b).cost; });
  if (found.routes.size() > most)
    found.routes.erase(found.routes.begin() + static_cast<std::ptrdiff_t>(most), found.routes.end());
  found.solving = watch.lap();
  return found;
}

JsonObject routes_json(const FoundRoutes& found, const WalkTask& task, const automata::Dfa& dfa,
                       const WalkOptions& options) {
  JsonArray list;
  for (const CheckedRoute& route : found.routes)
    list.add(JsonObject().add("route", json_of(route_of(route), task.map)).add("cost", route_of(route).cost));
  JsonObject json;
  json.add("formula", task.formula ? Json(ltl::print(*task.formula)) : Json())
      .add("map", task.map.name())
      .add("automaton", json_of(size_of(dfa)))
      .add("product", JsonObject().add("states", found.statistics.met).add("edges", found.statistics.edges))
      .add("status", found.routes.empty() ? "infeasible" : "solved")
      .add("asked", options.top)
      .add("starts", starts_json(task))
      .add("routes", list);
  if (!found.routes.empty()) add_certificate(json, shown(found.routes.front()));
  return json.add("seconds", JsonObject()
                                 .add("load", options.load)
                                 .add("translate", options.translate)
                                 .add("solve", found.solving)
                                 .add("total", options.load + options.translate + found.solving));
}

}  // namespace

ExitCode plan_lasso(const WalkTask& task, const WalkOptions& options, const Session& session, std::ostream& out) {
  try {
    return LassoPlanning(task, options, session.stop).show(session.out, out);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

PlannedLasso planned_lasso(const WalkTask& task, const WalkOptions& options, const std::stop_token& stop) {
  return LassoPlanning(task, options, stop).planned();
}

ExitCode plan_routes(const WalkTask& task, const automata::Dfa& dfa, const WalkOptions& options, const Session& session,
                     std::ostream& out) {
  const FoundRoutes found = cheapest(task, dfa, options.top, session);
  const std::vector<CheckedRoute>& routes = found.routes;
  if (options.json) {
    out << routes_json(found, task, dfa, options).text() << '\n';
  } else {
    if (task.formula)
      out << label(session.out, "formula") << session.out.paint(Paint::Blue, shown(*task.formula, session.out)) << '\n';
    if (routes.empty()) out << label(session.out, "route") << "none\n";
    for (std::size_t i = 0; i < routes.size(); ++i) {
      const plan::Route& route = route_of(routes[i]);
      out << label(session.out, "route " + std::to_string(i + 1)) << counted(route.actions.size(), "action")
          << ", cost " << Json(route.cost).text() << ", " << session.out.paint(Paint::Green, "certified") << " by "
          << *certifier(shown(routes[i])) << '\n';
      print_start(out, session.out, route.poses.front(), task.map);
      print_steps(out, route, task.map);
    }
  }
  return routes.empty() ? ExitCode::No : ExitCode::Done;
}

}  // namespace waymark::tools
