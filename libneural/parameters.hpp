// The parameters of a network: one array of values and, while it learns, one of gradients of the same length.
//
// Layers own no memory. A layer holds blocks: matrices at a position of the two arrays. A copy of a network is a copy
// of an array, an optimiser reads one array, and two layers share weights by holding the same block. In this library
// every column is an example, and all values are float32, column-major.
#pragma once
#include <Eigen/Core>
#include <functional>

namespace waymark::neural {

using Matrix = Eigen::MatrixXf;           // float32, column-major
using Vector = Eigen::VectorXf;           // one column
using Index = Eigen::Index;               // signed
using Uniform = std::function<double()>;  // draws from [0, 1): randomness is the caller's, and so is the seed

struct Block {                              // where a matrix stands in the array
  Index offset = 0, rows = 0, columns = 0;  // of its first entry; its shape
};

class Parameters {
 public:
  Block add(Index rows, Index columns);  // zeros, behind what is there; views made before are void
  // Uniform in ±√(6 / inputs), which keeps the size of signals through ReLU layers. [HZRS15, Sec. 2.2]
  Block add_for_relu(Index rows, Index columns, Index inputs, const Uniform& uniform);

  // The block as a matrix.
  Eigen::Map<Matrix> value(const Block& b) { return {values_.data() + b.offset, b.rows, b.columns}; }
  Eigen::Map<const Matrix> value(const Block& b) const { return {values_.data() + b.offset, b.rows, b.columns}; }
  // Of the block.
  Eigen::Map<Matrix> gradient(const Block& b) { return {gradients().data() + b.offset, b.rows, b.columns}; }

  Vector& values() { return values_; }                    // the whole array
  const Vector& values() const { return values_; }        // the whole array
  Vector& gradients();                                    // zeros at the first call: a reader has none
  const Vector& gradients() const { return gradients_; }  // empty before the first call of the other
  Index size() const { return values_.size(); }

 private:
  Vector values_, gradients_;
};

}  // namespace waymark::neural
