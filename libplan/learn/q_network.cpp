#include "libplan/learn/q_network.hpp"

namespace waymark::plan {

using neural::Index;
using neural::Matrix;

QNetwork::QNetwork(const DqnInput& input, const Shape& shape, ltl::Random& random, QWeights& weights) : input_(input) {
  const auto uniform = [&random] { return random.unit(); };
  if (input.trees != nullptr) {
    encoder_.emplace(weights.parameters, shape.task_width, input.trees->slots, uniform);
    weights.vectors = Matrix::Zero(shape.task_width, static_cast<Index>(input.trees->nodes.size()));
    weights.tasks = Matrix::Zero(shape.task_width, shape.tasks);
  } else {
    weights.tasks = Matrix::Identity(shape.tasks, shape.tasks);
  }
  std::vector<Index> sizes{input.by_position->rows() + weights.tasks.rows()};
  sizes.insert(sizes.end(), shape.hidden.begin(), shape.hidden.end());
  sizes.push_back(shape.actions);
  perceptron_.emplace(weights.parameters, sizes, uniform);
  read_tasks(weights);
}

void QNetwork::read_tasks(QWeights& weights) const {
  if (!encoder_) return;
  encoder_->forward(weights.parameters, input_.trees->nodes, weights.vectors);
  for (Index q = 0; q < weights.tasks.cols(); ++q)
    weights.tasks.col(q) = weights.vectors.col(input_.trees->root[static_cast<std::size_t>(q)]);
}

void QNetwork::show(const QWeights& weights, std::uint32_t position, std::uint32_t task, neural::View x) const {
  x.topRows(input_.by_position->rows()) = input_.by_position->col(position);
  x.bottomRows(weights.tasks.rows()) = weights.tasks.col(task);
}

void QNetwork::backward(QWeights& weights, const Matrix& x, std::span<const std::uint32_t> tasks,
                        neural::Perceptron::Signals& signals, Matrix& dx) const {
  if (!encoder_) return perceptron_->backward(weights.parameters, x, signals);
  perceptron_->backward(weights.parameters, x, signals, dx);
  Matrix dh = Matrix::Zero(weights.vectors.rows(), weights.vectors.cols());
  for (std::size_t i = 0; i < tasks.size(); ++i)
    dh.col(input_.trees->root[tasks[i]]) += dx.col(static_cast<Index>(i)).bottomRows(dh.rows());
  encoder_->backward(weights.parameters, input_.trees->nodes, weights.vectors, dh);
}

}  // namespace waymark::plan
