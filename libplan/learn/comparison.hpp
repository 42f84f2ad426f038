// The methods side by side on one task: what each is called, how a run of it goes, what many runs come to.
//
// A policy is judged by its exact value (policy_value.hpp) against the optimum's:
//   success   its probability of acceptance, over the greatest there is for the discounted optimum
//   score     success · (cost of the optimum / cost of the policy given acceptance), in [0, 1]: 1 is a best route
// A run comes to 90 % at the first checkpoint whose score is at least 0.9, and to the optimum at the first whose
// discounted value is that of the optimum within 10⁻⁹; it stays there from the checkpoint on after which none is worse.
// The checkpoint before the first step does not count: nothing has been learnt there. Of many runs: estimates with 95 %
// intervals (statistics.hpp).
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "libplan/learn/dqn.hpp"
#include "libplan/learn/observations.hpp"
#include "libplan/learn/optimum.hpp"
#include "libplan/learn/q_learning.hpp"
#include "libplan/learn/statistics.hpp"

namespace waymark::plan {

struct DqnMethod {
  Dqn dqn;
  Sight sight = Sight::Landmarks;
  bool trees = false;  // else the task is one-hot
};

struct Method {
  std::string name, summary;
  std::variant<QLearning, DqnMethod> how;
  bool by_default = true;
};

// The table of learners: the one list of them.
std::vector<Method> learning_methods();

struct LearningTaskOptions {
  MapNoise noise = {};
  double discount = 0.9;
};

// One task on one map or model, made once and only read by the runs: any number of threads.
class LearningTask {
 public:
  // The formula of the automaton, for task trees, which read it. Without one they are not allowed.
  LearningTask(const Map& map, const automata::Dfa& dfa, std::optional<ltl::Formula> formula,
               std::span<const PoseId> starts, const LearningTaskOptions& options = {});
  // On a model, whose noise is its own. Networks see distances to every proposition there is: Sight::Landmarks.
  template <class Model>
  LearningTask(const Model& model, const automata::Dfa& dfa, std::optional<ltl::Formula> formula,
               const LearningTaskOptions& options = {});

  const TabularProduct& product() const { return product_; }
  const Optimum& optimum() const { return optimum_; }
  double seconds_of_optimum() const { return seconds_; }
  // Sights other than Landmarks are for maps.
  bool allows(const Method& method) const;
  LearningCurve run(const Method& method, const Training& training) const;

 private:
  LearningTask(TabularProduct product, std::optional<ltl::Formula> formula, double discount);
  const std::optional<Observations>& seen(Sight sight) const { return observations_[static_cast<std::size_t>(sight)]; }
  TabularProduct product_;
  Optimum optimum_;
  double seconds_ = 0;
  std::array<std::optional<Observations>, 3> observations_;  // by Sight
  std::optional<TaskTrees> trees_;
};

double success(const PolicyValue& value, const PolicyValue& optimum);
double score(const PolicyValue& value, const PolicyValue& optimum);

struct Verdict {                                  // of one run
  double success = 0, score = 0, cost_ratio = 0;  // of the last checkpoint; cost / cost of the optimum
  double to_90 = 0, to_optimum = 0,
         to_stay = 0;               // environment steps, infinite where the run never came there
  double updates = 0, seconds = 0;  // checkpoints included
};
Verdict judge(const LearningCurve& curve, const PolicyValue& optimum, double seconds);

struct Summary {
  Estimate success, score;                          // means
  Estimate cost_ratio, to_90, to_optimum, to_stay;  // medians, infinite where too few runs came there
  Estimate optimal;                                 // rate of the runs that came to the optimum
  double updates = 0, seconds = 0;                  // medians
  std::size_t runs = 0;
};
Summary summarise(std::span<const Verdict> verdicts);  // at least one

struct CurvePoint {
  std::size_t steps = 0;
  Estimate score;  // mean over the runs
};
std::vector<CurvePoint> mean_curve(std::span<const LearningCurve> curves, const PolicyValue& optimum);

}  // namespace waymark::plan
