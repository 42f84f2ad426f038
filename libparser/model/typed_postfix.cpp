#include "libparser/model/typed_postfix.hpp"

#include <algorithm>
#include <cassert>

#include "libparser/lexicon/lexicon.hpp"

namespace waymark::parser {

TypedPostfix::TypedPostfix(const PostfixGrammar& grammar, const Columns& columns) : grammar_(grammar) {
  for (Token t = 0; t < PostfixGrammar::first_literal; ++t) names_.push_back(grammar.name(t));
  first_thing_ = static_cast<Symbol>(names_.size());
  const auto column = [&](std::uint16_t c) { return columns.parts[c - columns.tokens]; };
  const auto add = [&](const std::string& part) {
    const Symbol known = find(part);
    if (known < symbols()) return known;
    names_.push_back(part.substr(part.find(' ') + 1));
    columns_.push_back(part);
    return static_cast<Symbol>(names_.size() - 1);
  };
  const Token literals = grammar.end_of_literals();
  for (Token t = PostfixGrammar::first_literal; t < literals; ++t)
    parts_.emplace_back(add(column(columns.thing[t])), 0);
  first_direction_ = static_cast<Symbol>(names_.size());
  for (Token t = PostfixGrammar::first_literal; t < literals; ++t)
    parts_[t - PostfixGrammar::first_literal].second = add(column(columns.direction[t]));
  first_temporal_ = static_cast<Symbol>(names_.size());
  for (std::size_t t = literals; t < grammar.tokens(); ++t)
    names_.push_back(grammar.name(static_cast<Token>(t)));
  const std::size_t directions = first_temporal_ - first_direction_;
  literals_.assign((first_direction_ - first_thing_) * directions, PostfixGrammar::end);
  for (Token t = PostfixGrammar::first_literal; t < literals; ++t) {
    const auto [thing, direction] = parts_[t - PostfixGrammar::first_literal];
    literals_[(thing - first_thing_) * directions + (direction - first_direction_)] = t;
  }
}

Symbol TypedPostfix::find(const std::string& column) const {
  const auto it = std::find(columns_.begin(), columns_.end(), column);
  return static_cast<Symbol>(
      it == columns_.end() ? symbols() : first_thing_ + static_cast<std::size_t>(it - columns_.begin()));
}

Token TypedPostfix::literal(Symbol thing, Symbol direction) const {
  const std::size_t directions = first_temporal_ - first_direction_;
  return literals_[(thing - first_thing_) * directions + (direction - first_direction_)];
}

Symbol TypedPostfix::symbol_of(Token token) const {
  if (token < PostfixGrammar::first_literal) return token;
  if (grammar_.is_literal(token)) return parts_[token - PostfixGrammar::first_literal].first;
  return static_cast<Symbol>(first_temporal_ + (token - grammar_.end_of_literals()));
}

Token TypedPostfix::token_of(Symbol symbol) const {
  if (symbol < first_temporal_) return symbol;
  return static_cast<Token>(grammar_.end_of_literals() + (symbol - first_temporal_));
}

std::vector<bool> TypedPostfix::allowed(const TypedState& state) const {
  std::vector<bool> out(symbols(), false);
  if (state.thing != TypedState::nothing) {
    for (Symbol d = first_direction_; d < first_temporal_; ++d) {
      const Token token = literal(state.thing, d);
      out[d] = token != PostfixGrammar::end && grammar_.allowed(state.prefix, token);
    }
    return out;
  }
  grammar_.choices(state.prefix).each([&](Token token) {
    if (grammar_.allowed(state.prefix, token)) out[symbol_of(token)] = true;
  });
  return out;
}

std::optional<Symbol> TypedPostfix::forced(const TypedState& state) const {
  if (state.prefix.ended) return std::nullopt;
  const std::vector<bool> choices = allowed(state);
  if (std::count(choices.begin(), choices.end(), true) != 1) return std::nullopt;
  return static_cast<Symbol>(std::find(choices.begin(), choices.end(), true) - choices.begin());
}

TypedState TypedPostfix::after(const TypedState& state, Symbol symbol) const {
  if (is_thing(symbol)) return {state.prefix, symbol};
  if (state.thing == TypedState::nothing)
    return {grammar_.after(state.prefix, token_of(symbol)), TypedState::nothing};
  return {grammar_.after(state.prefix, literal(state.thing, symbol)), TypedState::nothing};
}

std::vector<bool> TypedPostfix::forbidden(const std::vector<bool>& named) const {
  std::vector<bool> out(symbols(), false);
  for (std::size_t l = 0; l < parts_.size(); ++l) {
    const std::string& literal_name = grammar_.name(static_cast<Token>(PostfixGrammar::first_literal + l));
    if (literal_name.rfind("place_", 0) != 0) continue;
    const std::size_t n = number_named(literal_name.substr(6));
    out[parts_[l].first] = n > 0 && (n >= named.size() || !named[n]);
  }
  return out;
}

std::vector<Symbol> TypedPostfix::symbols_of(const Program& program) const {
  std::vector<Symbol> out;
  for (const Token token : grammar_.tokens_of(program)) {
    if (!grammar_.is_literal(token)) {
      out.push_back(symbol_of(token));
      continue;
    }
    const auto [thing, direction] = parts_[token - PostfixGrammar::first_literal];
    out.insert(out.end(), {thing, direction});
  }
  return out;
}

Program TypedPostfix::program_of(std::span<const Symbol> symbols) const {
  std::vector<Token> tokens;
  Symbol thing = TypedState::nothing;
  for (const Symbol symbol : symbols) {
    if (is_thing(symbol)) {
      thing = symbol;
    } else if (is_direction(symbol)) {
      assert(thing != TypedState::nothing);
      tokens.push_back(literal(thing, symbol));
    } else {
      tokens.push_back(token_of(symbol));
    }
  }
  return grammar_.program_of(tokens);
}

}  // namespace waymark::parser
