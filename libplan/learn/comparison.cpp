#include "libplan/learn/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace waymark::plan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t replays = 32;  // of the tabular learners that replay, after every step

// The steps at the first checkpoint where `there` holds, after some learning.
template <class Predicate>
double first_at(const LearningCurve& curve, Predicate&& there) {
  for (const Checkpoint& checkpoint : curve.checkpoints)
    if (checkpoint.steps > 0 && there(checkpoint.value)) return static_cast<double>(checkpoint.steps);
  return infinity;
}

// The steps at the checkpoint from which on `there` holds at all of them.
template <class Predicate>
double always_from(const LearningCurve& curve, Predicate&& there) {
  double from = infinity;
  for (const Checkpoint& checkpoint : curve.checkpoints) {
    if (!there(checkpoint.value))
      from = infinity;
    else if (checkpoint.steps > 0 && from == infinity)
      from = static_cast<double>(checkpoint.steps);
  }
  return from;
}

}  // namespace

std::vector<Method> learning_methods() {
  return {
      {"q-learning", "Q-learning in tables", QLearning{}},
      {"counterfactual", "Q-learning; every experience updates all states of the automaton",
       QLearning{.counterfactual = true, .replays = replays}},
      {"shaped", "the same, shaped by the automaton's distance to acceptance",
       QLearning{.counterfactual = true, .shaped = true, .replays = replays}},
      {"shaped-only", "Q-learning shaped by the automaton's distance to acceptance", QLearning{.shaped = true}, false},
      {"lpopl", "one value function for each progressed formula, sub-tasks easiest first",
       QLearning{.counterfactual = true, .curriculum = true, .replays = replays}},
      {"dqn-objects", "deep Q-learning on distances from the pose to objects", DqnMethod{{}, Sight::Objects}},
      {"dqn-landmarks", "the same, to floors and paintings too", DqnMethod{{}, Sight::Landmarks}},
      {"dqn-literal", "the same, distances from the place whatever the heading", DqnMethod{{}, Sight::Literal}},
      {"dqn-double", "dqn-landmarks with double Q", DqnMethod{{.double_q = true}}, false},
      {"dqn-prioritised", "dqn-landmarks with prioritised replay", DqnMethod{{.prioritised = true}}, false},
      {"dqn-trees", "dqn-landmarks that reads the progressed formula", DqnMethod{{}, Sight::Landmarks, true}, false},
  };
}

LearningTask::LearningTask(TabularProduct product, std::optional<ltl::Formula> formula, double discount)
    : product_(std::move(product)) {
  if (formula) trees_ = trees_of(product_.task, *formula);
  const auto begin = std::chrono::steady_clock::now();
  optimum_ = plan::optimum(product_, {.discount = discount});
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

LearningTask::LearningTask(const Map& map, const automata::Dfa& dfa, std::optional<ltl::Formula> formula,
                           std::span<const PoseId> starts, const LearningTaskOptions& options)
    : LearningTask(tabulate(map, dfa, starts, options.noise), formula, options.discount) {
  for (const Sight sight : {Sight::Objects, Sight::Landmarks, Sight::Literal})
    observations_[static_cast<std::size_t>(sight)] = observe(map, sight);
}

template <class Model>
LearningTask::LearningTask(const Model& model, const automata::Dfa& dfa, std::optional<ltl::Formula> formula,
                           const LearningTaskOptions& options)
    : LearningTask(compose(model, tabulate(dfa, model.letters())), formula, options.discount) {
  observations_[static_cast<std::size_t>(Sight::Landmarks)] = observe(model);
}

template LearningTask::LearningTask(const Mdp&, const automata::Dfa&, std::optional<ltl::Formula>,
                                    const LearningTaskOptions&);
template LearningTask::LearningTask(const GridWorld&, const automata::Dfa&, std::optional<ltl::Formula>,
                                    const LearningTaskOptions&);

bool LearningTask::allows(const Method& method) const {
  if (const auto* dqn = std::get_if<DqnMethod>(&method.how))
    return seen(dqn->sight).has_value() && (!dqn->trees || trees_.has_value());
  return true;
}

LearningCurve LearningTask::run(const Method& method, const Training& training) const {
  if (const auto* q_learning = std::get_if<QLearning>(&method.how)) return learn(product_, *q_learning, training).curve;
  const auto& [dqn, sight, trees] = std::get<DqnMethod>(method.how);
  return learn(product_, {&seen(sight)->by_position, trees ? &*trees_ : nullptr}, dqn, training);
}

double success(const PolicyValue& value, const PolicyValue& optimum) {
  return optimum.probability > 0 ? std::min(1.0, value.probability / optimum.probability) : 0;
}

double score(const PolicyValue& value, const PolicyValue& optimum) {
  if (value.probability == 0) return 0;
  const double cheaper = value.cost > 0 ? std::min(1.0, optimum.cost / value.cost) : 1;
  return success(value, optimum) * cheaper;
}

Verdict judge(const LearningCurve& curve, const PolicyValue& optimum, double seconds) {
  const PolicyValue& last = curve.checkpoints.back().value;
  Verdict verdict{success(last, optimum), score(last, optimum)};
  verdict.cost_ratio = optimum.cost > 0 ? last.cost / optimum.cost : 1;
  verdict.to_90 = first_at(curve, [&](const PolicyValue& v) { return score(v, optimum) >= 0.9; });
  const auto is_optimal = [&](const PolicyValue& v) { return v.value >= optimum.value * (1 - 1e-9); };
  verdict.to_optimum = first_at(curve, is_optimal);
  verdict.to_stay = always_from(curve, is_optimal);
  verdict.updates = static_cast<double>(curve.updates);
  verdict.seconds = seconds;
  return verdict;
}

Summary summarise(std::span<const Verdict> verdicts) {
  const auto all = [&](double Verdict::*member) {
    std::vector<double> values;
    for (const Verdict& verdict : verdicts) values.push_back(verdict.*member);
    return values;
  };
  Summary summary;
  summary.runs = verdicts.size();
  summary.success = bootstrap_mean(all(&Verdict::success));
  summary.score = bootstrap_mean(all(&Verdict::score));
  summary.cost_ratio = bootstrap_median(all(&Verdict::cost_ratio));
  summary.to_90 = bootstrap_median(all(&Verdict::to_90));
  summary.to_optimum = bootstrap_median(all(&Verdict::to_optimum));
  summary.to_stay = bootstrap_median(all(&Verdict::to_stay));
  const auto came =
      std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.to_optimum < infinity; });
  summary.optimal = rate(static_cast<std::size_t>(came), verdicts.size());
  summary.updates = median(all(&Verdict::updates));
  summary.seconds = median(all(&Verdict::seconds));
  return summary;
}

std::vector<CurvePoint> mean_curve(std::span<const LearningCurve> curves, const PolicyValue& optimum) {
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < curves[0].checkpoints.size(); ++i) {
    std::vector<double> scores;
    for (const LearningCurve& curve : curves) scores.push_back(score(curve.checkpoints.at(i).value, optimum));
    points.push_back({curves[0].checkpoints[i].steps, bootstrap_mean(scores)});
  }
  return points;
}

}  // namespace waymark::plan
