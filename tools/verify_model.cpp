#include "tools/verify_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <utility>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/fragment.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/world/json_reader.hpp"
#include "tools/shell/json.hpp"
#include "tools/value_from_below.hpp"

namespace waymark::tools {
namespace {

using Value = plan::JsonReader::Value;

bool close(double a, double b) {
  return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

template <class Model>
class OnModel {
 public:
  OnModel(const plan::JsonReader& in, const Value& answer, const plan::PlanningCase& of, const Model& model,
          const ltl::Limits& limits)
      : in_(in), answer_(answer), case_(of), model_(model), limits_(limits), arena_(model.letters().vocabulary()) {}

  std::vector<Claim> examine() {
    const std::string query = in_.string(in_.member(answer_, "", "query"), "query");
    bounds(query.starts_with("p"));
    const bool read = answer_.contains("formula") && answer_.contains("semantics");  // no automaton, no other logic
    const bool finite = read && in_.string(answer_["semantics"], "semantics") == "finite";
    if (read)  // what the model does not have never holds
      formula_ = ltl::parse(in_.string(answer_["formula"], "formula"), arena_, {.unknown = ltl::Unknown::Add});
    if (answer_.contains("cycle")) lasso();
    if (answer_.contains("routes")) routes(query == "steps" && finite);
    if (query == "steps" && finite) least();
    if (formula_ && !finite) value(query);
    return std::move(claims_);
  }

 private:
  struct Walk {
    std::uint32_t end = 0;
    std::vector<ltl::Letter> letters = {};  // of the steps
    double cost = 0;
  };

  void claim(std::optional<bool> holds, std::string text) { claims_.push_back({std::move(text), holds}); }

  // A cost that no strategy keeps finite is a text; an answer that was given up has none.
  std::optional<double> number(const char* key) const {
    const Value& value = in_.member(answer_, "", key);
    if (value.is_null()) return std::nullopt;
    if (value.is_string() && value == "inf") return INFINITY;
    return in_.number(value, key);
  }

  void bounds(bool probability) {
    const auto value = number("value"), lower = number("lower"), upper = number("upper");
    if (!value || !lower || !upper) return;
    claim(*lower <= *value && *value <= *upper, "the value lies between its bounds");
    if (probability) claim(*lower >= 0 && *upper <= 1, "the bounds are probabilities");
  }

  // The walk from a state by the names of places and actions; nothing: a step that the model does not have.
  std::optional<Walk> walk(const Value& route, const std::string& path, std::uint32_t from) const {
    const auto places = in_.strings(in_.member(route, path, "places"), path + ".places");
    const auto actions = in_.strings(in_.member(route, path, "actions"), path + ".actions");
    if (places.size() != actions.size() + 1 || model_.name(from) != places[0]) return std::nullopt;
    Walk out{from};
    for (std::size_t i = 0; i < actions.size(); ++i)
      if (!step(out, actions[i], places[i + 1])) return std::nullopt;
    return out;
  }

  bool step(Walk& on, const std::string& action, const std::string& place) const {
    for (std::uint32_t k = 0; k < model_.choices(on.end); ++k) {
      if (model_.action(on.end, k) != action || model_.outcome_count(on.end, k) != 1) continue;
      const plan::ModelOutcome outcome = model_.outcome(on.end, k, 0);
      if (model_.name(outcome.target) != place) continue;
      on.cost += model_.cost(on.end, k);
      on.letters.push_back(model_.letters()[outcome.letter]);
      on.end = outcome.target;
      return true;
    }
    return false;
  }

  bool steps_and_cost(const std::optional<Walk>& walked, const Value& route, const std::string& what) {
    claim(walked.has_value(), "every step of " + what + " is one of the model");
    if (!walked) return false;
    const double said = in_.number(in_.member(route, what, "cost"), "cost");
    claim(close(said, walked->cost), "the cost of " + what + " is " + Json(said).text());
    return true;
  }

  ltl::Letter first_letter() const { return model_.letters()[model_.initial_letter()]; }

  void lasso() {
    const Value &before = in_.member(answer_, "", "prefix"), &again = in_.member(answer_, "", "cycle");
    const auto prefix = walk(before, "prefix", model_.initial());
    if (!steps_and_cost(prefix, before, "the prefix")) return;
    const auto cycle = walk(again, "cycle", prefix->end);
    if (!steps_and_cost(cycle, again, "the cycle")) return;
    const bool closes = !cycle->letters.empty() && cycle->end == prefix->end;
    claim(closes, "the cycle ends where it begins");
    if (!closes || !formula_) return;
    std::vector<ltl::Letter> letters{first_letter()};
    letters.insert(letters.end(), prefix->letters.begin(), prefix->letters.end());
    claim(ltl::holds(ltl::Lasso(letters, cycle->letters), *formula_),
          "the walk without end satisfies " + ltl::print(*formula_));
  }

  void routes(bool finite) {
    double last = 0;
    bool first = true, sorted = true;
    in_.each(answer_, "", "routes", [&](const Value& route, const std::string& path) {
      const auto walked = walk(route, path, model_.initial());
      if (!steps_and_cost(walked, route, first ? "the route" : path)) return;
      sorted = sorted && walked->cost >= last - 1e-9;
      last = walked->cost;
      if (const auto value = number("value"); first && value)
        claim(close(*value, walked->cost), "the value is the cost of the first route");
      first = false;
      if (!finite || !formula_) return;
      std::vector<ltl::Letter> letters{first_letter()};
      letters.insert(letters.end(), walked->letters.begin(), walked->letters.end());
      claim(ltl::holds(ltl::Trace(letters), *formula_), "its word satisfies " + ltl::print(*formula_));
    });
    claim(sorted, "the routes are in the order of their costs");
  }

  // Dijkstra's algorithm over pairs of a state and what remains of the formula. Infinite: proved that there is no word.
  std::optional<double> least_by_progression() {
    using Pair = std::pair<std::uint32_t, ltl::Formula>;
    std::map<Pair, double> best;
    using Entry = std::pair<double, std::size_t>;
    std::vector<std::map<Pair, double>::iterator> met;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto meet = [&](std::uint32_t state, ltl::Formula rest, double cost) {
      const auto [at, fresh] = best.emplace(Pair{state, rest}, cost);
      if (!fresh && at->second <= cost) return;
      at->second = cost;
      met.push_back(at);
      open.emplace(cost, met.size() - 1);
    };
    meet(model_.initial(), ltl::progress(*formula_, first_letter()), 0);
    while (!open.empty()) {
      const auto [cost, number] = open.top();
      open.pop();
      const auto [state, rest] = met[number]->first;
      if (met[number]->second < cost) continue;
      if (ltl::accepts_empty(rest)) return cost;
      if (best.size() > limits_.states || limits_.stop.stop_requested()) return std::nullopt;
      for (std::uint32_t k = 0; k < model_.choices(state); ++k) {
        const plan::ModelOutcome outcome = model_.outcome(state, k, 0);
        meet(outcome.target, ltl::progress(rest, model_.letters()[outcome.letter]), cost + model_.cost(state, k));
      }
    }
    return INFINITY;
  }

  void least() {
    if (!formula_ || !model_.is_deterministic()) return;
    const bool infeasible = in_.string(in_.member(answer_, "", "status"), "status") == "infeasible";
    const auto value = number("value");
    if (!infeasible && !value) return;
    const auto found = least_by_progression();
    if (infeasible)
      claim(found ? std::optional(std::isinf(*found)) : std::nullopt, "no route satisfies " + ltl::print(*formula_));
    else
      claim(found ? std::optional(close(*found, *value)) : std::nullopt, "the least cost is " + Json(*value).text());
  }

  // What progression decides: of co-safe formulas it proves lower bounds of probabilities, of safe ones upper bounds
  // (by the negation), and the bound on the other side is refuted where the value is beyond it.
  void value(const std::string& query) {
    const auto lower = number("lower"), upper = number("upper");
    if (!lower || !upper) return;
    const ltl::Fragments known = ltl::fragments(*formula_, ltl::Semantics::Infinite);
    if (query == "rmin") {
      if (std::isfinite(*lower)) bounded("the least expected cost", FromBelow::LeastCost, *formula_, *lower, *upper, 0);
    } else if (query == "pmax" || query == "pmin") {
      const bool greatest = query == "pmax";
      const std::string what = greatest ? "the greatest probability" : "the least probability";
      if (known.cosafety)
        bounded(what, greatest ? FromBelow::GreatestProbability : FromBelow::LeastProbability, *formula_, *lower,
                *upper, 0);
      else if (known.safety)
        bounded(what, greatest ? FromBelow::LeastProbability : FromBelow::GreatestProbability, ltl::negate(*formula_),
                *lower, *upper, 1);
    }
  }

  // `whole`: 0, or 1 where the value is what is missing to 1.
  void bounded(const std::string& what, FromBelow how, ltl::Formula formula, double lower, double upper, int whole) {
    const double near = whole == 0 ? lower : 1 - upper, far = whole == 0 ? upper : 1 - lower;
    const double slack = 1e-6 * std::max(1.0, std::abs(near));
    const auto found = value_from_below(case_, formula, how, far + slack, limits_);
    const std::string proved = Json(whole == 0 ? lower : upper).text(), other = Json(whole == 0 ? upper : lower).text();
    claim(found && *found >= near - slack ? std::optional(true) : std::nullopt,
          what + (whole == 0 ? " is at least " : " is at most ") + proved + ", up to 10⁻⁶");
    if (found && *found >= far + slack) claim(false, what + (whole == 0 ? " is at most " : " is at least ") + other);
  }

  const plan::JsonReader& in_;
  const Value& answer_;
  const plan::PlanningCase& case_;
  const Model& model_;
  const ltl::Limits& limits_;
  ltl::Arena arena_;
  std::optional<ltl::Formula> formula_;
  std::vector<Claim> claims_;
};

}  // namespace

std::vector<Claim> claims_on_model(const Text& text, const plan::PlanningCase& model, const ltl::Limits& limits) {
  const plan::JsonReader in(text.text, text.source, text.line);
  const Value answer = in.parse();
  return std::visit([&](const auto& m) { return OnModel(in, answer, model, m, limits).examine(); }, model.model);
}

}  // namespace waymark::tools
