// The meaning of a formula on a word, by definition. Every other engine is tested against this definition.
//
//   finite words w = a₀…aₙ₋₁ (n ≥ 1):  w,i ⊨ X φ iff i+1 < n and w,i+1 ⊨ φ      w,i ⊨ N φ iff i+1 = n or w,i+1 ⊨ φ
//   infinite words u·vʷ:                X and N are the same operator
//   both:                               w,i ⊨ Y φ iff i > 0 and w,i−1 ⊨ φ
//                                       w,i ⊨ φ S ψ iff w,k ⊨ ψ for a k ≤ i, and w,j ⊨ φ for k < j ≤ i
// The past of a position of a lasso is the finite word before it, so the cycle is unrolled until the past repeats.
// The code follows the definition and is slow. Source: finite [DV13, Sec. 2], infinite [BK08, Def. 5.6].
#pragma once
#include <cstdint>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/word.hpp"

namespace waymark::ltl {

enum class Semantics : std::uint8_t { Finite, Infinite };

bool holds(const Trace& word, Formula f);  // O(|DAG| · |w|²)
bool holds(const Lasso& word, Formula f);  // O(|DAG| · |uv|²), of the unrolled lasso where there is a past
// By position i: word,i ⊨ f.
std::vector<bool> truth(const Trace& word, Formula f);

}  // namespace waymark::ltl
