#include <algorithm>
#include <array>
#include <cstdlib>

#include "libplan/model/prism/prism_expression.hpp"

namespace waymark::plan {
namespace {

using Op = PrismExpressions::Op;

std::optional<Op> prefix_operator(const PrismTokens& in) {
  if (in.is("X")) return Op::Next;
  if (in.is("F")) return Op::Eventually;
  return in.is("G") ? std::optional(Op::Always) : std::nullopt;
}
std::optional<Op> infix_operator(const PrismTokens& in) {
  if (in.is("U")) return Op::Until;
  if (in.is("W")) return Op::WeakUntil;
  return in.is("R") ? std::optional(Op::Release) : std::nullopt;
}

}  // namespace

PrismExpressions::Id PrismExpressions::add(Op op, std::vector<Id> operands, ltl::Span where) {
  std::uint32_t height = 1;
  for (const Id operand : operands) height = std::max(height, nodes_[operand].height + 1);
  if (height > deepest) text_->fail(where, "this is nested too deeply");
  Node& node = nodes_.emplace_back();
  node.op = op;
  node.operands = std::move(operands);
  node.where = where;
  node.height = height;
  for (const Id operand : node.operands) node.temporal = node.temporal || nodes_[operand].temporal;
  return static_cast<Id>(nodes_.size() - 1);
}

PrismExpressions::Id PrismExpressions::parse(PrismTokens& in) {
  const Deeper level(*this, in.peek().where);
  const Id condition = parse_level(in, 0);
  if (!in.accept("?")) return condition;
  const Id yes = parse(in);
  in.expect(":");
  const Id no = parse(in);
  return add(Op::Choose, {condition, yes, no}, {where(condition).begin, where(no).end});
}

// Binary operators of this level and tighter ones, by precedence climbing: one frame for each operand, and
// not one for each level.
PrismExpressions::Id PrismExpressions::parse_level(PrismTokens& in, std::size_t loosest) {
  struct Operator {
    std::string_view text;
    std::size_t level;
    Op op;
  };
  static constexpr std::array<Operator, 14> operators{{{"=>", 0, Op::Implies},
                                                       {"<=>", 1, Op::Iff},
                                                       {"|", 2, Op::Or},
                                                       {"&", 3, Op::And},
                                                       {"=", 4, Op::Equal},
                                                       {"!=", 4, Op::Unequal},
                                                       {"<", 5, Op::Less},
                                                       {"<=", 5, Op::AtMost},
                                                       {">", 5, Op::Greater},
                                                       {">=", 5, Op::AtLeast},
                                                       {"+", 6, Op::Plus},
                                                       {"-", 6, Op::Minus},
                                                       {"*", 7, Op::Times},
                                                       {"/", 7, Op::Divide}}};
  Id left = loosest <= negation ? parse_negation(in) : parse_unary(in);
  Op chained = Op::Literal;  // what the last round made
  for (;;) {
    const auto* found = std::find_if(operators.begin(), operators.end(), [&](const Operator& candidate) {
      return candidate.level >= loosest && in.is(candidate.text);
    });
    if (found == operators.end()) return left;
    in.next();
    if (found->op == Op::Or && in.is("|"))
      in.fail("|| is not read: 'or' is written |, and conditional probabilities are not answered");
    const Id right = parse_level(in, found->level + 1);
    const ltl::Span both{where(left).begin, where(right).end};
    if (found->op == chained && (chained == Op::Or || chained == Op::And || chained == Op::Plus)) {
      nodes_[left].operands.push_back(right);  // a long chain is no deep one
      nodes_[left].height = std::max(nodes_[left].height, nodes_[right].height + 1);
      nodes_[left].temporal = nodes_[left].temporal || nodes_[right].temporal;
      nodes_[left].where = both;
      continue;
    }
    left = add(found->op, {left, right}, both);
    chained = found->op;
  }
}

PrismExpressions::Id PrismExpressions::parse_negation(PrismTokens& in) {
  if (!in.is("!")) return parse_unary(in);
  const Deeper deeper(*this, in.peek().where);
  const std::size_t begin = in.next().where.begin;
  const Id operand = parse_level(in, negation);
  return add(Op::Not, {operand}, {begin, where(operand).end});
}

PrismExpressions::Id PrismExpressions::parse_unary(PrismTokens& in) {
  if (!in.is("-")) return parse_primary(in);
  const Deeper deeper(*this, in.peek().where);
  const std::size_t begin = in.next().where.begin;
  const Id operand = parse_unary(in);
  return add(Op::Negate, {operand}, {begin, where(operand).end});
}

PrismExpressions::Id PrismExpressions::parse_primary(PrismTokens& in) {
  if (queries_) {
    const bool in_path = std::exchange(in_path_, false);
    const std::optional<Id> query = queries_();
    in_path_ = in_path;
    if (query) return *query;
  }
  if (in.accept("(")) {
    const Id inner = in_path_ ? parse_temporal(in) : parse(in);
    in.expect(")");
    return inner;
  }
  const PrismToken token = in.peek();
  if (token.kind == PrismToken::Kind::Number) {
    in.next();
    const Id e = add(Op::Literal, {}, token.where);
    nodes_[e].value = std::strtod(std::string(token.text).c_str(), nullptr);
    nodes_[e].type = token.text.find_first_of(".eE") == std::string_view::npos ? Type::Int : Type::Double;
    return e;
  }
  if (in.is("true") || in.is("false")) {
    in.next();
    const Id e = add(Op::Literal, {}, token.where);
    nodes_[e].value = token.text == "true" ? 1 : 0;
    nodes_[e].type = Type::Bool;
    return e;
  }
  if (token.kind == PrismToken::Kind::String) {
    in.next();
    const Id e = add(Op::Label, {}, token.where);
    nodes_[e].name = token.text;
    return e;
  }
  if (token.kind != PrismToken::Kind::Name) in.fail("expected an expression");
  if (in_path_ && prefix_operator(in)) in.fail("X, F and G below other operators stand in parentheses");
  if (in.is("(", 1)) return parse_call(in);
  in.expect_name("a variable, constant or formula");
  const Id e = add(Op::Name, {}, token.where);
  nodes_[e].name = token.text;
  return e;
}

PrismExpressions::Id PrismExpressions::parse_call(PrismTokens& in) {
  struct Function {
    std::string_view name;
    Op op;
    std::size_t least, most;
  };
  static constexpr std::array<Function, 8> functions{{{"min", Op::Min, 1, SIZE_MAX},
                                                      {"max", Op::Max, 1, SIZE_MAX},
                                                      {"mod", Op::Mod, 2, 2},
                                                      {"floor", Op::Floor, 1, 1},
                                                      {"ceil", Op::Ceil, 1, 1},
                                                      {"pow", Op::Pow, 2, 2},
                                                      {"round", Op::Round, 1, 1},
                                                      {"log", Op::Log, 2, 2}}};
  const PrismToken token = in.peek();
  const auto* found =
      std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.name == token.text; });
  if (found == functions.end()) in.fail("expected one of the functions min, max, mod, floor, ceil, pow, round, log");
  in.next();
  in.expect("(");
  std::vector<Id> operands{parse(in)};
  while (in.accept(",")) operands.push_back(parse(in));
  const std::size_t end = in.expect(")").where.end;
  if (operands.size() < found->least || operands.size() > found->most)
    in.fail({token.where.begin, end}, "the wrong number of arguments");
  return add(found->op, std::move(operands), {token.where.begin, end});
}

PrismExpressions::Id PrismExpressions::parse_path(PrismTokens& in) {
  struct Inside {  // errors leave it, too
    explicit Inside(bool& flag) : flag_(flag), before_(std::exchange(flag, true)) {}
    ~Inside() { flag_ = before_; }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

   private:
    bool& flag_;
    bool before_;
  } const inside(in_path_);
  return parse_temporal(in);
}

// U, W and R bind loosest, then X, F and G, then everything else; U, W and R associate to the left.
PrismExpressions::Id PrismExpressions::parse_temporal(PrismTokens& in) {
  const Deeper level(*this, in.peek().where);
  const std::size_t begin = in.peek().where.begin;
  const auto operand = [&](auto& self) -> Id {
    const std::optional<Op> prefix = prefix_operator(in);
    if (!prefix) return parse(in);
    const Deeper deeper(*this, in.peek().where);
    const std::size_t from = in.next().where.begin;
    const std::optional<Window> window = *prefix == Op::Next ? std::nullopt : parse_window(in);
    const Id inner = self(self);
    return add_path(*prefix, {inner}, window, {from, where(inner).end});
  };
  Id left = operand(operand);
  while (const std::optional<Op> infix = infix_operator(in)) {
    in.next();
    const std::optional<Window> window = parse_window(in);
    const Id right = operand(operand);
    left = add_path(*infix, {left, right}, window, {begin, where(right).end});
  }
  return left;
}

// <=k, <k, >=k, >k, =k or [j,k], of steps or, behind {"name"}, of rewards.
std::optional<PrismExpressions::Window> PrismExpressions::parse_window(PrismTokens& in) {
  Window out;
  if (in.is("{")) {
    in.next();
    if (in.peek().kind != PrismToken::Kind::String) in.fail("expected the name of rewards in quotes");
    out.rewards = std::string(in.next().text);
    in.expect("}");
  }
  const auto number = [&] { return parse_level(in, negation + 2); };
  if (in.accept("<=")) {
    out.most = number();
  } else if (in.accept("<")) {
    out.most = number();
    out.below_most = true;
  } else if (in.accept(">=")) {
    out.least = number();
  } else if (in.accept(">")) {
    out.least = number();
    out.above_least = true;
  } else if (in.accept("=")) {
    out.least = out.most = number();
  } else if (in.accept("[")) {
    out.least = parse(in);
    in.expect(",");
    out.most = parse(in);
    in.expect("]");
  } else {
    if (out.rewards) in.fail("expected a bound on rewards");
    return std::nullopt;
  }
  return out;
}

PrismExpressions::Id PrismExpressions::add_path(Op op, std::vector<Id> operands, std::optional<Window> window,
                                                ltl::Span where) {
  const Id e = add(op, std::move(operands), where);
  nodes_[e].temporal = true;
  if (!window) return e;
  nodes_[e].window = static_cast<std::uint32_t>(windows_.size());
  windows_.push_back(*window);
  return e;
}

}  // namespace waymark::plan
