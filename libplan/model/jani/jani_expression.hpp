// Expressions of JANI [BDH+17], brought to those of the PRISM language.
//
// Names are those of an automaton, then those of the document; of a function, its parameters before both. Functions are
// written out where they are called. A transient variable is one of two things: in a state it is what the locations say
// it is, on a step what was assigned so far.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libplan/model/jani/jani_text.hpp"
#include "libplan/model/prism/prism_expression.hpp"

namespace waymark::plan {

struct JaniName {                              // what a name means
  using Id = PrismExpressions::Id;             // of an expression
  using Type = PrismExpressions::Type;         // of a value
  Type type = Type::Int;                       // of the variable or constant
  std::optional<std::uint32_t> variable = {};  // its index among the values; none: a constant
  bool transient = false;                      // a variable of a step
  std::optional<Id> in_state = {};  // the value of a constant; of a transient variable, the value in a state once known
};

struct JaniFunction {                                                      // of the document or an automaton
  JaniText::Id body = 0;                                                   // an expression
  std::vector<std::pair<std::string, PrismExpressions::Type>> parameters;  // in the order of the arguments
  PrismExpressions::Type type = PrismExpressions::Type::Int;               // of its value
};

struct JaniNames {                                             // of an automaton or the document
  std::map<std::string, JaniName, std::less<>> names;          // variables and constants
  std::map<std::string, JaniFunction, std::less<>> functions;  // in names of their own
};

class JaniExpressions {  // of a document
 public:
  using Id = PrismExpressions::Id;                        // of an expression
  using Type = PrismExpressions::Type;                    // of a value
  enum class Moment : std::uint8_t { State, Step };       // when an expression is evaluated
  static constexpr std::size_t most_operators = 100'000;  // of an expression, functions written out

  JaniExpressions(const JaniText& text, PrismExpressions& expressions) : text_(text), expressions_(expressions) {}
  JaniNames& document() { return document_; }  // names of all automata

  // The expression that `value` is, of this type. `own`: the names of the automaton, or none. Throws ltl::FormatError.
  Id read(JaniText::Id value, Type type, const JaniNames* own, Moment moment);
  // A constant expression.
  double constant(JaniText::Id value, Type type);

  // The same as read without a check of the type, for those who read operators of their own above expressions.
  Id read(JaniText::Id value, const JaniNames* own, Moment moment);
  Id made(PrismOp op, std::vector<Id> operands, JaniText::Id where);  // counted
  Id literal(double value, Type type, JaniText::Id where = 0) {
    return expressions_.number(value, type, JaniText::where(where));
  }
  const JaniName* find(const std::string& name, const JaniNames* own) const;  // none: nullptr

 private:
  struct Scope {
    const JaniNames* own;
    Moment moment;
    const std::map<std::string, Id, std::less<>>* arguments;
  };
  Id lower(JaniText::Id value, const Scope& scope);
  Id name(JaniText::Id value, const Scope& scope);
  Id operation(JaniText::Id value, const Scope& scope);
  Id call(JaniText::Id value, const Scope& scope);
  Id sign(Id operand, JaniText::Id where);

  const JaniText& text_;
  PrismExpressions& expressions_;
  JaniNames document_;
  std::vector<std::uint32_t> sizes_;  // by expression: operators, those of shared parts as often as they are used
  std::vector<const JaniFunction*> calling_;
  std::size_t depth_ = 0, lowered_ = 0;  // of the expression that is read
  JaniText::Id whole_ = 0;               // this expression
};

}  // namespace waymark::plan
