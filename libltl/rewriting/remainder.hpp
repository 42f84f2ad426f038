// What remains of a formula while letters are read, simplified after each of them.
//
// The conjuncts of a large conjunction are progressed and simplified apart, and each step of a conjunct is remembered
// by its rest and what it reads of the letter: hundreds of conjuncts are no more work than their sum.
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/word.hpp"

namespace waymark::ltl {

class Remainder {  // the formula, and what the letters so far leave of it
 public:
  Remainder(Formula f, Semantics semantics);
  // After one more letter, over the vocabulary of the formula's arena.
  Formula read(const Letter& letter);

 private:
  Formula step(Formula part, const Letter& letter);
  Formula simplified(Formula part, const Letter& letter) const;

  Semantics semantics_;
  Formula rest_;
  std::vector<Formula> parts_;  // where they are many
  std::map<std::pair<std::uint32_t, std::vector<bool>>, Formula> known_;
};

}  // namespace waymark::ltl
