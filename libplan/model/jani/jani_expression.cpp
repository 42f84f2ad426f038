#include "libplan/model/jani/jani_expression.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

namespace waymark::plan {
namespace {

using Id = PrismExpressions::Id;
using Op = PrismOp;

struct Operator {
  std::string_view name;
  Op op;
};
constexpr std::array<Operator, 18> binary{{{"∨", Op::Or},
                                           {"∧", Op::And},
                                           {"⇒", Op::Implies},
                                           {"=", Op::Equal},
                                           {"≠", Op::Unequal},
                                           {"<", Op::Less},
                                           {"≤", Op::AtMost},
                                           {">", Op::Greater},
                                           {"≥", Op::AtLeast},
                                           {"+", Op::Plus},
                                           {"-", Op::Minus},
                                           {"*", Op::Times},
                                           {"/", Op::Divide},
                                           {"%", Op::Mod},
                                           {"min", Op::Min},
                                           {"max", Op::Max},
                                           {"pow", Op::Pow},
                                           {"log", Op::Log}}};
constexpr std::array<Operator, 3> unary{{{"¬", Op::Not}, {"floor", Op::Floor}, {"ceil", Op::Ceil}}};

constexpr const char* too_large = "more than 100,000 operators, functions written out";

template <std::size_t N>
std::optional<Op> find_operator(const std::array<Operator, N>& all, std::string_view name) {
  for (const Operator& candidate : all)
    if (candidate.name == name) return candidate.op;
  return std::nullopt;
}

}  // namespace

Id JaniExpressions::read(JaniText::Id value, Type type, const JaniNames* own, Moment moment) {
  const Id out = read(value, own, moment);
  expressions_.expect_type(out, type);
  return out;
}
Id JaniExpressions::read(JaniText::Id value, const JaniNames* own, Moment moment) {
  depth_ = lowered_ = 0;  // an error may have left them
  calling_.clear();
  whole_ = value;
  return lower(value, {own, moment, nullptr});
}
double JaniExpressions::constant(JaniText::Id value, Type type) {
  return expressions_.constant(read(value, type, nullptr, Moment::State));
}

const JaniName* JaniExpressions::find(const std::string& name, const JaniNames* own) const {
  for (const JaniNames* names : {own, &document_})
    if (names != nullptr)
      if (const auto at = names->names.find(name); at != names->names.end()) return &at->second;
  return nullptr;
}

Id JaniExpressions::made(Op op, std::vector<Id> operands, JaniText::Id where) {
  std::size_t size = 1;
  for (const Id operand : operands) {
    const std::size_t part = operand < sizes_.size() ? sizes_[operand] : 1;
    size = op == Op::Pick ? std::max(size, part + 2) : size + part;  // of many one is evaluated
  }
  if (size > most_operators) text_.fail(whole_, too_large);
  const Id out = expressions_.add(op, std::move(operands), JaniText::where(where));
  sizes_.resize(out + 1, 1);
  sizes_[out] = static_cast<std::uint32_t>(size);
  return out;
}

Id JaniExpressions::lower(JaniText::Id value, const Scope& scope) {
  if (depth_ >= PrismExpressions::deepest) text_.fail(whole_, "this is nested too deeply");
  if (++lowered_ > most_operators) text_.fail(whole_, too_large);
  ++depth_;
  Id out = 0;
  switch (text_.kind(value)) {
    case JaniText::Kind::Bool: out = literal(text_.truth(value) ? 1 : 0, Type::Bool, value); break;
    case JaniText::Kind::Number:
      out = literal(text_.number(value), text_.is_whole(value) ? Type::Int : Type::Double, value);
      break;
    case JaniText::Kind::Text: out = name(value, scope); break;
    case JaniText::Kind::Object: out = operation(value, scope); break;
    case JaniText::Kind::Null:
    case JaniText::Kind::List: text_.fail(value, "expected an expression");
  }
  --depth_;
  return out;
}

Id JaniExpressions::name(JaniText::Id value, const Scope& scope) {
  const std::string& name = text_.text(value);
  if (scope.arguments != nullptr)
    if (const auto at = scope.arguments->find(name); at != scope.arguments->end()) return at->second;
  const JaniName* meaning = find(name, scope.own);
  if (meaning == nullptr) text_.fail(value, "there is no variable or constant '" + name + "'");
  if (!meaning->variable || (meaning->transient && scope.moment == Moment::State)) {
    if (!meaning->in_state) text_.fail(value, "the transient variable '" + name + "' has no value here");
    return *meaning->in_state;
  }
  return expressions_.variable(*meaning->variable, meaning->type, JaniText::where(value));
}

Id JaniExpressions::operation(JaniText::Id value, const Scope& scope) {
  if (const auto constant = text_.find(value, "constant")) {
    text_.expect_keys(value, {"constant"});
    const std::string& which = text_.text(*constant);
    if (which != "e" && which != "π") text_.fail(*constant, "expected the constant e or π");
    return literal(which == "e" ? std::numbers::e : std::numbers::pi, Type::Double, value);
  }
  const JaniText::Id at = text_.member(value, "op");
  const std::string& op = text_.text(at);
  const auto part = [&](std::string_view key) { return lower(text_.member(value, key), scope); };
  if (const auto found = find_operator(binary, op)) {
    text_.expect_keys(value, {"op", "left", "right"});
    const Id left = part("left"), right = part("right");
    return made(*found, {left, right}, value);
  }
  if (op == "ite") {
    text_.expect_keys(value, {"op", "if", "then", "else"});
    const Id condition = part("if"), yes = part("then"), no = part("else");
    return made(Op::Choose, {condition, yes, no}, value);
  }
  if (op == "call") return call(value, scope);
  text_.expect_keys(value, {"op", "exp"});
  if (const auto found = find_operator(unary, op)) return made(*found, {part("exp")}, value);
  const Id zero = literal(0, Type::Int), operand = op == "abs" || op == "sgn" || op == "trc" ? part("exp") : zero;
  if (op == "abs") return made(Op::Max, {operand, made(Op::Negate, {operand}, value)}, value);
  if (op == "sgn") return sign(operand, value);
  if (op == "trc")
    return made(
        Op::Choose,
        {made(Op::Less, {operand, zero}, value), made(Op::Ceil, {operand}, value), made(Op::Floor, {operand}, value)},
        value);
  text_.fail(at, "the operator '" + op + "' is not read here: what is read is docs/formats/prism.md");
}

Id JaniExpressions::sign(Id operand, JaniText::Id where) {
  const Id zero = literal(0, Type::Int), one = literal(1, Type::Int), less = literal(-1, Type::Int);
  const Id positive = made(Op::Choose, {made(Op::Greater, {operand, zero}, where), one, zero}, where);
  return made(Op::Choose, {made(Op::Less, {operand, zero}, where), less, positive}, where);
}

Id JaniExpressions::call(JaniText::Id value, const Scope& scope) {
  text_.expect_keys(value, {"op", "function", "args"});
  const JaniText::Id name = text_.member(value, "function");
  const JaniFunction* function = nullptr;
  const JaniNames* own = nullptr;
  for (const JaniNames* names : {scope.own, static_cast<const JaniNames*>(&document_)}) {
    if (names == nullptr || function != nullptr) continue;
    const auto at = names->functions.find(text_.text(name));
    if (at == names->functions.end()) continue;
    function = &at->second;
    own = names == &document_ ? nullptr : names;
  }
  if (function == nullptr) text_.fail(name, "there is no function '" + text_.text(name) + "'");
  if (std::find(calling_.begin(), calling_.end(), function) != calling_.end())
    text_.fail(value, "a function that calls itself");
  const std::vector<JaniText::Id> given = text_.list(value, "args");
  if (given.size() != function->parameters.size()) text_.fail(value, "the wrong number of arguments");
  std::map<std::string, Id, std::less<>> arguments;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Id argument = lower(given[i], scope);
    expressions_.expect_type(argument, function->parameters[i].second);
    arguments[function->parameters[i].first] = argument;
  }
  calling_.push_back(function);
  const Id out = lower(function->body, {own, scope.moment, &arguments});
  expressions_.expect_type(out, function->type);
  calling_.pop_back();
  return out;
}

}  // namespace waymark::plan
