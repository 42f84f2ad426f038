// Expressions of the PRISM language [KNP11]: syntax, types and values.
//
// An expression is a number in a pool; names are bound after everything has been read, since formulas may be used
// before they are defined. A formula is evaluated once a state, however often it is used. Whole numbers are kept as
// doubles, exact up to 2⁵³.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/model/prism/prism_tokens.hpp"

namespace waymark::plan {

using PrismValues = std::vector<double>;  // by variable; true is 1

class PrismExpressions {  // all expressions of a file
 public:
  using Id = std::uint32_t;                              // of an expression
  enum class Type : std::uint8_t { Bool, Int, Double };  // of a value

  explicit PrismExpressions(const PrismTokens& tokens) : tokens_(&tokens) {}
  Id parse(PrismTokens& in);                               // the longest expression that stands here
  ltl::Span where(Id e) const { return nodes_[e].where; }  // its bytes

  // An expression is at most so deep, and so are the formulas that it uses, taken together: else SyntaxError.
  static constexpr std::size_t deepest = 500;

  // Names must be known before types and values are asked for; one name has one meaning.
  void define_variable(const PrismToken& name, std::uint32_t index, Type type);
  void define_formula(const PrismToken& name, Id body);

  // Throws ltl::SyntaxError: an unknown name, an operand of the wrong type, a formula that needs itself.
  Type type(Id e);
  void expect_type(Id e, Type type);  // whole numbers are doubles too
  // The value in one state: `values` may be changed between calls only after next_state(). Types must have been asked
  // for.
  double value(Id e, const PrismValues& values);
  void next_state() { ++now_; }
  double constant(Id e);  // throws ltl::SyntaxError where a variable is read

 private:
  enum class Op : std::uint8_t {
    Literal,
    Name,
    Choose,
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
    Pow
  };
  struct Node {
    Op op = Op::Literal;
    Type type = Type::Int;
    enum class Check : std::uint8_t { No, Now, Done } checked = Check::No;
    double value = 0;
    std::string name = {};
    std::vector<Id> operands = {};
    std::uint32_t height = 1;
    ltl::Span where = {};
  };
  struct Meaning {
    bool is_variable = false;
    std::uint32_t variable = 0;
    Type type = Type::Int;
    Id body = 0;
    std::uint64_t known_at = 0;  // the state for which `value` was found
    double value = 0;
  };

  Id add(Op op, std::vector<Id> operands, ltl::Span where);
  static constexpr std::size_t negation = 4;  // the level of !, which binds tighter than & and looser than =
  Id parse_level(PrismTokens& in, std::size_t loosest);
  Id parse_negation(PrismTokens& in);
  Id parse_unary(PrismTokens& in);
  Id parse_primary(PrismTokens& in);
  Id parse_call(PrismTokens& in);
  void define(const PrismToken& name, const Meaning& meaning);
  Type find_type(Id e);
  Type type_of_name(Id e);
  double value_of_name(const Node& node, const PrismValues& values);

  class Deeper;  // a level of recursion, counted

  const PrismTokens* tokens_;
  std::size_t depth_ = 0;
  std::vector<Node> nodes_;
  std::vector<Meaning> meanings_;
  std::map<std::string, std::uint32_t, std::less<>> names_;
  std::uint64_t now_ = 1;
};

}  // namespace waymark::plan
