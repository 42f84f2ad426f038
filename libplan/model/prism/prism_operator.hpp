// What an expression of the PRISM language does with its operands.
#pragma once
#include <cstdint>

namespace waymark::plan {

enum class PrismOp : std::uint8_t {  // named as in prism_syntax.cpp
  Literal,
  Name,
  Label,
  Choose,
  Pick,  // the operand behind the first whose number the first is, from 0; JANI's locations
  Implies,
  Iff,
  Or,
  And,
  Not,
  Equal,
  Unequal,
  Less,
  AtMost,
  Greater,
  AtLeast,
  Plus,
  Minus,
  Times,
  Divide,
  Negate,
  Min,
  Max,
  Mod,
  Floor,
  Ceil,
  Pow,
  Round,
  Log,
  Next,
  Eventually,
  Always,
  Until,
  WeakUntil,
  Release,
  Query,  // an operator of properties
};

}  // namespace waymark::plan
