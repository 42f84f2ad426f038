// The network of deep Q-learning: a perceptron over the features of the position and the columns of the task.
//
//   x [features + task features × batch] → Q [actions × batch]
// The columns of the tasks are one-hot, or the vectors that a recursive encoder makes of their formulas; then gradients
// flow on into the encoder. The network says how to compute, QWeights hold what is learnt: a copy is a copy of them.
#pragma once
#include <optional>
#include <span>

#include "libltl/structure/random.hpp"
#include "libneural/perceptron.hpp"
#include "libplan/learn/task_trees.hpp"

namespace waymark::plan {

struct DqnInput {                               // made once and shared by all seeds
  const neural::Matrix* by_position = nullptr;  // [features × positions]
  const TaskTrees* trees = nullptr;             // none: one-hot
};

struct QWeights {                 // what is learned
  neural::Parameters parameters;  // of both networks
  neural::Matrix tasks;           // [task features × tasks], as of the last read_tasks
  neural::Matrix vectors;         // [width × nodes of the trees]; empty without an encoder
};

class QNetwork {
 public:
  struct Shape {                                            // sizes of layers
    std::vector<neural::Index> hidden;                      // widths
    neural::Index task_width = 16, tasks = 0, actions = 0;  // columns of a task; how many tasks; outputs
  };
  // Initialises the weights. The input must outlive the network.
  QNetwork(const DqnInput& input, const Shape& shape, ltl::Random& random, QWeights& weights);

  neural::Index inputs() const { return perceptron_->inputs(); }  // rows of x
  // Room for a pass over so many columns.
  neural::Perceptron::Signals signals(neural::Index batch) const { return perceptron_->signals(batch); }

  void read_tasks(QWeights& weights) const;  // after the parameters have changed
  void show(const QWeights& weights, std::uint32_t position, std::uint32_t task,
            neural::View x) const;  // a column
  // Q by action, one column for each of x.
  const neural::Matrix& forward(const QWeights& weights, const neural::ConstView& x,
                                neural::Perceptron::Signals& signals) const {
    return perceptron_->forward(weights.parameters, x, signals);
  }
  // ∂Q in signals.gradients.back(); tasks: of the columns of x; dx is overwritten.
  void backward(QWeights& weights, const neural::Matrix& x, std::span<const std::uint32_t> tasks,
                neural::Perceptron::Signals& signals, neural::Matrix& dx) const;

 private:
  DqnInput input_;
  std::optional<neural::RecursiveEncoder> encoder_;
  std::optional<neural::Perceptron> perceptron_;
};

}  // namespace waymark::plan
