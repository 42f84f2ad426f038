// Expressions of the PRISM language [KNP11]: syntax, types and values; in properties, path formulas over them as well.
//
// An expression is a number in a pool; names are bound after everything has been read, since formulas may be used
// before they are defined. A formula is evaluated once a state, however often it is used. Whole numbers are kept as
// doubles, exact up to 2⁵³.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libplan/model/prism/prism_operator.hpp"
#include "libplan/model/prism/prism_tokens.hpp"

namespace waymark::plan {

using PrismValues = std::vector<double>;  // by variable; true is 1

class PrismExpressions {  // all expressions of a file
 public:
  using Id = std::uint32_t;                              // of an expression
  enum class Type : std::uint8_t { Bool, Int, Double };  // of a value
  using Op = PrismOp;                                    // what an expression does
  struct Window {                                        // of the steps of a temporal operator: absent where unbounded
    std::optional<Id> least, most;                       // expressions
    bool above_least = false, below_most = false;        // > and <
    std::optional<std::string> rewards;                  // of a structure, in the place of steps
  };

  explicit PrismExpressions(const ModelText& text) : text_(&text) {}
  Id parse(PrismTokens& in);                               // the longest expression that stands here
  Id parse_path(PrismTokens& in);                          // the same with X, F, G, U, W, R and their bounds
  ltl::Span where(Id e) const { return nodes_[e].where; }  // its bytes

  // An expression is at most so deep, and so are the formulas that it uses, taken together: else SyntaxError.
  static constexpr std::size_t deepest = 500;

  // Names must be known before types and values are asked for; one name has one meaning.
  void define_variable(const PrismToken& name, std::uint32_t index, Type type);
  void define_formula(const PrismToken& name, Id body);
  void define_label(const PrismToken& name, Id body);            // a name in quotes
  Id number(double value, Type type, ltl::Span where = {});      // a literal
  Id variable(std::uint32_t index, Type type, ltl::Span where);  // one that needs no name
  Id add(Op op, std::vector<Id> operands, ltl::Span where);      // with its operands; their number is the caller's care
  Id add_path(Op op, std::vector<Id> operands, std::optional<Window> window, ltl::Span where);  // a temporal one
  // What reads operators of properties among expressions, or leaves them: `query` makes one of what it read.
  void read_queries(std::function<std::optional<Id>()> reader) { queries_ = std::move(reader); }
  Id query(Type type, ltl::Span where);
  // The same expression with other names for variables; formulas that use one are written out. Everything must have
  // been read.
  Id renamed(Id e, const std::map<std::string, std::string, std::less<>>& names);

  // Throws ltl::SyntaxError: an unknown name, an operand of the wrong type, a formula that needs itself.
  Type type(Id e);
  void expect_type(Id e, Type type);  // whole numbers are doubles too
  // The value in one state: `values` may be changed between calls only after next_state(). Types must have been asked
  // for.
  double value(Id e, const PrismValues& values);
  void next_state() { ++now_; }
  double constant(Id e);  // throws ltl::SyntaxError where a variable is read

  // Errors are about this text from now on; what was spoken of before.
  const ModelText& speak_of(const ModelText& text) { return *std::exchange(text_, &text); }

  // Of path formulas.
  Op op(Id e) const { return nodes_[e].op; }                                  // the outermost operator
  const std::vector<Id>& operands(Id e) const { return nodes_[e].operands; }  // of a name: none
  const Window* window(Id e) const;                            // of a temporal operator that has bounds; else none
  bool is_temporal(Id e) const { return nodes_[e].temporal; }  // itself or below

 private:
  struct Node {
    Op op = Op::Literal;
    Type type = Type::Int;
    enum class Check : std::uint8_t { No, Now, Done } checked = Check::No;
    double value = 0;
    std::string name = {};
    std::vector<Id> operands = {};
    std::uint32_t height = 1;
    ltl::Span where = {};
    bool temporal = false;  // or an operand is
    std::optional<std::uint32_t> window = {};
  };
  struct Meaning {
    bool is_variable = false;
    std::uint32_t variable = 0;
    Type type = Type::Int;
    Id body = 0;
    std::uint64_t known_at = 0;  // the state for which `value` was found
    double value = 0;
  };

  static constexpr std::size_t negation = 4;  // the level of !, which binds tighter than & and looser than =
  Id parse_level(PrismTokens& in, std::size_t loosest);
  Id parse_negation(PrismTokens& in);
  Id parse_unary(PrismTokens& in);
  Id parse_primary(PrismTokens& in);
  Id parse_call(PrismTokens& in);
  Id parse_temporal(PrismTokens& in);
  std::optional<Window> parse_window(PrismTokens& in);
  void define(const PrismToken& name, const Meaning& meaning);
  Type find_type(Id e);
  Type type_of_name(Id e);
  Type type_of_label(Id e);
  double value_of_name(const Node& node, const PrismValues& values);

  class Deeper {  // a level of recursion, counted
   public:
    Deeper(PrismExpressions& all, ltl::Span where) : depth_(all.depth_) {
      if (depth_ >= deepest) all.text_->fail(where, "this is nested too deeply");
      ++depth_;
    }
    ~Deeper() { --depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;

   private:
    std::size_t& depth_;
  };

  const ModelText* text_;
  std::size_t depth_ = 0;
  std::vector<Node> nodes_;
  std::vector<Meaning> meanings_;
  std::vector<Window> windows_;
  std::map<std::string, std::uint32_t, std::less<>> names_;
  std::map<std::string, Id, std::less<>> labels_;
  bool in_path_ = false;  // parentheses hold path formulas
  std::function<std::optional<Id>()> queries_;
  std::uint64_t now_ = 1;
};

}  // namespace waymark::plan
