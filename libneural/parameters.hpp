// The numbers that a network learns: one array of values, and one of gradients of the same length.
//
// Layers own no memory, they hold blocks: matrices at a place of the two arrays. So a copy of a network is a copy of
// an array, an optimiser walks one array, and two layers share weights by holding the same block.
// Everywhere in this library a column is an example and everything is float32, column-major.
#pragma once
#include <Eigen/Core>
#include <functional>

namespace waymark::neural {

using Matrix = Eigen::MatrixXf;
using Vector = Eigen::VectorXf;
using Index = Eigen::Index;
using Uniform = std::function<double()>;  // draws from [0, 1): randomness is the caller's, and so is the seed

struct Block {
  Index offset = 0, rows = 0, columns = 0;
};

class Parameters {
 public:
  Block add(Index rows, Index columns);  // zeros, behind what is there; views made before are void
  // Uniform in ±√(6 / inputs), which keeps the size of signals through ReLU layers. [HZRS15, Sec. 2.2]
  Block add_for_relu(Index rows, Index columns, Index inputs, const Uniform& uniform);

  Eigen::Map<Matrix> value(const Block& b) { return {values_.data() + b.offset, b.rows, b.columns}; }
  Eigen::Map<const Matrix> value(const Block& b) const {
    return {values_.data() + b.offset, b.rows, b.columns};
  }
  Eigen::Map<Matrix> gradient(const Block& b) { return {gradients_.data() + b.offset, b.rows, b.columns}; }

  Vector& values() { return values_; }
  const Vector& values() const { return values_; }
  Vector& gradients() { return gradients_; }
  const Vector& gradients() const { return gradients_; }
  Index size() const { return values_.size(); }

 private:
  Vector values_, gradients_;
};

}  // namespace waymark::neural
