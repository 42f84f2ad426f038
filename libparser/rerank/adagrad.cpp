#include "libparser/rerank/adagrad.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace waymark::parser {

void AdaGrad::update(WeightRow row, const float* gradient) {
  using Row = Eigen::Map<Eigen::ArrayXf>;
  const std::size_t columns = table_->columns();
  if (squares_.size() < table_->rows() * columns) squares_.resize(table_->rows() * columns, first_squares_);
  const auto n = static_cast<Eigen::Index>(columns);
  Row weights(table_->row(row), n), squares(squares_.data() + row.index * columns, n);
  const Eigen::Map<const Eigen::ArrayXf> ascent(gradient, n);
  for (Eigen::Index c = 0; c < n; c += 64) {  // in blocks that stay in registers and cache
    const Eigen::Index width = std::min<Eigen::Index>(64, n - c);
    const Eigen::Array<float, Eigen::Dynamic, 1, 0, 64, 1> g =
        ascent.segment(c, width) - decay_ * weights.segment(c, width);
    squares.segment(c, width) += g.square();
    weights.segment(c, width) += rate_ * g / squares.segment(c, width).sqrt();
  }
}

}  // namespace waymark::parser
