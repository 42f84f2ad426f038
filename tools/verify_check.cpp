#include "tools/verify_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/world/json_reader.hpp"
#include "tools/named_walks.hpp"
#include "tools/shell/json.hpp"
#include "tools/verify_value.hpp"
#include "tools/walk_referee.hpp"

namespace waymark::tools {
namespace {

using Value = Claims::Value;

template <class Model>
class OfRuns {
 public:
  OfRuns(Claims& claims, const plan::JsonReader& in, const Value& answer, const plan::PlanningCase& of,
         const Model& model, const ltl::Limits& limits)
      : claims_(claims),
        in_(in),
        answer_(answer),
        case_(of),
        model_(model),
        limits_(limits),
        arena_(model.letters().vocabulary()),
        formula_(ltl::parse(claims.text("formula"), arena_, {.unknown = ltl::Unknown::Reject})) {}

  void examine() {
    claims_.expect_text("model", case_.name);
    claims_.expect_text("semantics", "infinite");
    holds_ = in_.truth(claims_.member("holds"), "holds");
    const bool chance = !model_.is_deterministic();
    if (chance)
      probability();
    else if (!holds_)
      lasso();
    const bool says_more = claims_.has("prefix") || claims_.has("cycle") || claims_.has("paths");
    if (holds_) claims_.add(!says_more, "an answer that holds has no counterexample");
    claims_.add(agrees(chance), std::string("every run satisfies ") + ltl::print(formula_) + (holds_ ? "" : ": no"));
    if (chance && !holds_) paths();
  }

 private:
  std::optional<bool> agrees(bool chance) const {
    const auto found = chance ? holds_with_chance() : violated_by_none();
    return found ? std::optional(*found == holds_) : std::nullopt;
  }
  std::optional<bool> violated_by_none() const {
    const auto found = has_walk(case_, ltl::negate(formula_), limits_);
    return found ? std::optional(!*found) : std::nullopt;
  }
  // With probability 1 under every strategy.
  std::optional<bool> holds_with_chance() const {
    const auto judged = judge(case_, formula_, ltl::Semantics::Infinite, "pmin", limits_);
    if (!judged) return violated_by_none() == true ? std::optional(true) : std::nullopt;
    const std::vector<bool>& goal = judged->product.goal;
    if (judged->negated) return std::find(goal.begin(), goal.end(), true) == goal.end();
    return !std::isinf(bracket(judged->product, Optimum::GreatestCost, limits_.stop).below);
  }

  void probability() {
    const Value& said = claims_.member("probability");
    const double lower = in_.number(in_.member(said, "probability", "lower"), "probability.lower"),
                 upper = in_.number(in_.member(said, "probability", "upper"), "probability.upper");
    claims_.only(said, "probability", {"lower", "upper"});
    claims_.add(0 <= lower && lower <= upper && upper <= 1, "the bounds are probabilities, in order");
    claims_.add(holds_ == (lower == 1), "the bounds go with the answer");
    if (const auto judged = judge(case_, formula_, ltl::Semantics::Infinite, "pmin", limits_))
      return compare(claims_, "the least probability", lower, upper, bracket_of(*judged, "pmin", limits_.stop));
    const bool is_one = lower == 1 && violated_by_none() == true;
    claims_.add(is_one ? std::optional(true) : std::nullopt,
                "the least probability lies between " + Json(lower).text() + " and " + Json(upper).text());
  }

  std::vector<ToldWalk> walks(const std::string& key, std::uint32_t from) {
    const Value& said = claims_.member(key.c_str());
    claims_.only(said, key, {"places", "actions"});
    auto told = told_walks(model_, from, in_.strings(in_.member(said, key, "places"), key + ".places"),
                           in_.strings(in_.member(said, key, "actions"), key + ".actions"));
    claims_.add(told ? std::optional(!told->empty()) : std::nullopt, "every step of " + key + " is one of the model");
    return told ? std::move(*told) : std::vector<ToldWalk>();
  }

  void lasso() {
    claims_.expect_text("certified_by", "definition");
    bool closes = false, violates = false;
    for (const ToldWalk& prefix : walks("prefix", model_.initial())) {
      std::vector<ltl::Letter> letters{model_.letters()[model_.initial_letter()]};
      letters.insert(letters.end(), prefix.letters.begin(), prefix.letters.end());
      for (const ToldWalk& cycle : walks("cycle", prefix.end)) {
        if (cycle.letters.empty() || cycle.end != prefix.end) continue;
        closes = true;
        violates = violates || !ltl::holds(ltl::Lasso(letters, cycle.letters), formula_);
      }
    }
    claims_.add(closes, "the cycle ends where it begins");
    claims_.add(violates, "the walk without end violates " + ltl::print(formula_));
    claims_.add(in_.truth(claims_.member("certified"), "certified") == violates, "certified");
  }

  // ---- paths of the worst strategy

  using Run = std::pair<std::uint32_t, ltl::Formula>;  // the state at its end, and what remains
  // By probability, how many; and of the last one what remains.
  struct Told {
    std::map<double, std::size_t> ways;
    bool violated = false;
  };

  void paths() {
    double sum = 0;
    std::map<std::pair<std::string, double>, std::size_t> listed;
    std::vector<std::vector<std::string>> tellings;
    in_.each(answer_, "", "paths", [&](const Value& one, const std::string& path) {
      claims_.only(one, path, {"places", "actions", "probability"});
      const double p = in_.number(in_.member(one, path, "probability"), path + ".probability");
      sum += p;
      const auto places = in_.strings(in_.member(one, path, "places"), path + ".places");
      const auto actions = in_.strings(in_.member(one, path, "actions"), path + ".actions");
      const Told told = told_runs(places, actions);
      const std::size_t times = ++listed[{one.dump(), p}];
      const bool there = std::any_of(told.ways.begin(), told.ways.end(),
                                     [&](const auto& way) { return is_close(way.first, p) && times <= way.second; });
      claims_.add(there, path + " is a path of the model, of probability " + Json(p).text());
      claims_.add(told.violated ? std::optional(true) : std::nullopt, "after " + path + " the formula is violated");
      for (const auto& other : tellings)
        if (other.size() < places.size() && std::equal(other.begin(), other.end(), places.begin()))
          claims_.add(std::nullopt, path + " is no continuation of another one");
      tellings.push_back(places);
    });
    claims_.member("paths");
    const double said = in_.number(claims_.member("probability_of_paths"), "probability_of_paths");
    claims_.add(is_close(said, sum), "probability_of_paths is " + Json(said).text());
    claims_.add(std::nullopt, "no other path is likelier");
  }

  // All outcome by outcome, with what remains of the formula.
  Told told_runs(const std::vector<std::string>& places, const std::vector<std::string>& actions) const {
    Told out;
    if (places.size() != actions.size() + 1 || model_.name(model_.initial()) != places[0]) return out;
    const auto after = [&](ltl::Formula f, plan::LetterId letter) {
      return ltl::progress(f, model_.letters()[letter], ltl::Semantics::Infinite);
    };
    using Runs = std::map<std::pair<Run, double>, std::size_t>;
    Runs runs{{{{model_.initial(), after(formula_, model_.initial_letter())}, 1.0}, 1}};
    for (std::size_t i = 0; i < actions.size() && runs.size() <= most_told_walks; ++i) {
      Runs longer;
      for (const auto& [run, ways] : runs)
        for (std::uint32_t k = 0; k < model_.choices(run.first.first); ++k) {
          if (model_.action(run.first.first, k) != actions[i]) continue;
          model_.for_each_outcome(run.first.first, k,
                                  [&, &at = run, n = ways](std::uint32_t to, plan::LetterId letter, double p) {
                                    if (model_.name(to) == places[i + 1])
                                      longer[{{to, after(at.first.second, letter)}, at.second * p}] += n;
                                  });
        }
      runs = std::move(longer);
    }
    out.violated = !runs.empty();
    for (const auto& [run, ways] : runs) {
      out.ways[run.second] += ways;
      out.violated = out.violated && run.first.second.op() == ltl::Op::False;
    }
    return out;
  }

  Claims& claims_;
  const plan::JsonReader& in_;
  const Value& answer_;
  const plan::PlanningCase& case_;
  const Model& model_;
  const ltl::Limits& limits_;
  mutable ltl::Arena arena_;
  ltl::Formula formula_;
  bool holds_ = false;
};

}  // namespace

void examine_check(Claims& claims, const plan::JsonReader& in, const Value& answer, const plan::PlanningCase& model,
                   const ltl::Limits& limits) {
  if (claims.member("formula").is_null())
    return claims.add(std::nullopt, "the automaton, which the answer does not bring, accepts every run");
  std::visit([&](const auto& m) { OfRuns(claims, in, answer, model, m, limits).examine(); }, model.model);
}

}  // namespace waymark::tools
