#include "libplan/model/jani/jani_declarations.hpp"

#include <cmath>

namespace waymark::plan {

JaniName& JaniDeclarations::add(JaniText::Id named, JaniNames& into) {
  const JaniText::Id at = text_.member(named, "name");
  const std::string& name = text_.text(at);
  if (name.empty()) text_.fail(at, "a name is missing");
  if (names_.find(name, &into) != nullptr) text_.fail(at, "the name '" + name + "' has a meaning already");
  return into.names[name];
}

void JaniDeclarations::constants(JaniText::Id document, const PrismConstants& given) {
  for (const JaniText::Id constant : text_.list(document, "constants")) {
    text_.expect_keys(constant, {"name", "type", "value"});
    const JaniText::Id at = text_.member(constant, "name");
    const std::string& name = text_.text(at);
    const Range range = this->range(text_.member(constant, "type"));
    const auto outside = given.find(name);
    std::optional<PrismExpressions::Id> literal;
    if (const auto value = text_.find(constant, "value")) {
      if (outside != given.end()) text_.fail(at, "this constant has a value already");
      const double found = names_.constant(*value, range.type);
      literal = names_.literal(found, range.type, *value);
    } else {
      if (outside == given.end()) text_.fail(at, "the constant " + name + " has no value: give one with --const");
      program_.given.push_back(name);
      literal = prism_literal(expressions_, outside->second, range.type);
      if (!literal) text_.fail(at, "the value " + outside->second + " given for the constant is of another type");
    }
    const double value = expressions_.constant(*literal);
    if (range.finite && !(value >= range.from && value <= range.to)) text_.fail(at, "the constant is out of its range");
    add(constant, names_.document()) = {.type = range.type, .in_state = literal};
  }
}

JaniDeclarations::Range JaniDeclarations::range(JaniText::Id type) {
  if (text_.kind(type) == JaniText::Kind::Text) {
    const std::string& name = text_.text(type);
    if (name == "bool") return {.type = Type::Bool};
    if (name == "int") return {.from = -most_jani_int, .to = most_jani_int};
    if (name == "real") return {.type = Type::Double, .finite = false};
    text_.fail(type, "the type '" + name + "' is not read: bool, int, bounded int and real are");
  }
  const JaniText::Id kind = text_.member(type, "kind");
  if (text_.text(kind) != "bounded") text_.fail(kind, "the kind '" + text_.text(kind) + "' is not read: bounded is");
  text_.expect_keys(type, {"kind", "base", "lower-bound", "upper-bound"});
  const JaniText::Id base = text_.member(type, "base");
  const bool real = text_.text(base) == "real";
  if (!real && text_.text(base) != "int") text_.fail(base, "expected the base int or real");
  Range out{real ? Type::Double : Type::Int, !real, -most_jani_int, most_jani_int};
  if (const auto lower = text_.find(type, "lower-bound")) out.from = names_.constant(*lower, out.type);
  if (const auto upper = text_.find(type, "upper-bound")) out.to = names_.constant(*upper, out.type);
  if (!(out.from <= out.to)) text_.fail(type, "the range is empty");
  if (!(out.to - out.from < 4e9) || !(std::abs(out.from) < 1e15)) text_.fail(type, "the range is too wide");
  return out;
}

void JaniDeclarations::variables(JaniText::Id owner, JaniNames& into, std::vector<Transient>& transient) {
  for (const JaniText::Id v : text_.list(owner, "variables")) variable(v, into, transient);
}

void JaniDeclarations::variable(JaniText::Id variable, JaniNames& into, std::vector<Transient>& transient) {
  text_.expect_keys(variable, {"name", "type", "transient", "initial-value"});
  const JaniText::Id type = text_.member(variable, "type");
  const Range range = this->range(type);
  const auto initial = text_.find(variable, "initial-value");
  const auto lasts = text_.find(variable, "transient");
  JaniName& name = add(variable, into);
  name.type = range.type;
  if (lasts && text_.truth(*lasts)) {
    name.transient = true;
    const double first = names_.constant(text_.member(variable, "initial-value"), range.type);
    transient.push_back({text_.text(text_.member(variable, "name")), &name, first});
    return;
  }
  if (!range.finite) text_.fail(type, "a real variable is read where it is transient: states are to be finitely many");
  PrismProgram::Variable out;
  out.name = text_.text(text_.member(variable, "name"));
  out.where = JaniText::where(variable);
  out.type = range.type;
  out.from = out.first = range.from;
  out.to = range.to;
  out.fixed = initial.has_value();
  if (initial) out.first = names_.constant(*initial, range.type);
  if (!(out.first >= out.from && out.first <= out.to)) text_.fail(*initial, "the initial value is out of range");
  name.variable = static_cast<std::uint32_t>(program_.variables.size());
  program_.variables.push_back(std::move(out));
}

void JaniDeclarations::functions(JaniText::Id owner, JaniNames& into) {
  for (const JaniText::Id function : text_.list(owner, "functions")) {
    text_.expect_keys(function, {"name", "type", "parameters", "body"});
    JaniFunction out{text_.member(function, "body"), {}, range(text_.member(function, "type")).type};
    for (const JaniText::Id parameter : text_.list(function, "parameters")) {
      text_.expect_keys(parameter, {"name", "type"});
      out.parameters.emplace_back(text_.text(text_.member(parameter, "name")),
                                  range(text_.member(parameter, "type")).type);
    }
    const JaniText::Id name = text_.member(function, "name");
    if (!into.functions.emplace(text_.text(name), std::move(out)).second)
      text_.fail(name, "a second function of this name");
  }
}

}  // namespace waymark::plan
