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
  Dqn dqn;                         // of the learner
  Sight sight = Sight::Landmarks;  // what the network is told of a pose
  bool trees = false;              // else the task is one-hot
};

struct Method {                            // a learner with its name
  std::string name, summary;               // for the command line
  std::variant<QLearning, DqnMethod> how;  // the learner
  bool by_default = true;                  // in comparisons that name no methods
};

// The table of learners: the one list of them.
std::vector<Method> learning_methods();

struct LearningTaskOptions {  // what is learned in
  MapNoise noise = {};        // of the map's actions
  double discount = 0.9;      // γ
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

  const TabularProduct& product() const { return product_; }  // the environment
  const Optimum& optimum() const { return optimum_; }         // the reference
  double seconds_of_optimum() const { return seconds_; }      // that the reference took
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

double success(const PolicyValue& value, const PolicyValue& optimum);  // in parts of the greatest probability
double score(const PolicyValue& value, const PolicyValue& optimum);    // in parts of the greatest value

struct Verdict {                                  // of one run
  double success = 0, score = 0, cost_ratio = 0;  // of the last checkpoint; cost / cost of the optimum
  double to_90 = 0, to_optimum = 0,
         to_stay = 0;               // environment steps, infinite where the run never came there
  double updates = 0, seconds = 0;  // checkpoints included
};
Verdict judge(const LearningCurve& curve, const PolicyValue& optimum, double seconds);  // how soon a run came how far

struct Summary {                                    // many runs of one method
  Estimate success, score;                          // means
  Estimate cost_ratio, to_90, to_optimum, to_stay;  // medians, infinite where too few runs came there
  Estimate optimal;                                 // rate of the runs that came to the optimum
  double updates = 0, seconds = 0;                  // medians
  std::size_t runs = 0;                             // how many
};
Summary summarise(std::span<const Verdict> verdicts);  // at least one

struct CurvePoint {       // one point of a mean curve
  std::size_t steps = 0;  // taken so far
  Estimate score;         // mean over the runs
};
std::vector<CurvePoint> mean_curve(std::span<const LearningCurve> curves, const PolicyValue& optimum);  // by checkpoint

}  // namespace waymark::plan
