// Random formulas and words. The same seed gives the same formulas on every machine.
//
// A formula of size n is a random operator over random formulas whose sizes add up to n − 1, every split equally likely
// (as in Spot's randltl). The generator is std::mt19937_64, which the standard fixes bit for bit. The distributions of
// the standard are not fixed and not used.
#pragma once
#include <cstddef>
#include <cstdint>
#include <random>

#include "libltl/formula.hpp"
#include "libltl/word.hpp"

namespace waymark::ltl {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::size_t below(std::size_t n);             // uniform in 0 … n − 1, n ≥ 1
  double unit();                                // uniform in [0, 1)
  bool chance(double p) { return unit() < p; }  // true with probability p

 private:
  std::mt19937_64 engine_;
};

struct RandomFormula {    // what random formulas look like
  std::size_t size = 12;  // operators, constants and atoms; the result may be smaller after folding
  std::size_t atoms = 3;  // the first propositions of the arena's vocabulary
  bool constants = true;  // may true and false occur
  bool weak_next = true;  // may N occur
  bool past = false;      // may Y, Z, O, H, S and T occur
};
// Throws std::invalid_argument when the vocabulary has fewer propositions or no leaf is allowed.
Formula random_formula(Random& random, Arena& arena, const RandomFormula& options = {});

struct RandomWord {        // what random words look like
  std::size_t length = 8;  // letters of a trace
  std::size_t prefix = 3;  // |u| of a lasso
  std::size_t cycle = 3;   // |v|
  std::size_t atoms = 3;   // propositions
  double density = 0.5;    // chance of each proposition in each letter
};
// One of the kind; propositions 0 … atoms − 1.
Letter random_letter(Random& random, const RandomWord& options = {});
Trace random_trace(Random& random, const RandomWord& options = {});
Lasso random_lasso(Random& random, const RandomWord& options = {});

}  // namespace waymark::ltl
