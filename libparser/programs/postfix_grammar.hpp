// Typed postfix: programs as token sequences, every prefix of which is well typed.
//
//   literal : Bool      & : Bool Bool → Bool      reach, next, advance, face : Bool → Step
//   forward_k, stay, orient : Step                then : Step Step → Step        end: exactly one Step is left
//   past, advance_2, advance_3 : Bool → Step          in the temporal dialect alone, as what follows
//   without, keep, when : Bool → (Step → Step)        whether : Bool → (Step → Step → Step)
//   apply : (Step → τ) Step → τ
// e.g. "turn left, go to the chair"  =  turned_left next  chair reach  then  end, and "go to the chair without passing
// the sofa"  =  sofa without  chair reach  apply  end. SAIL is read in the plain dialect, whose choices are fewer.
// One program has one token sequence: literals of a goal ascend, &, `then` and `apply` follow their operand at once,
// `orient` stands only before another step; events of turning are goals of `next` and `face` alone, so that a sentence
// of two actions is grounded in two steps. Decoding asks `allowed` and can produce nothing else. The λ terms of
// the source are not needed for a propositional task language. Source: typed postfix decoding as in the paper.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libparser/programs/program.hpp"

namespace waymark::parser {

using Token = std::uint16_t;  // a number of the grammar

enum class Dialect : std::uint8_t { Plain, Temporal };  // which operators there are

// A prefix, as far as the grammar can tell: its stack and what canonical order still allows.
struct PrefixState {
  std::uint8_t steps = 0;          // Steps made so far and `when` and `whether`, `orient` not counted
  std::uint8_t step_entries = 0;   // on the stack
  std::uint8_t bools = 0;          // on the stack
  std::uint8_t goals = 0;          // literals of the open goal
  std::uint16_t last_literal = 0;  // of the open goal
  std::uint8_t awaits = 0;         // steps that the function on the stack still takes
  bool operand = false;            // one of them stands on it
  bool turns = false;              // the open goal names an event of turning
  bool oriented = false;           // the last step is `orient`
  bool stayed = false;             // the first step is `stay`
  bool ended = false;              // the program is complete
  friend bool operator==(const PrefixState&, const PrefixState&) = default;
};

// Tokens that may follow a prefix, as up to three ranges of token numbers; empty ranges at the end.
struct TokenRanges {
  struct Range {               // tokens of one kind
    Token begin = 0, end = 0;  // tokens [begin, end)
  };
  std::array<Range, 3> ranges{};  // some may be empty
  // Visits every token.
  template <class Visit>
  void each(Visit&& visit) const {
    for (const Range& r : ranges)
      for (Token t = r.begin; t < r.end; ++t) visit(t);
  }
};

class PostfixGrammar {
 public:
  // The tokens that every grammar has.
  static constexpr Token end = 0, then = 1, both = 2, stay = 3, orient = 4, reach = 5, advance = 6, next = 7, face = 8;
  static constexpr Token first_forward = 9;                            // forward_1
  static constexpr int max_forward = 8;                                // moves of one token
  static constexpr Token first_literal = first_forward + max_forward;  // literals follow the other tokens

  static constexpr int max_advance = 3;  // advance_k

  struct Limits {                      // of programs
    int steps = 3;                     // besides `orient`
    int goals = 2;                     // literals of one goal, ≤ Step::max_goals
    Dialect dialect = Dialect::Plain;  // of programs
  };
  // That models are trained with.
  static constexpr Limits limits_of(Dialect dialect) { return {dialect == Dialect::Plain ? 3 : 12, 2, dialect}; }

  explicit PostfixGrammar(const ltl::Vocabulary& vocabulary, Dialect dialect = Dialect::Plain);
  PostfixGrammar(const ltl::Vocabulary& vocabulary, Limits limits);
  const Limits& limits() const { return limits_; }  // of programs

  std::size_t tokens() const { return names_.size(); }  // how many
  // Is the token a literal?
  bool is_literal(Token token) const { return token >= first_literal && token < end_of_literals_; }
  Token end_of_literals() const { return end_of_literals_; }            // operators of the temporal dialect follow
  const std::string& name(Token token) const { return names_[token]; }  // as shown by explanations
  // The token of the proposition.
  static Token literal(std::uint16_t proposition) { return static_cast<Token>(first_literal + proposition); }

  bool allowed(const PrefixState& state, Token token) const;  // may the token stand here?
  // The same for all tokens of a choice: a superset that differs only in literals that are not usable.
  TokenRanges choices(const PrefixState& state) const;
  PrefixState after(const PrefixState& state, Token token) const;  // of an allowed token
  // The only token that may follow, when there is just one.
  std::optional<Token> forced(const PrefixState& state) const;
  // Of a step whose literals stand before it. The last token there is, plus one, when this dialect has none.
  Token token_of(const Step& step) const;

  bool contains(const Program& program) const;                 // can the grammar write the program?
  std::vector<Token> tokens_of(const Program& program) const;  // ends in `end`; throws std::invalid_argument
                                                               // when the program is not in the language
  Program program_of(std::span<const Token> tokens) const;     // of a complete sequence
  std::string show(const Program& program) const;              // "turned_left next chair reach then"
  bool usable(std::uint16_t proposition) const { return usable_[proposition]; }  // in a goal
  bool is_turn(std::uint16_t proposition) const { return turns_[proposition]; }  // an event of turning
  // May this literal stand under this operator?
  bool usable(std::uint16_t proposition, StepKind kind) const {
    return usable(proposition) && (!is_turn(proposition) || kind == StepKind::Next || kind == StepKind::Face);
  }

 private:
  // Operators of the temporal dialect, from end_of_literals_ on.
  enum Temporal : std::uint8_t { past, advance_2, advance_3, without, keep, when, whether, apply, temporal_operators };
  Token token(Temporal which) const { return static_cast<Token>(end_of_literals_ + which); }
  std::optional<Step> operator_of(Token token) const;  // without its goals; of operators that take literals
  bool takes(const PrefixState& state, const Step& by) const;
  std::vector<Token> spelled(const Program& program) const;

  Limits limits_;
  Token end_of_literals_;
  std::vector<std::string> names_;
  std::vector<bool> usable_;  // literals a goal may name: all but `moved`, which the macros own
  std::vector<bool> turns_;
};

}  // namespace waymark::parser
