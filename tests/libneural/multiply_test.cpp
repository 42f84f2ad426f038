// Products against Eigen's, over shapes that do and do not fill panels and tiles, on parts of larger matrices too.
#include "libneural/multiply.hpp"

#include <gtest/gtest.h>

#include "libltl/structure/random.hpp"

namespace waymark::neural {
namespace {

Matrix random_matrix(ltl::Random& random, Index rows, Index columns) {
  Matrix m(rows, columns);
  for (Index i = 0; i < m.size(); ++i) m.data()[i] = static_cast<float>(2 * random.unit() - 1);
  return m;
}

TEST(Multiply, AgreesWithEigenOnAllKindsOfShapes) {
  ltl::Random random(5);
  for (const Index m : {1, 3, 15, 16, 17, 64})
    for (const Index n : {1, 3, 4, 5, 32})
      for (const Index k : {1, 2, 25, 64, 300}) {
        const Matrix a = random_matrix(random, m, k), b = random_matrix(random, k, n), c = random_matrix(random, m, n);
        const Matrix at = a.transpose(), bt = b.transpose(), expected = c + a * b;
        const auto is_expected = [&](const Matrix& got) {
          EXPECT_LT((got - expected).cwiseAbs().maxCoeff(), 1e-4F) << m << " × " << k << " · " << k << " × " << n;
        };
        Matrix got = c;
        add_product(a, b, got);
        is_expected(got);
        got = c;
        add_product_transposed(a, bt, got);
        is_expected(got);
        got = c;
        add_transposed_product(at, b, got);
        is_expected(got);
      }
}

TEST(Multiply, StaysInsideTheViewItIsGiven) {
  ltl::Random random(6);
  const Matrix a = random_matrix(random, 20, 9), b = random_matrix(random, 9, 8);
  Matrix c = Matrix::Zero(24, 10);
  add_product(a.topRows(18), b.leftCols(5), c.block(2, 1, 18, 5));
  EXPECT_TRUE(c.block(2, 1, 18, 5).isApprox(a.topRows(18) * b.leftCols(5), 1e-4F));
  c.block(2, 1, 18, 5).setZero();
  EXPECT_EQ(c.cwiseAbs().maxCoeff(), 0);
}

}  // namespace
}  // namespace waymark::neural
