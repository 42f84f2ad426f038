#include "libplan/model/prism/prism_expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace waymark::plan {

class PrismExpressions::Deeper {
 public:
  Deeper(PrismExpressions& all, ltl::Span where) : depth_(all.depth_) {
    if (depth_ >= deepest) all.tokens_->fail(where, "this is nested too deeply");
    ++depth_;
  }
  ~Deeper() { --depth_; }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;

 private:
  std::size_t& depth_;
};

PrismExpressions::Id PrismExpressions::add(Op op, std::vector<Id> operands, ltl::Span where) {
  std::uint32_t height = 1;
  for (const Id operand : operands) height = std::max(height, nodes_[operand].height + 1);
  if (height > deepest) tokens_->fail(where, "this is nested too deeply");
  Node& node = nodes_.emplace_back();
  node.op = op;
  node.operands = std::move(operands);
  node.where = where;
  node.height = height;
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
    const Id right = parse_level(in, found->level + 1);
    const ltl::Span both{where(left).begin, where(right).end};
    if (found->op == chained && (chained == Op::Or || chained == Op::And || chained == Op::Plus)) {
      nodes_[left].operands.push_back(right);  // a long chain is no deep one
      nodes_[left].height = std::max(nodes_[left].height, nodes_[right].height + 1);
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
  if (in.accept("(")) {
    const Id inner = parse(in);
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
  if (token.kind != PrismToken::Kind::Name) in.fail("expected an expression");
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
  static constexpr std::array<Function, 6> functions{{{"min", Op::Min, 2, SIZE_MAX},
                                                      {"max", Op::Max, 2, SIZE_MAX},
                                                      {"mod", Op::Mod, 2, 2},
                                                      {"floor", Op::Floor, 1, 1},
                                                      {"ceil", Op::Ceil, 1, 1},
                                                      {"pow", Op::Pow, 2, 2}}};
  const PrismToken token = in.peek();
  const auto* found =
      std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.name == token.text; });
  if (found == functions.end()) in.fail("expected one of the functions min, max, mod, floor, ceil, pow");
  in.next();
  in.expect("(");
  std::vector<Id> operands{parse(in)};
  while (in.accept(",")) operands.push_back(parse(in));
  const std::size_t end = in.expect(")").where.end;
  if (operands.size() < found->least || operands.size() > found->most)
    in.fail({token.where.begin, end}, "the wrong number of arguments");
  return add(found->op, std::move(operands), {token.where.begin, end});
}

void PrismExpressions::define(const PrismToken& name, const Meaning& meaning) {
  const auto at = static_cast<std::uint32_t>(meanings_.size());
  if (!names_.emplace(name.text, at).second) tokens_->fail(name.where, "this name has a meaning already");
  meanings_.push_back(meaning);
}
void PrismExpressions::define_variable(const PrismToken& name, std::uint32_t index, Type type) {
  define(name, {.is_variable = true, .variable = index, .type = type});
}
void PrismExpressions::define_formula(const PrismToken& name, Id body) { define(name, {.body = body}); }

PrismExpressions::Type PrismExpressions::type(Id e) {
  using Check = Node::Check;
  if (nodes_[e].checked == Check::Done) return nodes_[e].type;
  if (nodes_[e].checked == Check::Now) tokens_->fail(where(e), "a formula that needs itself");
  const Deeper level(*this, where(e));
  nodes_[e].checked = Check::Now;
  const Type found = find_type(e);
  nodes_[e].type = found;
  nodes_[e].checked = Check::Done;
  return found;
}

void PrismExpressions::expect_type(Id e, Type wanted) {
  const Type found = type(e);
  if (found == wanted || (wanted == Type::Double && found == Type::Int)) return;
  tokens_->fail(where(e), wanted == Type::Bool  ? "expected a condition"
                          : wanted == Type::Int ? "expected a whole number"
                                                : "expected a number");
}

PrismExpressions::Type PrismExpressions::find_type(Id e) {
  const Op op = nodes_[e].op;
  const std::vector<Id> operands = nodes_[e].operands;
  const auto all = [&](Type wanted) {
    for (Id operand : operands) expect_type(operand, wanted);
  };
  const auto numeric = [&] {
    all(Type::Double);
    const bool whole = std::all_of(operands.begin(), operands.end(), [&](Id o) { return type(o) == Type::Int; });
    return whole ? Type::Int : Type::Double;
  };
  switch (op) {
    case Op::Literal: return nodes_[e].type;
    case Op::Name: return type_of_name(e);
    case Op::Choose:
      expect_type(operands[0], Type::Bool);
      if (type(operands[1]) == Type::Bool || type(operands[2]) == Type::Bool) {
        expect_type(operands[1], type(operands[2]));
        return Type::Bool;
      }
      return type(operands[1]) == Type::Int ? type(operands[2]) : Type::Double;
    case Op::Implies:
    case Op::Iff:
    case Op::Or:
    case Op::And:
    case Op::Not: return all(Type::Bool), Type::Bool;
    case Op::Equal:
    case Op::Unequal: all(type(operands[0]) == Type::Bool ? Type::Bool : Type::Double); return Type::Bool;
    case Op::Less:
    case Op::AtMost:
    case Op::Greater:
    case Op::AtLeast: return all(Type::Double), Type::Bool;
    case Op::Plus:
    case Op::Minus:
    case Op::Times:
    case Op::Negate:
    case Op::Min:
    case Op::Max:
    case Op::Pow: return numeric();
    case Op::Divide: return all(Type::Double), Type::Double;
    case Op::Mod: return all(Type::Int), Type::Int;
    case Op::Floor:
    case Op::Ceil: return all(Type::Double), Type::Int;
  }
  return Type::Bool;
}

PrismExpressions::Type PrismExpressions::type_of_name(Id e) {
  const auto at = names_.find(nodes_[e].name);
  if (at == names_.end()) tokens_->fail(where(e), "there is no variable, constant or formula '" + nodes_[e].name + "'");
  nodes_[e].operands.clear();
  nodes_[e].value = at->second;
  const Meaning meaning = meanings_[at->second];
  return meaning.is_variable ? meaning.type : type(meaning.body);
}

double PrismExpressions::value_of_name(const Node& node, const PrismValues& values) {
  Meaning& meaning = meanings_[static_cast<std::size_t>(node.value)];
  if (meaning.is_variable) {
    if (meaning.variable >= values.size()) tokens_->fail(node.where, "a variable where a constant is expected");
    return values[meaning.variable];
  }
  if (meaning.known_at != now_) {
    const double found = value(meaning.body, values);
    meaning.value = found;
    meaning.known_at = now_;
  }
  return meaning.value;
}

double PrismExpressions::value(Id e, const PrismValues& values) {
  const Node& node = nodes_[e];
  const auto operand = [&](std::size_t i) { return value(node.operands[i], values); };
  const auto truth = [](bool b) { return b ? 1.0 : 0.0; };
  switch (node.op) {
    case Op::Literal: return node.value;
    case Op::Name: return value_of_name(node, values);
    case Op::Choose: return operand(0) != 0 ? operand(1) : operand(2);
    case Op::Implies: return operand(0) != 0 ? operand(1) : 1;
    case Op::Iff:
    case Op::Equal: return truth(operand(0) == operand(1));
    case Op::Or:
    case Op::And: {
      const bool decides = node.op == Op::Or;
      for (const Id o : node.operands)
        if ((value(o, values) != 0) == decides) return truth(decides);
      return truth(!decides);
    }
    case Op::Not: return truth(operand(0) == 0);
    case Op::Unequal: return truth(operand(0) != operand(1));
    case Op::Less: return truth(operand(0) < operand(1));
    case Op::AtMost: return truth(operand(0) <= operand(1));
    case Op::Greater: return truth(operand(0) > operand(1));
    case Op::AtLeast: return truth(operand(0) >= operand(1));
    case Op::Plus: {
      double sum = operand(0);
      for (std::size_t i = 1; i < node.operands.size(); ++i) sum += operand(i);
      return sum;
    }
    case Op::Minus: return operand(0) - operand(1);
    case Op::Times: return operand(0) * operand(1);
    case Op::Divide: return operand(0) / operand(1);
    case Op::Negate: return -operand(0);
    case Op::Min:
    case Op::Max: {
      double best = operand(0);
      for (std::size_t i = 1; i < node.operands.size(); ++i)
        best = node.op == Op::Min ? std::min(best, operand(i)) : std::max(best, operand(i));
      return best;
    }
    case Op::Mod: {  // never negative, as in PRISM
      const double a = operand(0), b = operand(1);
      if (!(b > 0)) tokens_->fail(node.where, "mod by a number that is not positive");
      return a - b * std::floor(a / b);
    }
    case Op::Floor: return std::floor(operand(0));
    case Op::Ceil: return std::ceil(operand(0));
    case Op::Pow: return std::pow(operand(0), operand(1));
  }
  return 0;
}

double PrismExpressions::constant(Id e) {
  next_state();
  const double found = value(e, {});
  next_state();
  return found;
}

}  // namespace waymark::plan
