#include "libneural/multiply.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

namespace waymark::neural {
namespace {

constexpr Index panel_rows = 16, tile_columns = 4, panel_depth = 256;
using Lanes = float __attribute__((vector_size(32)));  // eight; two SSE registers where there is no AVX
constexpr Index lanes = 8;

struct Strided {  // entry (i, j) at data[i · row + j · column]
  const float* data;
  Index row, column;
};
struct Problem {  // c [m × n] += a [m × k] · b [k × n]
  Index m, n, k;
  Strided a, b;
  float* c;
  Index c_column;
};

// Rows i … i + 15 and columns p … p + depth − 1 of a, column by column; rows past the end are zero.
[[gnu::always_inline]] inline void pack(const Problem& problem, Index i, Index p, Index depth, float* panel) {
  const Index rows = std::min(panel_rows, problem.m - i);
  const float* from = problem.a.data + i * problem.a.row + p * problem.a.column;
  if (problem.a.row == 1 && rows == panel_rows) {
    for (Index q = 0; q < depth; ++q)
      std::memcpy(panel + q * panel_rows, from + q * problem.a.column, panel_rows * sizeof(float));
    return;
  }
  if (rows < panel_rows) std::fill(panel, panel + depth * panel_rows, 0.0F);
  for (Index r = 0; r < rows; ++r)
    for (Index q = 0; q < depth; ++q) panel[q * panel_rows + r] = from[r * problem.a.row + q * problem.a.column];
}

// c (i … i + 15, j … j + columns − 1) += panel · b.
template <Index columns>
[[gnu::always_inline]] inline void tile(const Problem& problem, Index i, Index j, Index p, Index depth,
                                        const float* panel) {
  Lanes sum[columns][2] = {};
  const float* b = problem.b.data + p * problem.b.row + j * problem.b.column;
  for (Index q = 0; q < depth; ++q) {
    Lanes low, high;
    std::memcpy(&low, panel + q * panel_rows, sizeof low);
    std::memcpy(&high, panel + q * panel_rows + lanes, sizeof high);
    for (Index t = 0; t < columns; ++t) {
      const float factor = b[q * problem.b.row + t * problem.b.column];
      sum[t][0] += low * factor;
      sum[t][1] += high * factor;
    }
  }
  const Index rows = std::min(panel_rows, problem.m - i);
  for (Index t = 0; t < columns; ++t) {
    float* c = problem.c + i + (j + t) * problem.c_column;
    if (rows == panel_rows) {
      Lanes low, high;
      std::memcpy(&low, c, sizeof low);
      std::memcpy(&high, c + lanes, sizeof high);
      low += sum[t][0];
      high += sum[t][1];
      std::memcpy(c, &low, sizeof low);
      std::memcpy(c + lanes, &high, sizeof high);
    } else {
      for (Index r = 0; r < rows; ++r) c[r] += sum[t][r / lanes][r % lanes];
    }
  }
}

[[gnu::always_inline]] inline void multiply_in_panels(const Problem& problem) {
  alignas(64) std::array<float, panel_rows * panel_depth> panel;
  for (Index p = 0; p < problem.k; p += panel_depth) {
    const Index depth = std::min(panel_depth, problem.k - p);
    for (Index i = 0; i < problem.m; i += panel_rows) {
      pack(problem, i, p, depth, panel.data());
      Index j = 0;
      for (; j + tile_columns <= problem.n; j += tile_columns)
        tile<tile_columns>(problem, i, j, p, depth, panel.data());
      for (; j < problem.n; ++j) tile<1>(problem, i, j, p, depth, panel.data());
    }
  }
}

void multiply_anywhere(const Problem& problem) { multiply_in_panels(problem); }

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] void multiply_with_avx2(const Problem& problem) { multiply_in_panels(problem); }

void multiply(const Problem& problem) {
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  if (has_avx2)
    multiply_with_avx2(problem);
  else
    multiply_anywhere(problem);
}
#else
void multiply(const Problem& problem) { multiply_anywhere(problem); }
#endif

}  // namespace

void add_product(const ConstView& a, const ConstView& b, View c) {
  assert(a.cols() == b.rows() && c.rows() == a.rows() && c.cols() == b.cols());
  multiply({c.rows(),
            c.cols(),
            a.cols(),
            {a.data(), 1, a.outerStride()},
            {b.data(), 1, b.outerStride()},
            c.data(),
            c.outerStride()});
}

void add_product_transposed(const ConstView& a, const ConstView& b, View c) {
  assert(a.cols() == b.cols() && c.rows() == a.rows() && c.cols() == b.rows());
  multiply({c.rows(),
            c.cols(),
            a.cols(),
            {a.data(), 1, a.outerStride()},
            {b.data(), b.outerStride(), 1},
            c.data(),
            c.outerStride()});
}

void add_transposed_product(const ConstView& a, const ConstView& b, View c) {
  assert(a.rows() == b.rows() && c.rows() == a.cols() && c.cols() == b.cols());
  multiply({c.rows(),
            c.cols(),
            a.rows(),
            {a.data(), a.outerStride(), 1},
            {b.data(), 1, b.outerStride()},
            c.data(),
            c.outerStride()});
}

}  // namespace waymark::neural
