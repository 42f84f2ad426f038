// A value for each subformula of a formula, computed from the operands up. Two arrays hold the values, for many passes
// over small formulas.
#pragma once
#include <algorithm>
#include <cassert>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::ltl {

template <class Value>
class BySubformula {
 public:
  // compute(g, *this) gives g's value and may ask for those of its operands.
  template <class Compute>
  BySubformula(Formula f, Compute compute) : formulas_(subformulas(f)) {
    values_.reserve(formulas_.size());
    for (Formula g : formulas_) values_.push_back(compute(g, *this));
  }
  const Value& at(Formula g) const {
    const auto found = std::lower_bound(formulas_.begin(), formulas_.end(), g);
    assert(found != formulas_.end() && *found == g);
    return values_[static_cast<std::size_t>(found - formulas_.begin())];
  }
  const Value& top() const { return values_.back(); }  // f's: no operand has a larger id

 private:
  std::vector<Formula> formulas_;  // ids ascend
  std::vector<Value> values_;
};

}  // namespace waymark::ltl
