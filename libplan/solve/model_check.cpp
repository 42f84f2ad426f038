#include "libplan/solve/model_check.hpp"

#include <algorithm>
#include <queue>
#include <utility>
#include <variant>

#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::plan {
namespace {

// From 1 to what rounding leaves of it.
constexpr double all_but_certain = 1 - 1e-12;
constexpr std::size_t most_met = 1'000'000;  // beginnings of paths

template <class Model>
class PathSearch {
 public:
  using Pairs = ProductMdp<Model>;
  PathSearch(const Pairs& product, const Decided& decided) : product_(product), decided_(decided) {}

  // Best first: the likelihood of a path only falls, so paths are found in its order.
  void run(const ModelCheckOptions& options, ModelCheck& out) {
    met_.push_back({decided_.strategy.start, none, none, 1});
    open_.push({1, 0});
    while (!open_.empty() && out.paths.size() < options.paths && met_.size() < most_met &&
           !options.stop.stop_requested()) {
      const std::uint32_t at = open_.top().second;
      open_.pop();
      const Beginning here = met_[at];
      if (is_lost(here.pair)) {
        out.paths.push_back(path(at));
        out.probability_of_paths += here.probability;
      } else {
        go_on(at, here);
      }
    }
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  struct Beginning {
    std::uint32_t pair, from, choice;
    double probability;
  };

  bool is_lost(std::uint32_t pair) const {
    return product_.is_goal(product_.state(pair)) || decided_.values[pair] >= all_but_certain;
  }

  void go_on(std::uint32_t at, const Beginning& here) {
    const auto state = product_.state(here.pair);
    const std::uint32_t k = decided_.strategy.choice[here.pair];
    if (k == Strategy::none) return;
    product_.for_each_outcome(state, k, [&](std::uint32_t to, double p, bool) {
      if (to == Pairs::trap || !(decided_.values[to] > 0 || product_.is_goal(product_.state(to)))) return;
      met_.push_back({to, at, k, here.probability * p});
      open_.push({met_.back().probability, static_cast<std::uint32_t>(met_.size() - 1)});
    });
  }

  LikelyPath path(std::uint32_t end) const {
    LikelyPath out;
    out.probability = met_[end].probability;
    for (std::uint32_t i = end; i != none; i = met_[i].from) {
      const Beginning& here = met_[i];
      const Model& model = product_.model();
      const std::uint32_t place = product_.state(here.pair).place;
      if (here.from == none) {
        out.places.push_back(model.name(place));
        continue;
      }
      const auto before = product_.state(met_[here.from].pair);
      if (product_.is_jump(before, here.choice)) continue;  // which reads no letter
      out.places.push_back(model.name(place));
      out.actions.emplace_back(model.action(before.place, here.choice));
    }
    std::reverse(out.places.begin(), out.places.end());
    std::reverse(out.actions.begin(), out.actions.end());
    return out;
  }

  const Pairs& product_;
  const Decided& decided_;
  std::vector<Beginning> met_;
  std::priority_queue<std::pair<double, std::uint32_t>> open_;
};

// `violated`: of the runs that are to be found.
template <class Model>
std::optional<ModelCheck> checked_with_chance(const Model& model, const std::optional<TaskAutomaton>& violated,
                                              const ModelCheckOptions& options) {
  if (!violated) return std::nullopt;
  const TaskTable task = std::visit([&](const auto& a) { return TaskTable(a, model.letters()); }, *violated);
  const auto product = ProductMdp<Model>::explore(model, task, {.states = options.states, .stop = options.stop});
  if (!product) return std::nullopt;
  ModelCheck out;
  out.is_chain = true;
  for (std::uint32_t s = 0; s < model.states(); ++s) out.is_chain = out.is_chain && model.choices(s) <= 1;
  if (product->starts().empty() || qualitative(*product) == Qualitative::None) return out;
  const auto decided = greatest_probability(
      *product, {.tolerance = options.tolerance, .keep_values = true, .strategy = true, .stop = options.stop});
  if (!decided) return std::nullopt;
  out.holds = false;
  out.probability = uncrossed({1 - decided->value.upper, 1 - decided->value.lower});
  PathSearch<Model>(*product, *decided).run(options, out);
  return out;
}

std::optional<ModelCheck> checked_walks(CaseAnswer found) {
  if (found.status == CaseAnswer::Status::Exhausted) return std::nullopt;
  ModelCheck out;
  out.holds = !found.lasso;
  out.lasso = std::move(found.lasso);
  return out;
}

ltl::Limits automaton_limits(const ModelCheckOptions& options) {
  return {.states = options.states / 1000 + 1, .stop = options.stop};
}
CaseOptions case_options(const ModelCheckOptions& options) {
  return {.states = options.states, .explain = false, .stop = options.stop};
}

}  // namespace

std::optional<ModelCheck> check_model(const PlanningCase& model, const std::string& formula,
                                      const ModelCheckOptions& options) {
  return std::visit(
      [&](const auto& m) {
        if (m.is_deterministic())
          return checked_walks(answer(model,
                                      {"", "!(" + formula + ')', CaseTask::Logic::Ltl, CaseTask::Query::LeastLasso},
                                      case_options(options)));
        ltl::Arena arena(m.letters().vocabulary());
        const ltl::Formula violated = ltl::simplify(ltl::negate(ltl::parse(formula, arena)), ltl::Semantics::Infinite);
        return checked_with_chance(
            m,
            task_automaton(violated, CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability, automaton_limits(options)),
            options);
      },
      model.model);
}

std::optional<ModelCheck> check_model(const PlanningCase& model, const GivenAutomaton& specification,
                                      const ModelCheckOptions& options) {
  const auto violated = complement(specification, automaton_limits(options));
  if (!violated) return std::nullopt;
  return std::visit(
      [&](const auto& m) {
        if (m.is_deterministic())
          return checked_walks(answer(model, {"", "", CaseTask::Logic::Ltl, CaseTask::Query::LeastLasso}, *violated,
                                      case_options(options)));
        return checked_with_chance(
            m, task_automaton(*violated, CaseTask::Query::MaxProbability, automaton_limits(options)), options);
      },
      model.model);
}

}  // namespace waymark::plan
