#include "libparser/model/typed_postfix.hpp"

#include <algorithm>
#include <cassert>

#include "libparser/model/features.hpp"

namespace waymark::parser {

TypedPostfix::TypedPostfix(const ProgramLanguage& language)
    : grammar_(language.grammar()), place_numbers_(place_numbers(language)) {
  const PostfixGrammar& grammar = grammar_;
  const Columns& columns = language.columns();
  for (Token t = 0; t < PostfixGrammar::first_literal; ++t) names_.push_back(grammar.name(t));
  first_thing_ = static_cast<Symbol>(names_.size());
  const auto add = [&](const Part& part) {
    const Symbol known = find(part);
    if (known < symbols()) return known;
    names_.push_back(part.name);
    shared_.push_back(part);
    return static_cast<Symbol>(names_.size() - 1);
  };
  const Token literals = grammar.end_of_literals();
  for (Token t = PostfixGrammar::first_literal; t < literals; ++t)
    parts_.emplace_back(add(columns.part(columns.thing[t])), 0);
  first_direction_ = static_cast<Symbol>(names_.size());
  for (Token t = PostfixGrammar::first_literal; t < literals; ++t)
    parts_[t - PostfixGrammar::first_literal].second = add(columns.part(columns.direction[t]));
  first_temporal_ = static_cast<Symbol>(names_.size());
  for (std::size_t t = literals; t < grammar.tokens(); ++t) names_.push_back(grammar.name(static_cast<Token>(t)));
  const std::size_t directions = first_temporal_ - first_direction_;
  literals_.assign((first_direction_ - first_thing_) * directions, PostfixGrammar::end);
  for (Token t = PostfixGrammar::first_literal; t < literals; ++t) {
    const auto [thing, direction] = parts_[t - PostfixGrammar::first_literal];
    literals_[(thing - first_thing_) * directions + (direction - first_direction_)] = t;
  }
}

Symbol TypedPostfix::find(const Part& part) const {
  const auto it = std::find(shared_.begin(), shared_.end(), part);
  return static_cast<Symbol>(it == shared_.end() ? symbols()
                                                 : first_thing_ + static_cast<std::size_t>(it - shared_.begin()));
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
  if (state.thing == TypedState::nothing) return {grammar_.after(state.prefix, token_of(symbol)), TypedState::nothing};
  return {grammar_.after(state.prefix, literal(state.thing, symbol)), TypedState::nothing};
}

std::vector<bool> TypedPostfix::forbidden(const std::vector<bool>& named) const {
  std::vector<bool> out(symbols(), false);
  for (std::size_t l = 0; l < parts_.size(); ++l) {
    const std::size_t n = place_numbers_[l];
    if (n > 0 && (n >= named.size() || !named[n])) out[parts_[l].first] = true;
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
