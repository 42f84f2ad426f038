// Typed postfix, symbol by symbol: a literal is a thing followed by its direction.
//
//   chair, fish, blue, corner, 3 …    : Object, Wall, Floor, Place          ahead, left, behind, here …  : thing → Bool
//   &, reach, advance, forward_2, then, end, without, apply …               as in postfix_grammar.hpp
// "turn left, go to the chair ahead"  =  left turned next  chair ahead reach  then  end
// So a decoder that has learned what `ahead` is knows ahead_lamp without having met it. Which thing goes with which
// direction follows from the vocabulary; canonical order and types are PostfixGrammar's, and decoding asks `allowed`.
// Source: the typed postfix formulas of the paper; its λ terms are not needed for a propositional task language.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "libparser/model/program_language.hpp"
#include "libparser/programs/program.hpp"

namespace waymark::parser {

using Symbol = std::uint16_t;  // a number of the language

struct TypedState {                              // of a prefix
  static constexpr Symbol nothing = UINT16_MAX;  // no thing waits
  PrefixState prefix;                            // of the program
  Symbol thing = nothing;                        // waits for its direction
  friend bool operator==(const TypedState&, const TypedState&) = default;
};

class TypedPostfix {
 public:
  explicit TypedPostfix(const ProgramLanguage& language);  // copies what it needs

  std::size_t symbols() const { return names_.size(); }                    // how many
  const std::string& name(Symbol symbol) const { return names_[symbol]; }  // as shown by explanations
  Symbol find(const Part& part) const;  // of a thing or direction; symbols() when there is none

  std::vector<bool> allowed(const TypedState& state) const;  // by symbol
  // The only symbol that may follow, when the grammar leaves just one.
  std::optional<Symbol> forced(const TypedState& state) const;
  TypedState after(const TypedState& state, Symbol symbol) const;  // of an allowed symbol

  // Places that a sentence does not name; named[n]: it names the number n. By symbol.
  std::vector<bool> forbidden(const std::vector<bool>& named) const;

  std::vector<Symbol> symbols_of(const Program& program) const;  // throws as PostfixGrammar::tokens_of
  Program program_of(std::span<const Symbol> symbols) const;     // of a complete sequence
  const PostfixGrammar& grammar() const { return grammar_; }     // of the programs

 private:
  Token literal(Symbol thing, Symbol direction) const;  // PostfixGrammar::end when there is none
  bool is_thing(Symbol s) const { return s >= first_thing_ && s < first_direction_; }
  bool is_direction(Symbol s) const { return s >= first_direction_ && s < first_temporal_; }
  Symbol symbol_of(Token token) const;  // of a literal its thing
  Token token_of(Symbol symbol) const;  // of an operator

  PostfixGrammar grammar_;
  std::vector<std::size_t> place_numbers_;  // of propositions
  std::vector<std::string> names_;          // of symbols
  std::vector<Part> shared_;                // things and directions: symbols from first_thing_ on
  Symbol first_thing_ = 0, first_direction_ = 0, first_temporal_ = 0;
  std::vector<std::pair<Symbol, Symbol>> parts_;  // of literals: thing and direction
  std::vector<Token> literals_;                   // by thing and direction
};

}  // namespace waymark::parser
