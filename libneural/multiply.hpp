// Products of small matrices, added to what is there: C += A B, C += A Bᵀ, C += Aᵀ B.
//
// Networks here are a few dozen wide, too small for a general product to earn back its preparations. Panels of 16 rows
// of A are copied side by side, filled up with zeros, and 16 × 4 entries of C are summed in registers. On processors
// with AVX2 and FMA the same loop runs in a version compiled for them, chosen at run time.
#pragma once
#include "libneural/parameters.hpp"

namespace waymark::neural {

using ConstView = Eigen::Ref<const Matrix, 0, Eigen::OuterStride<>>;
using View = Eigen::Ref<Matrix, 0, Eigen::OuterStride<>>;

// Shapes must fit (asserted); C overlaps neither A nor B.
void add_product(const ConstView& a, const ConstView& b, View c);             // A B
void add_product_transposed(const ConstView& a, const ConstView& b, View c);  // A Bᵀ
void add_transposed_product(const ConstView& a, const ConstView& b, View c);  // Aᵀ B

}  // namespace waymark::neural
