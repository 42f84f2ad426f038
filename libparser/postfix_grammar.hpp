// Typed postfix: programs as token sequences, every prefix of which is well typed.
//
//   literal : Bool      & : Bool Bool → Bool      reach, next, advance, face : Bool → Step
//   forward_k, stay, orient : Step                then : Step Step → Step        end: exactly one Step is left
// e.g. "turn left, go to the chair"  =  turned_left next  chair reach  then  end.
// One program has one token sequence: literals of a goal ascend, & and `then` follow their second operand at once,
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
#include "libparser/program.hpp"

namespace waymark::parser {

using Token = std::uint16_t;

// A prefix, as far as the grammar can tell: its stack and what canonical order still allows.
struct PrefixState {
  std::uint8_t steps = 0;          // Step-typed entries made so far, `orient` not counted
  std::uint8_t step_entries = 0;   // on the stack
  std::uint8_t bools = 0;          // on the stack
  std::uint8_t goals = 0;          // literals of the open goal
  std::uint16_t last_literal = 0;  // of the open goal
  bool turns = false;              // the open goal names an event of turning
  bool oriented = false;           // the last step is `orient`
  bool stayed = false;             // the first step is `stay`
  bool ended = false;
  friend bool operator==(const PrefixState&, const PrefixState&) = default;
};

// Tokens that may follow a prefix, as up to three ranges of token numbers; empty ranges at the end.
struct TokenRanges {
  struct Range {
    Token begin = 0, end = 0;
  };
  std::array<Range, 3> ranges{};
  template <class Visit>
  void each(Visit&& visit) const {
    for (const Range& r : ranges)
      for (Token t = r.begin; t < r.end; ++t) visit(t);
  }
};

class PostfixGrammar {
 public:
  static constexpr Token end = 0, then = 1, both = 2, stay = 3, orient = 4, reach = 5, advance = 6, next = 7,
                         face = 8;
  static constexpr Token first_forward = 9;  // forward_1
  static constexpr int max_forward = 8;
  static constexpr Token first_literal = first_forward + max_forward;

  struct Limits {
    int steps = 3;  // besides `orient`
    int goals = 2;  // literals of one goal, ≤ Step::max_goals
  };

  explicit PostfixGrammar(const ltl::Vocabulary& vocabulary);
  PostfixGrammar(const ltl::Vocabulary& vocabulary, Limits limits);

  std::size_t tokens() const { return names_.size(); }
  const std::string& name(Token token) const { return names_[token]; }
  static Token literal(std::uint16_t proposition) { return static_cast<Token>(first_literal + proposition); }

  bool allowed(const PrefixState& state, Token token) const;
  // The same for all tokens of a choice: a superset that differs only in literals that are not usable.
  TokenRanges choices(const PrefixState& state) const;
  PrefixState after(const PrefixState& state, Token token) const;  // of an allowed token
  // The only token that may follow, when there is just one.
  std::optional<Token> forced(const PrefixState& state) const;

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
  Limits limits_;
  std::vector<std::string> names_;
  std::vector<bool> usable_;  // literals a goal may name: all but `moved`, which the macros own
  std::vector<bool> turns_;
};

}  // namespace waymark::parser
