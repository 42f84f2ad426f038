// AdaGrad: each weight has its own step size, learning rate / √(sum of its squared gradients). Source: [DHS11].
#pragma once
#include <cmath>
#include <vector>

#include "libparser/linear_model.hpp"

namespace waymark::parser {

class AdaGrad {
 public:
  AdaGrad(WeightTable& table, double rate, double decay)
      : table_(&table), rate_(static_cast<float>(rate)), decay_(static_cast<float>(decay)) {}

  // Ascends: gradient [columns] of the log-likelihood.
  void update(std::uint32_t row, const float* gradient) {
    const std::size_t columns = table_->columns();
    if (squares_.size() < table_->rows() * columns) squares_.resize(table_->rows() * columns, 1e-6F);
    float* const weights = table_->row(row);
    float* const squares = squares_.data() + row * columns;
    for (std::size_t c = 0; c < columns; ++c) {
      const float g = gradient[c] - decay_ * weights[c];
      squares[c] += g * g;
      weights[c] += rate_ * g / std::sqrt(squares[c]);
    }
  }

 private:
  WeightTable* table_;
  float rate_, decay_;
  std::vector<float> squares_;
};

}  // namespace waymark::parser
