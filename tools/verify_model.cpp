#include "tools/verify_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/drop_conjuncts.hpp"
#include "libplan/world/json_reader.hpp"
#include "tools/named_walks.hpp"
#include "tools/shell/json.hpp"
#include "tools/verify_order.hpp"
#include "tools/verify_reason.hpp"
#include "tools/verify_value.hpp"
#include "tools/walk_referee.hpp"

namespace waymark::tools {
namespace {

using Value = Claims::Value;

constexpr std::array other_queries{"cycle", "lasso", "discounted"};

template <class Model>
class OnModel {
 public:
  OnModel(Claims& claims, const plan::JsonReader& in, const Value& answer, const plan::PlanningCase& of,
          const Model& model, const ltl::Limits& limits)
      : claims_(claims),
        in_(in),
        answer_(answer),
        case_(of),
        model_(model),
        limits_(limits),
        arena_(model.letters().vocabulary()) {}

  void examine() {
    query_ = claims_.text("query");
    if (value_in_words(query_).empty() &&
        std::find(other_queries.begin(), other_queries.end(), query_) == other_queries.end())
      in_.fail("query", "there is no query \"" + query_ + '"');
    read_formula();
    status_ = claims_.text("status");
    value_ = claims_.number("value"), lower_ = claims_.number("lower"), upper_ = claims_.number("upper");
    if (!status()) return;
    if (claims_.has("cycle") || claims_.has("prefix") || (query_ == "lasso" && status_ == "solved")) lasso();
    if (claims_.has("routes")) routes();
    if (status_ != "exhausted") value();
    reason();
  }

 private:
  bool is_probability() const { return query_[0] == 'p'; }

  void read_formula() {
    if (!claims_.has("formula") || !claims_.has("semantics")) return;  // an automaton, or another logic
    const std::string semantics = claims_.text("semantics");
    if (semantics != "finite" && semantics != "infinite") in_.fail("semantics", "expected \"finite\" or \"infinite\"");
    semantics_ = semantics == "finite" ? ltl::Semantics::Finite : ltl::Semantics::Infinite;
    // What the model does not have never holds.
    formula_ = ltl::parse(claims_.text("formula"), arena_, {.unknown = ltl::Unknown::Add});
  }

  // Does the status go with the value and the walks? Where it does not, nothing else is looked at.
  bool status() {
    if (status_ == "exhausted") {
      const bool says_nothing = !value_ && !lower_ && !upper_ && !claims_.has("routes") && !claims_.has("cycle");
      claims_.add(says_nothing, "an answer that was given up claims nothing");
      return says_nothing;
    }
    const bool bounded = value_ && lower_ && upper_;
    bool fits = bounded;
    if (status_ == "infeasible")  // nothing to gain, or no finite cost
      fits = bounded && (query_ == "pmax" || query_ == "discounted" ? *upper_ == 0 : std::isinf(*lower_)) &&
             !claims_.has("routes") && !claims_.has("cycle") && query_ != "pmin" && query_ != "rmax";
    else if (status_ == "solved")
      fits = bounded &&
             (query_ == "pmax" || query_ == "discounted" ? *upper_ > 0 : query_ == "rmax" || std::isfinite(*lower_));
    else
      in_.fail("status", "expected \"solved\", \"infeasible\" or \"exhausted\"");
    claims_.add(fits, "status \"" + status_ + "\" goes with the value");
    if (!bounded) return false;
    bounds();
    return fits;
  }

  void bounds() {
    claims_.add(*lower_ <= *value_ && *value_ <= *upper_, "the value lies between its bounds");
    claims_.add(std::isinf(*lower_) ? *value_ == *lower_ : is_close(*value_, *lower_ + (*upper_ - *lower_) / 2),
                "the value is in their middle");
    claims_.add(*lower_ >= 0 && (!(is_probability() || query_ == "discounted") || *upper_ <= 1),
                is_probability() ? "the bounds are probabilities" : "the bounds are not negative");
  }

  // ---- walks

  ltl::Letter first_letter() const { return model_.letters()[model_.initial_letter()]; }

  // The walks that are told and cost what is said.
  std::optional<std::vector<ToldWalk>> walks(const Value& route, const std::string& what, std::uint32_t from) {
    const auto places = in_.strings(in_.member(route, what, "places"), what + ".places");
    const auto actions = in_.strings(in_.member(route, what, "actions"), what + ".actions");
    const double said = in_.number(in_.member(route, what, "cost"), what + ".cost");
    claims_.only(route, what, {"places", "actions", "cost"});
    auto told = told_walks(model_, from, places, actions);
    if (!told) {
      claims_.add(std::nullopt, what + " stands for more walks than are looked at");
      return std::nullopt;
    }
    claims_.add(!told->empty(), "every step of " + what + " is one of the model");
    if (told->empty()) return std::nullopt;
    told->erase(std::remove_if(told->begin(), told->end(), [&](const ToldWalk& w) { return !is_close(w.cost, said); }),
                told->end());
    claims_.add(!told->empty(), "the cost of " + what + " is " + Json(said).text());
    return told->empty() ? std::nullopt : std::optional(std::move(*told));
  }

  std::vector<ltl::Letter> word(const ToldWalk& walk) const {
    std::vector<ltl::Letter> letters{first_letter()};
    letters.insert(letters.end(), walk.letters.begin(), walk.letters.end());
    return letters;
  }

  void lasso() {
    if (query_ != "lasso") return claims_.add(false, "query " + query_ + " is answered without a lasso");
    const Value &before = claims_.member("prefix"), &again = claims_.member("cycle");
    const double rounds = in_.number(claims_.member("rounds"), "rounds");
    const std::string order = claims_.text("order");
    if (order != "prefix" && order != "cycle" && order != "mean")
      in_.fail("order", "expected \"prefix\", \"cycle\" or \"mean\"");
    const auto prefixes = walks(before, "prefix", model_.initial());
    if (!prefixes) return;
    const auto cycles = walks(again, "cycle", prefixes->front().end);
    if (!cycles) return;
    const double prefix_cost = prefixes->front().cost, cycle_cost = cycles->front().cost;
    const double first = order == "prefix" ? prefix_cost : order == "cycle" ? cycle_cost : cycle_cost / rounds;
    claims_.add(is_close(*value_, first) && *lower_ == *upper_,
                "the value is what the order \"" + order + "\" puts first");
    bool closes = false;
    std::optional<ltl::Lasso> satisfying;
    for (const ToldWalk& prefix : *prefixes)
      for (const ToldWalk& cycle : *cycles) {
        if (cycle.letters.empty() || cycle.end != prefix.end) continue;
        closes = true;
        ltl::Lasso told(word(prefix), cycle.letters);
        if (formula_ && !satisfying && ltl::holds(told, *formula_)) satisfying = std::move(told);
      }
    claims_.add(closes, "the cycle ends where it begins");
    if (!closes || !formula_)
      return claims_.add(std::nullopt, "no other walk comes first in the order \"" + order + '"');
    claims_.add(satisfying.has_value(), "the walk without end satisfies " + ltl::print(*formula_));
    if (satisfying)
      examine_order(claims_, order, {prefix_cost, cycle_cost, rounds, *satisfying}, case_, *formula_, limits_);
  }

  void routes() {
    if (query_ != "steps" && query_ != "rmin")
      return claims_.add(false, "query " + query_ + " is answered without routes");
    claims_.member("routes");
    std::vector<std::pair<std::string, double>> listed;  // as they are told, and their costs
    bool sorted = true, all_there = true, none_twice = true;
    in_.each(answer_, "", "routes", [&](const Value& route, const std::string& path) {
      const bool first = listed.empty();
      const auto found = walks(route, path, model_.initial());
      if (!found) return void(all_there = false);
      const double cost = found->front().cost;
      sorted = sorted && (first || cost >= listed.back().second - 1e-9);
      listed.emplace_back(route.dump(), cost);
      std::size_t ways = 0;
      for (const ToldWalk& walk : *found) ways += walk.ways;
      none_twice =
          none_twice && static_cast<std::size_t>(std::count(listed.begin(), listed.end(), listed.back())) <= ways;
      if (first) claims_.add(is_close(*value_, cost), "the value is the cost of the first route");
      if (formula_ && semantics_ == ltl::Semantics::Finite) satisfies(*found, path);
    });
    if (listed.empty() && all_there) in_.fail("routes", "expected a route");
    claims_.add(sorted, "the routes are in the order of their costs");
    claims_.add(none_twice, "no route is listed twice");
    const auto asked = static_cast<double>(in_.integer(claims_.member("asked"), "asked"));
    const auto count = static_cast<double>(listed.size());
    claims_.add(count <= asked, "no more routes are listed than were asked for");
    if (all_there && asked > 1) none_is_missing(listed, count < asked);
  }

  void satisfies(const std::vector<ToldWalk>& walks, const std::string& path) {
    const bool holds = std::any_of(walks.begin(), walks.end(), [&](const ToldWalk& walk) {
      const std::vector<ltl::Letter> letters = word(walk);
      for (auto end = letters.begin() + 1; end != letters.end(); ++end)
        if (ltl::holds(ltl::Trace({letters.begin(), end}), *formula_)) return false;
      return ltl::holds(ltl::Trace(letters), *formula_);
    });
    claims_.add(holds,
                "the word of " + path + " satisfies " + ltl::print(*formula_) + ", at its end for the first time");
  }

  // Of the routes as dear as the last one, the list need not have all, unless it has fewer than were asked for. Two
  // choices that lead to one place make routes that the list may tell as one.
  void none_is_missing(const std::vector<std::pair<std::string, double>>& listed, bool all_asked_for) {
    const double last = listed.back().second;
    const auto cheaper = static_cast<double>(std::count_if(listed.begin(), listed.end(), [&](const auto& l) {
      return all_asked_for || (l.second < last && !is_close(l.second, last));
    }));
    std::optional<double> all;
    if (const Judged* found = judged(); found != nullptr && !has_parallels())
      all = all_asked_for ? std::optional(count_walks(found->product))
                          : count_walks(found->product, last, limits_.states);
    claims_.add(all ? std::optional(*all == cheaper) : std::nullopt,
                all_asked_for ? "there is no further route" : "no route that costs less than the last one is missing");
  }

  bool has_parallels() const {
    for (std::uint32_t s = 0; s < model_.states(); ++s) {
      std::set<std::uint32_t> targets;
      for (std::uint32_t k = 0; k < model_.choices(s); ++k)
        if (!targets.insert(model_.outcome(s, k, 0).target).second) return true;
    }
    return false;
  }

  // ---- values

  // Null: there is no formula, progression does not settle it, or a limit was met. Made once.
  const Judged* judged() {
    if (!formula_) return nullptr;
    if (!tried_) judged_ = judge(case_, *formula_, semantics_, query_, limits_);
    tried_ = true;
    return judged_ ? &*judged_ : nullptr;
  }

  void value() {
    if (query_ == "lasso" && status_ == "solved") return;  // by its walk
    const bool by_steps = query_ == "steps" && !model_.is_deterministic();
    const Judged* found = value_in_words(query_).empty() || by_steps ? nullptr : judged();
    if (found != nullptr)
      return compare(claims_, std::string(value_in_words(query_)), *lower_, *upper_,
                     bracket_of(*found, query_, limits_.stop));
    const std::string claim = query_ + " lies between " + Json(*lower_).text() + " and " + Json(*upper_).text();
    std::optional<bool> holds;
    if (status_ == "infeasible" && formula_)
      if (const auto met = can_be_met(*formula_)) holds = !*met;
    claims_.add(holds, claim);
  }

  // ---- why there is none

  std::optional<bool> can_be_met(ltl::Formula f) const {
    if (query_ == "lasso") return has_walk(case_, f, limits_);
    if (query_ == "steps" && !model_.is_deterministic()) return std::nullopt;
    return is_possible(case_, f, semantics_, query_, limits_);
  }

  void reason() {
    if (status_ != "infeasible" || !formula_) return;
    const bool is_cost = query_ == "rmin" || query_ == "steps";
    ReasonReferee referee{{"no strategy has a chance to satisfy "},
                          [&](ltl::Formula f) { return can_be_met(f); },
                          [&](ltl::Formula f) { return plan::never_seen(model_, {f}); },
                          limits_};
    if (query_ == "lasso") referee.heads = {"no walk without end satisfies "};
    if (is_cost)
      referee.heads = {"no strategy is sure to satisfy ",
                       "no strategy is sure to come to a finite prefix that decides ", "no route satisfies "};
    if (claims_.has("reason")) examine_reason(claims_, claims_.text("reason"), *formula_, referee);
    if (claims_.has("dropped"))
      examine_dropped(claims_, in_.strings(claims_.member("dropped"), "dropped"), *formula_, referee);
  }

  Claims& claims_;
  const plan::JsonReader& in_;
  const Value& answer_;
  const plan::PlanningCase& case_;
  const Model& model_;
  const ltl::Limits& limits_;
  ltl::Arena arena_;
  std::string query_, status_;
  std::optional<double> value_, lower_, upper_;  // absent: null
  ltl::Semantics semantics_ = ltl::Semantics::Infinite;
  std::optional<ltl::Formula> formula_;
  bool tried_ = false;
  std::optional<Judged> judged_;
};

}  // namespace

void examine_on_model(Claims& claims, const plan::JsonReader& in, const Value& answer, const plan::PlanningCase& model,
                      const ltl::Limits& limits) {
  std::visit([&](const auto& m) { OnModel(claims, in, answer, model, m, limits).examine(); }, model.model);
}

}  // namespace waymark::tools
