#include "libplan/model/prism/prism_expression.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::plan {

void PrismExpressions::define(const PrismToken& name, const Meaning& meaning) {
  const auto at = static_cast<std::uint32_t>(meanings_.size());
  if (!names_.emplace(name.text, at).second) text_->fail(name.where, "this name has a meaning already");
  meanings_.push_back(meaning);
}
void PrismExpressions::define_variable(const PrismToken& name, std::uint32_t index, Type type) {
  define(name, {.is_variable = true, .variable = index, .type = type});
}
void PrismExpressions::define_formula(const PrismToken& name, Id body) { define(name, {.body = body}); }
void PrismExpressions::define_label(const PrismToken& name, Id body) {
  if (name.text.empty()) text_->fail(name.where, "a label needs a name");
  if (!labels_.emplace(name.text, body).second) text_->fail(name.where, "this label has a meaning already");
}

PrismExpressions::Id PrismExpressions::number(double value, Type type, ltl::Span where) {
  const Id e = add(Op::Literal, {}, where);
  nodes_[e].value = value;
  nodes_[e].type = type;
  return e;
}

PrismExpressions::Id PrismExpressions::variable(std::uint32_t index, Type type, ltl::Span where) {
  const Id e = add(Op::Name, {}, where);
  nodes_[e].value = static_cast<double>(meanings_.size());
  nodes_[e].type = type;
  nodes_[e].checked = Node::Check::Done;
  meanings_.push_back({.is_variable = true, .variable = index, .type = type});
  return e;
}

PrismExpressions::Id PrismExpressions::query(Type type, ltl::Span where) {
  const Id e = add(Op::Query, {}, where);
  nodes_[e].type = type;
  nodes_[e].temporal = true;
  return e;
}

PrismExpressions::Id PrismExpressions::renamed(Id e, const std::map<std::string, std::string, std::less<>>& names) {
  const Deeper level(*this, where(e));
  if (nodes_[e].op == Op::Name) {
    if (const auto to = names.find(nodes_[e].name); to != names.end()) {
      const Id out = add(Op::Name, {}, where(e));
      nodes_[out].name = to->second;
      return out;
    }
    const auto at = names_.find(nodes_[e].name);
    if (at == names_.end() || meanings_[at->second].is_variable) return e;
    const Id body = meanings_[at->second].body, changed = renamed(body, names);
    return changed == body ? e : changed;
  }
  const std::vector<Id> operands = nodes_[e].operands;
  std::vector<Id> changed;
  for (const Id operand : operands) changed.push_back(renamed(operand, names));
  return changed == operands ? e : add(nodes_[e].op, std::move(changed), where(e));
}

const PrismExpressions::Window* PrismExpressions::window(Id e) const {
  return nodes_[e].window ? &windows_[*nodes_[e].window] : nullptr;
}

PrismExpressions::Type PrismExpressions::type(Id e) {
  using Check = Node::Check;
  if (nodes_[e].checked == Check::Done) return nodes_[e].type;
  if (nodes_[e].checked == Check::Now) text_->fail(where(e), "a formula that needs itself");
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
  text_->fail(where(e), wanted == Type::Bool  ? "expected a condition"
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
    case Op::Label: return type_of_label(e);
    case Op::Choose:
      expect_type(operands[0], Type::Bool);
      if (type(operands[1]) == Type::Bool || type(operands[2]) == Type::Bool) {
        expect_type(operands[1], type(operands[2]));
        return Type::Bool;
      }
      return type(operands[1]) == Type::Int ? type(operands[2]) : Type::Double;
    case Op::Pick: {
      expect_type(operands[0], Type::Int);
      Type all_of = type(operands[1]);
      for (std::size_t i = 2; i < operands.size(); ++i) {
        if (all_of == Type::Bool || type(operands[i]) == Type::Bool) expect_type(operands[i], all_of);
        if (type(operands[i]) == Type::Double) all_of = Type::Double;
      }
      return all_of;
    }
    case Op::Implies:
    case Op::Iff:
    case Op::Or:
    case Op::And:
    case Op::Not:
    case Op::Next:
    case Op::Eventually:
    case Op::Always:
    case Op::Until:
    case Op::WeakUntil:
    case Op::Release: return all(Type::Bool), Type::Bool;
    case Op::Query: return nodes_[e].type;
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
    case Op::Divide:
    case Op::Log: return all(Type::Double), Type::Double;
    case Op::Mod: return all(Type::Int), Type::Int;
    case Op::Floor:
    case Op::Ceil:
    case Op::Round: return all(Type::Double), Type::Int;
  }
  return Type::Bool;
}

PrismExpressions::Type PrismExpressions::type_of_name(Id e) {
  const auto at = names_.find(nodes_[e].name);
  if (at == names_.end()) text_->fail(where(e), "there is no variable, constant or formula '" + nodes_[e].name + "'");
  nodes_[e].operands.clear();
  nodes_[e].value = at->second;
  const Meaning meaning = meanings_[at->second];
  return meaning.is_variable ? meaning.type : type(meaning.body);
}

PrismExpressions::Type PrismExpressions::type_of_label(Id e) {
  const auto at = labels_.find(nodes_[e].name);
  if (at == labels_.end()) text_->fail(where(e), "there is no label \"" + nodes_[e].name + '"');
  nodes_[e].operands = {at->second};
  expect_type(at->second, Type::Bool);
  return Type::Bool;
}

double PrismExpressions::value_of_name(const Node& node, const PrismValues& values) {
  Meaning& meaning = meanings_[static_cast<std::size_t>(node.value)];
  if (meaning.is_variable) {
    if (meaning.variable >= values.size()) text_->fail(node.where, "a variable where a constant is expected");
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
    case Op::Label: return operand(0);
    case Op::Choose: return operand(0) != 0 ? operand(1) : operand(2);
    case Op::Pick: return operand(1 + static_cast<std::size_t>(operand(0)));
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
      if (!(b > 0)) text_->fail(node.where, "mod by a number that is not positive");
      return a - b * std::floor(a / b);
    }
    case Op::Floor: return std::floor(operand(0));
    case Op::Ceil: return std::ceil(operand(0));
    case Op::Pow: return std::pow(operand(0), operand(1));
    case Op::Round: return std::floor(operand(0) + 0.5);
    case Op::Log: return std::log(operand(0)) / std::log(operand(1));
    case Op::Next:
    case Op::Eventually:
    case Op::Always:
    case Op::Until:
    case Op::WeakUntil:
    case Op::Release:
    case Op::Query: break;
  }
  text_->fail(node.where, "a path formula where an expression is expected");
}

double PrismExpressions::constant(Id e) {
  next_state();
  const double found = value(e, {});
  next_state();
  return found;
}

}  // namespace waymark::plan
