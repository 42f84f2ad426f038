#include "libplan/learn/dqn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "libneural/adam.hpp"
#include "libplan/learn/environment.hpp"
#include "libplan/learn/replay.hpp"

namespace waymark::plan {
namespace {

using neural::Index;
using neural::Matrix;

constexpr double least_priority = 1e-3;

// Q⁻: the copy that makes targets, and what it says of each state, computed when first asked for since the last copy.
class Target {
 public:
  Target(const TabularProduct& product, const QNetwork& network, const QWeights& online, std::size_t batch)
      : product_(product),
        network_(network),
        weights_(online),
        signals_(network.signals(static_cast<Index>(batch))),
        x_(Matrix::Zero(network.inputs(), static_cast<Index>(batch))),
        known_(product.states(), false),
        values_(Matrix::Zero(static_cast<Index>(product.actions), static_cast<Index>(product.states()))) {}

  void copy(const QWeights& online) {
    weights_.parameters.values() = online.parameters.values();
    weights_.tasks = online.tasks;
    std::fill(known_.begin(), known_.end(), false);
  }

  // Makes sure that all these states, no more than a batch, are known.
  void compute(std::span<const std::uint32_t> states) {
    asked_.clear();
    for (const std::uint32_t state : states) {
      if (known_[state]) continue;
      known_[state] = true;
      network_.show(weights_, product_.position_of(state), product_.task_of(state),
                    x_.col(static_cast<Index>(asked_.size())));
      asked_.push_back(state);
    }
    if (asked_.empty()) return;
    const Matrix& q = network_.forward(weights_, x_.leftCols(static_cast<Index>(asked_.size())), signals_);
    for (std::size_t i = 0; i < asked_.size(); ++i) values_.col(asked_[i]) = q.col(static_cast<Index>(i));
  }
  float of(std::uint32_t state, std::uint32_t action) const { return values_(action, state); }

 private:
  const TabularProduct& product_;
  const QNetwork& network_;
  QWeights weights_;
  neural::Perceptron::Signals signals_;
  Matrix x_;
  std::vector<bool> known_;
  std::vector<std::uint32_t> asked_;
  Matrix values_;  // [actions × states]
};

QNetwork::Shape shape_of(const TabularProduct& product, const Dqn& method) {
  return {method.hidden, method.task_width, static_cast<Index>(product.task.tasks),
          static_cast<Index>(product.actions)};
}

class Learner {
 public:
  Learner(const TabularProduct& product, const DqnInput& input, const Dqn& method, const Training& training)
      : product_(product),
        method_(method),
        training_(training),
        random_(training.seed),
        environment_(product, training.horizon, random_),
        replay_(method.memory),
        priorities_(method.prioritised ? method.memory : 0),
        network_(input, shape_of(product, method), random_, online_),
        adam_(online_.parameters, {.rate = method.rate}),
        target_(product, network_, online_, method.batch),
        batch_(network_.signals(static_cast<Index>(method.batch))),
        x_(Matrix::Zero(network_.inputs(), static_cast<Index>(method.batch))),
        dx_(x_),
        single_(network_.signals(1)),
        column_(Matrix::Zero(network_.inputs(), 1)),
        drawn_(method.batch),
        tasks_(method.batch),
        next_(method.batch) {}

  LearningCurve run() {
    const auto act_and_learn = [&](std::size_t step) {
      act(step);
      if (replay_.size() >= method_.batch) update(step);
      if ((step + 1) % method_.copy == 0) target_.copy(online_);
    };
    take_steps(training_, act_and_learn, [&](std::size_t step) { checkpoint(step); });
    return std::move(curve_);
  }

 private:
  struct Drawn {
    Experience experience;
    std::size_t place = 0;
    double weight = 1;
  };

  void checkpoint(std::size_t step) {
    ActionTable policy(product_.states(), no_action);
    std::vector<std::uint32_t> open;
    for (std::uint32_t state = 0; state < product_.states(); ++state)
      if (product_.ending(state) == Ending::Open) open.push_back(state);
    for (std::size_t i = 0; i < open.size(); i += method_.batch) {
      const std::size_t end = std::min(open.size(), i + method_.batch);
      for (std::size_t j = i; j < end; ++j) show(open[j], x_, j - i);
      const Matrix& q = network_.forward(online_, x_, batch_);
      for (std::size_t j = i; j < end; ++j)
        policy[open[j]] = static_cast<std::uint8_t>(best_offered(q, j - i, open[j]));
    }
    curve_.checkpoints.push_back({step, value_of(product_, policy, training_.discount)});
    curve_.policy = std::move(policy);
  }

  void show(std::uint32_t state, Matrix& x, std::size_t column) const {
    network_.show(online_, product_.position_of(state), product_.task_of(state), x.col(static_cast<Index>(column)));
  }
  std::uint32_t best_offered(const Matrix& q, std::size_t column, std::uint32_t state) const {
    const std::uint32_t position = product_.position_of(state);
    std::uint32_t best = product_.actions;
    for (std::uint32_t a = 0; a < product_.actions; ++a)
      if (product_.is_offered(position, a) &&
          (best == product_.actions || q(a, static_cast<Index>(column)) > q(best, static_cast<Index>(column))))
        best = a;
    return best;
  }

  void act(std::size_t step) {
    const std::uint32_t state = environment_.state();
    std::uint32_t action = 0;
    if (random_.chance(training_.epsilon(step))) {
      action = environment_.random_action();
    } else {
      show(state, column_, 0);
      action = best_offered(network_.forward(online_, column_, single_), 0, state);
    }
    const Environment::Transition taken = environment_.step(action);
    const std::size_t place =
        replay_.add({product_.position_of(state), product_.task_of(state), action, taken.position, taken.letter});
    if (method_.prioritised) priorities_.set(place, priorities_.greatest());
    if (!taken.is_last()) return;
    ++curve_.episodes;
    environment_.reset();
  }

  void update(std::size_t step) {
    draw(step);
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      const Experience& seen = drawn_[i].experience;
      tasks_[i] = seen.task;
      next_[i] = product_.state(seen.next, product_.task.after(seen.task, seen.letter));
    }
    target_.compute(next_);
    if (method_.double_q) choose_next_actions();
    for (std::size_t i = 0; i < drawn_.size(); ++i)
      show(product_.state(drawn_[i].experience.position, tasks_[i]), x_, i);
    const Matrix& q = network_.forward(online_, x_, batch_);
    Matrix& dq = batch_.gradients.back();
    dq.setZero();
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      const std::uint32_t action = drawn_[i].experience.action;
      const float error = q(action, static_cast<Index>(i)) - target_of(i);
      dq(action, static_cast<Index>(i)) =
          static_cast<float>(drawn_[i].weight) * std::clamp(error, -1.0F, 1.0F) / static_cast<float>(method_.batch);
      if (method_.prioritised)
        priorities_.set(drawn_[i].place,
                        std::pow(std::abs(static_cast<double>(error)) + least_priority, method_.priority_exponent));
    }
    network_.backward(online_, x_, tasks_, batch_, dx_);
    adam_.step(online_.parameters);
    network_.read_tasks(online_);
    ++curve_.updates;
  }

  void draw(std::size_t step) {
    if (!method_.prioritised) {
      for (Drawn& drawn : drawn_) drawn.experience = replay_.draw(random_);
      return;
    }
    const double passed = static_cast<double>(step) / static_cast<double>(training_.steps);
    const double exponent = method_.weight_exponent + (1 - method_.weight_exponent) * passed;
    double greatest = 0;
    for (Drawn& drawn : drawn_) {
      const std::size_t place = priorities_.draw(random_);
      const double probability = priorities_.of(place) / priorities_.sum();
      drawn = {replay_[place], place, std::pow(static_cast<double>(replay_.size()) * probability, -exponent)};
      greatest = std::max(greatest, drawn.weight);
    }
    for (Drawn& drawn : drawn_) drawn.weight /= greatest;
  }

  // Double Q: what the learning network would do in the next states.
  void choose_next_actions() {
    chosen_.clear();
    for (std::size_t i = 0; i < next_.size(); ++i) show(next_[i], x_, i);
    const Matrix& q = network_.forward(online_, x_, batch_);
    for (std::size_t i = 0; i < next_.size(); ++i) chosen_.push_back(best_offered(q, i, next_[i]));
  }

  float target_of(std::size_t i) const {
    switch (product_.ending(next_[i])) {
      case Ending::Accepting: return 1;
      case Ending::Trap: return 0;
      case Ending::Open: break;
    }
    float best = -std::numeric_limits<float>::infinity();
    if (method_.double_q) {
      best = target_.of(next_[i], chosen_[i]);
    } else {
      for (std::uint32_t a = 0; a < product_.actions; ++a)
        if (product_.is_offered(product_.position_of(next_[i]), a)) best = std::max(best, target_.of(next_[i], a));
    }
    return static_cast<float>(training_.discount) * best;
  }

  const TabularProduct& product_;
  const Dqn& method_;
  const Training& training_;
  ltl::Random random_;
  Environment environment_;
  Replay replay_;
  Priorities priorities_;
  QWeights online_;
  QNetwork network_;
  neural::Adam adam_;
  Target target_;
  neural::Perceptron::Signals batch_;
  Matrix x_, dx_;  // [inputs × batch]
  neural::Perceptron::Signals single_;
  Matrix column_;  // [inputs × 1]
  std::vector<Drawn> drawn_;
  std::vector<std::uint32_t> tasks_, next_, chosen_;  // by column of the batch
  LearningCurve curve_;
};

}  // namespace

LearningCurve learn(const TabularProduct& product, const DqnInput& input, const Dqn& method, const Training& training) {
  if (product.is_over()) throw std::invalid_argument("the task is over where it begins");
  if (input.by_position->cols() != static_cast<Index>(product.positions))
    throw std::invalid_argument("the observations are of another model");
  return Learner(product, input, method, training).run();
}

}  // namespace waymark::plan
