// Products of small matrices, added to the target: C += A B, C += A Bᵀ, C += Aᵀ B.
//
// The networks here are a few dozen wide, too small for the set-up cost of a general product. Panels of 16 rows of A
// are copied side by side and padded with zeros; 16 × 4 entries of C are summed in registers. A version of the loop for
// AVX2 and FMA is chosen at run time where the processor has both.
#pragma once
#include "libneural/parameters.hpp"

namespace waymark::neural {

using ConstView = Eigen::Ref<const Matrix, 0, Eigen::OuterStride<>>;  // a matrix or a block of columns that is read
using View = Eigen::Ref<Matrix, 0, Eigen::OuterStride<>>;             // a matrix or a block of columns that is written

// Shapes must fit (asserted); C overlaps neither A nor B.
void add_product(const ConstView& a, const ConstView& b, View c);             // A B
void add_product_transposed(const ConstView& a, const ConstView& b, View c);  // A Bᵀ
void add_transposed_product(const ConstView& a, const ConstView& b, View c);  // Aᵀ B

}  // namespace waymark::neural
