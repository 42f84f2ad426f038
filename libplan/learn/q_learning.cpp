#include "libplan/learn/q_learning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "libplan/learn/environment.hpp"
#include "libplan/learn/replay.hpp"

namespace waymark::plan {
namespace {

constexpr double not_offered = -std::numeric_limits<double>::infinity();
constexpr std::size_t tabulated_rates = 1U << 12U;  // later updates are made at the last of them

// Sub-tasks to begin episodes with: the states of the automaton that a start can owe, easiest first, the task itself
// last.
class Curriculum {
 public:
  Curriculum(const TabularProduct& product, std::size_t passes) : passes_(passes) {
    const std::uint32_t position = product.position_of(product.starts[0].state);
    const std::uint32_t whole = product.task_of(product.starts[0].state);
    std::vector<std::uint32_t> tasks;
    for (std::uint32_t q = 0; q < product.task.tasks; ++q)
      if (product.task.ending[q] == Ending::Open && q != product.task.initial && q != whole) tasks.push_back(q);
    std::stable_sort(tasks.begin(), tasks.end(), [&](std::uint32_t a, std::uint32_t b) {
      return product.task.distance[a] < product.task.distance[b];
    });
    for (const std::uint32_t q : tasks) starts_.push_back(product.state(position, q));
  }
  bool is_over() const { return current_ == starts_.size(); }
  std::uint32_t start() const { return starts_[current_]; }
  void report(bool solved) {
    in_a_row_ = solved ? in_a_row_ + 1 : 0;
    if (in_a_row_ < passes_ && ++tries_ < most_tries) return;
    ++current_;
    in_a_row_ = tries_ = 0;
  }

 private:
  static constexpr std::size_t most_tries = 20;  // a sub-task that cannot be solved from here holds nobody up
  std::size_t passes_, current_ = 0, in_a_row_ = 0, tries_ = 0;
  std::vector<std::uint32_t> starts_;
};

class Learner {
 public:
  Learner(const TabularProduct& product, const QLearning& method, const Training& training)
      : product_(product),
        method_(method),
        training_(training),
        random_(training.seed),
        environment_(product, training.horizon, random_),
        replay_(method.replays > 0 ? method.memory : 0),
        curriculum_(product, method.curriculum ? method.passes : 0),
        potential_(product.task.tasks, 0) {
    if (method.shaped) potential_ = potential(product.task, training.discount);
    const double decay = method.decay.value_or(product.is_deterministic() ? 0 : 0.77);
    if (decay > 0) count_.assign(product.states() * product.actions, 0);
    for (std::size_t n = 0; n < tabulated_rates; ++n) rate_.push_back(std::pow(n + 1, -decay));
    fill();
  }

  QTable run() {
    begin_episode();
    take_steps(
        training_, [&](std::size_t step) { act(step); }, [&](std::size_t step) { checkpoint(step); });
    return std::move(out_);
  }

 private:
  void fill() {
    out_.values.assign(product_.states() * product_.actions, not_offered);
    for (std::uint32_t state = 0; state < product_.states(); ++state)
      for (std::uint32_t a = 0; a < product_.actions; ++a)
        if (product_.is_offered(product_.position_of(state), a))
          out_.values[std::size_t{state} * product_.actions + a] = first_value(product_.task_of(state));
  }
  double first_value(std::uint32_t q) const {
    if (!method_.optimistic) return -potential_[q];
    return method_.shaped ? 0 : 1;
  }

  void checkpoint(std::size_t step) {
    const ActionTable policy = greedy(product_, out_.values);
    out_.curve.checkpoints.push_back({step, value_of(product_, policy, training_.discount)});
  }

  void begin_episode() {
    ++out_.curve.episodes;
    if (method_.curriculum && !curriculum_.is_over())
      environment_.reset(curriculum_.start());
    else
      environment_.reset();
  }

  void act(std::size_t step) {
    const std::uint32_t state = environment_.state();
    const std::uint32_t action =
        random_.chance(training_.epsilon(step)) ? environment_.random_action() : best_action(state);
    const Environment::Transition taken = environment_.step(action);
    const Experience experience{product_.position_of(state), product_.task_of(state), action, taken.position,
                                taken.letter};
    learn_from(experience);
    if (method_.replays > 0) {
      replay_.add(experience);
      for (std::size_t i = 0; i < method_.replays; ++i) learn_from(replay_.draw(random_));
    }
    if (!taken.is_last()) return;
    if (method_.curriculum && !curriculum_.is_over()) curriculum_.report(taken.ending == Ending::Accepting);
    begin_episode();
  }

  void learn_from(const Experience& seen) {
    if (!method_.counterfactual) return update(seen, seen.task);
    for (std::uint32_t q = 0; q < product_.task.tasks; ++q)
      if (product_.task.ending[q] == Ending::Open) update(seen, q);
  }

  void update(const Experience& seen, std::uint32_t q) {
    const std::uint32_t next = product_.task.after(q, seen.letter);
    double target = training_.discount * potential_[next] - potential_[q];
    switch (product_.task.ending[next]) {
      case Ending::Accepting: target += 1; break;
      case Ending::Trap: break;
      case Ending::Open: target += training_.discount * best_value(product_.state(seen.next, next)); break;
    }
    const std::size_t entry = std::size_t{product_.state(seen.position, q)} * product_.actions + seen.action;
    double& value = out_.values[entry];
    if (count_.empty())
      value = target;
    else
      value += rate_[std::min<std::size_t>(count_[entry]++, tabulated_rates - 1)] * (target - value);
    ++out_.curve.updates;
  }

  double best_value(std::uint32_t state) const {
    const double* values = &out_.values[std::size_t{state} * product_.actions];
    double best = values[0];
    for (std::uint32_t a = 1; a < product_.actions; ++a) best = std::max(best, values[a]);
    return best;
  }
  std::uint32_t best_action(std::uint32_t state) const {
    const double* values = &out_.values[std::size_t{state} * product_.actions];
    return static_cast<std::uint32_t>(std::max_element(values, values + product_.actions) - values);
  }

  const TabularProduct& product_;
  const QLearning& method_;
  const Training& training_;
  ltl::Random random_;
  Environment environment_;
  Replay replay_;
  Curriculum curriculum_;
  std::vector<double> potential_;     // by task; zeros without shaping
  std::vector<double> rate_;          // by updates before
  std::vector<std::uint32_t> count_;  // by entry; empty where every rate is 1
  QTable out_;
};

}  // namespace

QTable learn(const TabularProduct& product, const QLearning& method, const Training& training) {
  if (product.is_over()) throw std::invalid_argument("the task is over where it begins");
  return Learner(product, method, training).run();
}

ActionTable greedy(const TabularProduct& product, const std::vector<double>& values) {
  ActionTable policy(product.states(), no_action);
  for (std::uint32_t state = 0; state < product.states(); ++state) {
    if (product.ending(state) != Ending::Open) continue;
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(std::size_t{state} * product.actions);
    policy[state] = static_cast<std::uint8_t>(std::max_element(first, first + product.actions) - first);
  }
  return policy;
}

std::vector<double> potential(const TaskRows& task, double discount) {
  std::vector<double> phi;
  for (std::uint32_t q = 0; q < task.tasks; ++q)
    phi.push_back(task.ending[q] == Ending::Open ? std::pow(discount, task.distance[q] - 1) : 0);
  return phi;
}

}  // namespace waymark::plan
