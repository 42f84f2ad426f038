#include "libplan/model/prism/default_labels.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace waymark::plan {
namespace {

using Id = PrismProgram::Id;
using Op = PrismExpressions::Op;

bool has_label(const PrismProgram& program, std::string_view name) {
  return std::any_of(program.labels.begin(), program.labels.end(),
                     [&](const PrismProgram::Label& l) { return l.name == name; });
}

Id any_of(PrismExpressions& expressions, std::vector<Id> conditions) {
  if (conditions.empty()) return expressions.number(0, PrismExpressions::Type::Bool);
  return conditions.size() == 1 ? conditions[0] : expressions.add(Op::Or, std::move(conditions), {});
}

Id at_start(const PrismProgram& program, PrismExpressions& expressions) {
  if (program.start) return *program.start;
  std::string text;
  for (const PrismProgram::Variable& v : program.variables) {
    const bool truth = v.type == PrismProgram::Type::Bool;
    const auto value = static_cast<std::int64_t>(v.first);
    text +=
        (text.empty() ? "" : "&") + v.name + '=' + (truth ? (value != 0 ? "true" : "false") : std::to_string(value));
  }
  PrismTokens tokens(text, "");
  return expressions.parse(tokens);
}

Id at_deadlock(const PrismProgram& program, PrismExpressions& expressions) {
  std::vector<Id> enabled;
  std::map<std::string, std::vector<Id>> together;  // by action: what each module that has it is to offer
  for (const PrismProgram::Module& module : program.modules) {
    std::map<std::string, std::vector<Id>> guards;
    for (const PrismProgram::Command& command : module.commands) guards[command.action].push_back(command.guard);
    for (auto& [action, conditions] : guards)
      (action.empty() ? enabled : together[action]).push_back(any_of(expressions, std::move(conditions)));
  }
  for (auto& [action, offers] : together)
    enabled.push_back(offers.size() == 1 ? offers[0] : expressions.add(Op::And, std::move(offers), {}));
  return expressions.add(Op::Not, {any_of(expressions, std::move(enabled))}, {});
}

}  // namespace

void define_labels_of_every_model(const PrismProgram& program, PrismExpressions& expressions) {
  using Define = Id (*)(const PrismProgram&, PrismExpressions&);
  for (const auto& [name, define] : {std::pair<const char*, Define>{"init", at_start}, {"deadlock", at_deadlock}}) {
    const PrismToken token{PrismToken::Kind::String, name, {}};
    if (!has_label(program, name)) expressions.define_label(token, define(program, expressions));
  }
}

}  // namespace waymark::plan
