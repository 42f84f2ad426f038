// AdaGrad: each weight has its own step size, learning rate / √(sum of its squared gradients). Source: [DHS11].
#pragma once
#include <vector>

#include "libparser/model/weight_table.hpp"

namespace waymark::parser {

class AdaGrad {
 public:
  // The table must outlive it. decay: L2, per update of a row. first_squares: what each sum of squares begins with,
  // above 0.
  AdaGrad(WeightTable& table, double rate, double decay, double first_squares = 1e-6)
      : table_(&table),
        rate_(static_cast<float>(rate)),
        decay_(static_cast<float>(decay)),
        first_squares_(static_cast<float>(first_squares)) {}

  // Ascends: gradient [columns] of the log-likelihood. O(columns).
  void update(WeightRow row, const float* gradient);

 private:
  WeightTable* table_;
  float rate_, decay_, first_squares_;
  std::vector<float> squares_;
};

}  // namespace waymark::parser
