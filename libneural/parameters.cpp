#include "libneural/parameters.hpp"

#include <cmath>

namespace waymark::neural {

Block Parameters::add(Index rows, Index columns) {
  const Block block{values_.size(), rows, columns};
  values_.conservativeResizeLike(Vector::Zero(values_.size() + rows * columns));
  return block;
}

Vector& Parameters::gradients() {
  if (gradients_.size() != values_.size()) gradients_.conservativeResizeLike(Vector::Zero(values_.size()));
  return gradients_;
}

Block Parameters::add_for_relu(Index rows, Index columns, Index inputs, const Uniform& uniform) {
  const Block block = add(rows, columns);
  const double bound = std::sqrt(6.0 / static_cast<double>(inputs));
  for (Index i = 0; i < rows * columns; ++i)
    values_[block.offset + i] = static_cast<float>(bound * (2 * uniform() - 1));
  return block;
}

}  // namespace waymark::neural
