#include "libautomata/hoa/labels.hpp"

#include <string>

namespace waymark::automata {

namespace {
using Kind = HoaToken::Kind;
using Node = Mtbdd::Node;
}  // namespace

void HoaLabels::define(const HoaToken& alias) {
  const Node meaning = disjunction(0);
  if (cursor_.peek().kind != Kind::Header && cursor_.peek().kind != Kind::Body)
    cursor_.expected("the end of the alias");
  if (!meaning_.emplace(alias.text, meaning).second) cursor_.fail(alias, "a second alias " + described(alias));
}

std::optional<Node> HoaLabels::label() {
  if (!cursor_.accept('[')) return std::nullopt;
  const Node meaning = disjunction(0);
  cursor_.demand(']');
  return meaning;
}

Node HoaLabels::letter(std::size_t i) {
  const Node no = Boolean::constant(false);
  Node all = Boolean::constant(true);
  for (std::size_t v = propositions_; v-- > 0;) {
    const bool member = ((i >> v) & 1U) != 0;
    all = diagram_.make(static_cast<Mtbdd::Variable>(v), member ? no : all, member ? all : no);
  }
  return all;
}

Node HoaLabels::disjunction(std::size_t depth) {
  Node all = conjunction(depth);
  while (cursor_.accept('|')) all = logic_.disjunction(all, conjunction(depth));
  return all;
}

Node HoaLabels::conjunction(std::size_t depth) {
  Node all = literal(depth);
  while (cursor_.accept('&')) all = logic_.conjunction(all, literal(depth));
  return all;
}

Node HoaLabels::literal(std::size_t depth) {
  const HoaToken token = cursor_.peek();
  if (depth > deepest) cursor_.fail(token, "this label is nested too deeply");
  if (cursor_.accept('!')) return logic_.negate(literal(depth + 1));
  if (cursor_.accept('(')) {
    const Node inner = disjunction(depth + 1);
    cursor_.demand(')');
    return inner;
  }
  if (token.kind == Kind::Integer) {
    if (token.value >= propositions_)
      cursor_.fail(token, "proposition " + std::to_string(token.value) + " of " + std::to_string(propositions_));
    cursor_.take();
    return logic_.variable(static_cast<Mtbdd::Variable>(token.value));
  }
  if (token.kind == Kind::Alias) {
    const auto known = meaning_.find(token.text);
    if (known == meaning_.end()) cursor_.fail(token, "unknown alias " + described(token));
    cursor_.take();
    return known->second;
  }
  if (token.kind != Kind::Identifier || (token.text != "t" && token.text != "f"))
    cursor_.expected("a proposition's number, t, f, an alias, '!' or '('");
  cursor_.take();
  return Boolean::constant(token.text == "t");
}

}  // namespace waymark::automata
