#include "tools/verify_map.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/least_by_progression.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/solve/drop_conjuncts.hpp"
#include "libplan/world/json_reader.hpp"
#include "libplan/world/trajectory.hpp"
#include "tools/progression_product.hpp"
#include "tools/verify_order.hpp"
#include "tools/verify_reason.hpp"
#include "tools/walk_referee.hpp"

namespace waymark::tools {
namespace {

using Value = Claims::Value;

class OnMap {
 public:
  OnMap(Claims& claims, const plan::JsonReader& in, const Value& answer, const Text& text, const plan::Map& map,
        TextReferee& texts, const ltl::Limits& limits)
      : claims_(claims),
        in_(in),
        answer_(answer),
        text_(text),
        map_(map),
        texts_(texts),
        limits_(limits),
        arena_(map.vocabulary()) {}

  void examine() {
    read_formula();
    claims_.is_figure("automaton");
    const bool infinite = claims_.has("semantics") || claims_.has("cycle") || claims_.has("prefix");
    const std::string status = claims_.text("status");
    if (status != "solved" && status != "infeasible") in_.fail("status", "expected \"solved\" or \"infeasible\"");
    if (infinite)
      without_end(status);
    else if (claims_.has("routes"))
      routes(status);
    else if (status == "solved")
      route();
    else
      infeasible();
    if (claims_.has("instruction") && formula_ && start_)
      examine_reading(claims_, in_,
                      {map_, *formula_, infinite ? ltl::Semantics::Infinite : ltl::Semantics::Finite, *start_}, texts_,
                      limits_.stop);
  }

 private:
  void read_formula() {
    if (const Value& formula = claims_.member("formula"); formula.is_null())
      claims_.add(std::nullopt, "the automaton, which the answer does not bring, accepts");
    else
      formula_ = ltl::parse(in_.string(formula, "formula"), arena_, {.unknown = ltl::Unknown::Reject});
  }

  // Steps that the map does not have are a claim that does not hold, not a file that cannot be read.
  std::optional<plan::Walk> walk_of(const std::string& document) {
    try {
      plan::Walk walk = plan::parse_walk(document, map_, text_.source);
      claims_.add(true, "every step is one on map " + map_.name());
      start_ = walk.trajectory.poses.front();
      return walk;
    } catch (const ltl::FormatError& error) {
      const std::string what = error.what();
      claims_.add(false, "every step is one on map " + map_.name() + " (" + what.substr(0, what.find('\n')) + ")");
      return std::nullopt;
    }
  }

  void cost(const char* key, const Value& said, double counted) {
    claims_.add(in_.number(said, key) == counted, std::string(key) + " is " + said.dump());
  }

  // By the definition where there is a formula: what certifies a route.
  void certified(std::optional<bool> satisfied) {
    claims_.expect_text("certified_by", formula_ ? "definition" : "automaton");
    const Value& said = claims_.member("certified");
    if (!said.is_boolean()) in_.fail("certified", "expected true or false");
    claims_.add(said == true ? satisfied : std::optional(false), "certified is " + said.dump());
  }

  bool satisfied(const plan::Trajectory& route) const { return ltl::holds(plan::word_of(route, map_), *formula_); }

  void route() {
    claims_.member("route");
    const auto walk = walk_of(answer_.dump());
    if (!walk) return;
    const plan::Trajectory& found = walk->trajectory;
    cost("cost", claims_.member("cost"), static_cast<double>(found.actions.size()));
    if (!formula_) return certified(std::nullopt);
    const bool holds = satisfied(found);
    claims_.add(holds, "the route satisfies " + ltl::print(*formula_));
    certified(holds);
    least(found);
  }

  void least(const plan::Trajectory& route) {
    const plan::PoseId start = route.poses.front();
    const auto found = plan::least_by_progression(*formula_, map_, {&start, 1}, limits_);
    claims_.add(found ? std::optional(!found->actions || *found->actions >= route.actions.size()) : std::nullopt,
                "no route from " + plan::show(map_.pose(start)) + " costs less");
  }

  // ---- several routes

  void routes(const std::string& status) {
    std::vector<plan::Trajectory> found;
    bool all_hold = true;
    in_.each(answer_, "", "routes", [&](const Value& one, const std::string& path) {
      const auto walk = walk_of(one.dump());
      cost("cost", in_.member(one, path, "cost"), walk ? static_cast<double>(walk->trajectory.actions.size()) : -1.0);
      claims_.only(one, path, {"route", "cost"});
      if (!walk) return;
      found.push_back(walk->trajectory);
      if (!formula_) return;
      const bool holds = satisfied(found.back());
      all_hold = all_hold && holds;
      claims_.add(holds, "the route satisfies " + ltl::print(*formula_));
    });
    claims_.member("routes");
    claims_.add(found.empty() == (status == "infeasible"), "status is \"" + status + '"');
    const auto asked = static_cast<double>(in_.integer(claims_.member("asked"), "asked"));
    claims_.add(static_cast<double>(found.size()) <= asked && asked >= 1,
                "no more routes are listed than were asked for");
    if (found.empty()) return no_route();
    certified(formula_ ? std::optional(all_hold) : std::nullopt);
    const auto costs_more = [](const plan::Trajectory& a, const plan::Trajectory& b) {
      return a.actions.size() < b.actions.size();
    };
    claims_.add(std::is_sorted(found.begin(), found.end(), costs_more), "the routes are in the order of their costs");
    bool twice = false;
    for (auto one = found.begin(); one != found.end(); ++one) twice = twice || std::count(one, found.end(), *one) > 1;
    claims_.add(!twice, "no route is listed twice");
    if (formula_) none_is_missing(found, static_cast<double>(found.size()) < asked);
  }

  // Of the routes as dear as the last one, the list need not have all, unless it has fewer than were asked for.
  void none_is_missing(const std::vector<plan::Trajectory>& routes, bool all_asked_for) {
    const std::size_t last = routes.back().actions.size();
    std::size_t listed = 0;
    bool stop_at_first = true, from_starts = true;
    const std::vector<plan::PoseId> starts = told_starts();
    for (const plan::Trajectory& route : routes) {
      from_starts = from_starts && std::find(starts.begin(), starts.end(), route.poses.front()) != starts.end();
      if (all_asked_for || route.actions.size() < last) ++listed;
      for (std::size_t n = 0; n < route.actions.size(); ++n) {
        const auto end = static_cast<std::ptrdiff_t>(n);
        stop_at_first = stop_at_first && !satisfied({{route.poses.begin(), route.poses.begin() + end + 1},
                                                     {route.actions.begin(), route.actions.begin() + end}});
      }
    }
    claims_.add(stop_at_first, "every route ends where it first satisfies the formula");
    claims_.add(from_starts, "every route begins at one of the starts");
    std::optional<double> all = 0;
    for (const plan::PoseId start : starts) {
      const auto product = product_by_progression(from(start), *formula_, ltl::Semantics::Finite, limits_);
      const auto more = !product        ? std::nullopt
                        : all_asked_for ? std::optional(count_walks(*product))
                                        : count_walks(*product, static_cast<double>(last), limits_.states);
      all = all && more ? std::optional(*all + *more) : std::nullopt;
    }
    claims_.add(all ? std::optional(*all == static_cast<double>(listed)) : std::nullopt,
                all_asked_for ? "there is no further route from these starts"
                              : "no route from these starts that costs less than the last one is missing");
  }

  // ---- walks without end

  void without_end(const std::string& status) {
    claims_.add(claims_.has("semantics") && claims_.text("semantics") == "infinite", "semantics is \"infinite\"");
    const std::string order = claims_.text("order");
    if (order != "prefix" && order != "cycle" && order != "mean")
      in_.fail("order", "expected \"prefix\", \"cycle\" or \"mean\"");
    if (status == "infeasible") {
      claims_.add(!claims_.has("prefix") && !claims_.has("cycle"), "an infeasible answer has no walk");
      return no_walk();
    }
    Value only = Value::object();
    for (const char* key : {"prefix", "cycle"}) only[key] = claims_.member(key);
    const std::optional<plan::Walk> walk = walk_of(only.dump());
    if (!walk) return;
    const auto repeated = static_cast<double>(walk->repeated);
    cost("prefix_cost", claims_.member("prefix_cost"), static_cast<double>(walk->trajectory.actions.size()) - repeated);
    cost("cycle_cost", claims_.member("cycle_cost"), repeated);
    const double rounds = in_.number(claims_.member("rounds"), "rounds");
    const Value& mean = claims_.member("mean_cost");
    claims_.add(is_close(in_.number(mean, "mean_cost"), repeated / rounds), "mean_cost is " + mean.dump());
    if (!formula_) {
      claims_.add(std::nullopt, "no other walk comes first in the order \"" + order + '"');
      return certified(std::nullopt);
    }
    const bool holds = ltl::holds(plan::lasso_of(*walk, map_), *formula_);
    claims_.add(holds, "the walk without end satisfies " + ltl::print(*formula_));
    certified(holds);
    const ToldLasso told{static_cast<double>(walk->trajectory.actions.size()) - repeated, repeated, rounds,
                         plan::lasso_of(*walk, map_)};
    examine_order(claims_, order, told, from(walk->trajectory.poses.front()), *formula_, limits_);
  }

  plan::PlanningCase from(plan::PoseId start) const { return {"", plan::mdp_of(map_, start), {}}; }

  void no_walk() {
    const std::vector<plan::PoseId> starts = told_starts();
    if (starts.empty()) return claims_.add(std::nullopt, "no walk without end satisfies the task: no starts are told");
    if (!formula_) return claims_.add(std::nullopt, "no walk without end from these starts is accepted");
    const auto possible = [&](ltl::Formula f) { return has_walk_from(starts, f); };
    const auto found = possible(*formula_);
    claims_.add(found ? std::optional(!*found) : std::nullopt,
                "no walk without end from these starts satisfies " + ltl::print(*formula_));
    reason("no walk without end from ", ", ", starts, possible);
  }

  std::optional<bool> has_walk_from(const std::vector<plan::PoseId>& starts, ltl::Formula f) const {
    std::optional<bool> found = false;
    for (const plan::PoseId start : starts) {
      const auto here = has_walk(from(start), f, limits_);
      if (here == true) return true;
      if (!here) found = std::nullopt;
    }
    return found;
  }

  // The sentence that names what cannot be met.
  void reason(const std::string& head, const char* between, const std::vector<plan::PoseId>& starts,
              const std::function<std::optional<bool>(ltl::Formula)>& possible) {
    if (!claims_.has("reason")) return;
    std::string from_there = head;
    for (std::size_t i = 0; i < starts.size(); ++i)
      from_there += (i == 0 ? "" : between) + plan::show(map_.pose(starts[i]));
    const auto never_seen = [&](ltl::Formula f) {
      std::vector<std::string> out = plan::never_seen(plan::mdp_of(map_, starts.front()), {f});
      for (const plan::PoseId start : starts) {
        const auto here = plan::never_seen(plan::mdp_of(map_, start), {f});
        out.erase(std::remove_if(out.begin(), out.end(),
                                 [&](const auto& n) { return std::find(here.begin(), here.end(), n) == here.end(); }),
                  out.end());
      }
      return out;
    };
    examine_reason(claims_, claims_.text("reason"), *formula_,
                   {{from_there + " satisfies "}, possible, never_seen, limits_});
  }

  std::vector<plan::PoseId> told_starts() {
    std::vector<plan::PoseId> starts;
    if (!claims_.has("starts")) return starts;
    claims_.member("starts");
    in_.each(answer_, "", "starts", [&](const Value& one, const std::string& path) {
      if (!one.is_array() || one.size() != 3) in_.fail(path, "expected a pose [x,y,heading]");
      const auto pose = map_.find({in_.integer(one[0], path), in_.integer(one[1], path), in_.integer(one[2], path)});
      if (!pose) in_.fail(path, "there is no such place on map " + map_.name());
      starts.push_back(*pose);
    });
    if (!start_ && !starts.empty()) start_ = starts.front();
    return starts;
  }

  std::optional<bool> has_route(const std::vector<plan::PoseId>& starts, ltl::Formula f) const {
    const auto least = plan::least_by_progression(f, map_, starts, limits_);
    return least ? std::optional(least->actions.has_value()) : std::nullopt;
  }

  void infeasible() {
    claims_.add(!claims_.has("route"), "an infeasible answer has no route");
    no_route();
  }

  void no_route() {
    const std::vector<plan::PoseId> starts = told_starts();
    if (starts.empty()) in_.fail("starts", "expected a pose from which there is no route");
    if (!formula_) return claims_.add(std::nullopt, "no route from these starts is accepted");
    const auto possible = [&](ltl::Formula f) { return has_route(starts, f); };
    const auto found = possible(*formula_);
    claims_.add(found ? std::optional(!*found) : std::nullopt,
                "no route from these starts satisfies " + ltl::print(*formula_));
    reason("no route from ", " or ", starts, possible);
  }

  Claims& claims_;
  const plan::JsonReader& in_;
  const Value& answer_;
  const Text& text_;
  const plan::Map& map_;
  TextReferee& texts_;
  const ltl::Limits& limits_;
  ltl::Arena arena_;
  std::optional<ltl::Formula> formula_;
  std::optional<plan::PoseId> start_;  // of a route, or the first of those without one
};

}  // namespace

void examine_on_map(Claims& claims, const plan::JsonReader& in, const Value& answer, const Text& text,
                    const plan::Map& map, TextReferee& texts, const ltl::Limits& limits) {
  OnMap(claims, in, answer, text, map, texts, limits).examine();
}

}  // namespace waymark::tools
