// Text → tokens of formulas, in any of the three notations.
//
// An operator has several spellings (`&`, `&&`, `/\`, `∧`) and one symbol after the lexer. A word of the letters X N F
// G only is that sequence of unary operators (GF is G F). A single U R W M V is a binary operator. In waymark's dialect
// so are S and T, and a single Y Z O H is a unary one; in Spot's they are names, and GFa is G F a. Every other
// [A-Za-z_][A-Za-z0-9_]* is a proposition, and so is any text in double quotes (with \" \\ and \n inside).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libltl/text/dialect.hpp"
#include "libltl/text/symbol.hpp"

namespace waymark::ltl {

struct Token {                                                                    // one token with its place
  enum class Kind : std::uint8_t { End, Open, Close, Constant, Name, Operator };  // what a token is
  Kind kind = Kind::End;                                                          // of the token
  Span where;                                                                     // its bytes
  Symbol symbol = Symbol::Not;                                                    // of an Operator
  std::optional<std::size_t> bound;  // k of F<=k, G<=k and U<=k; j of F[i:j]; of F[i:] none
  std::size_t from = 0;              // i of F[i:j] and F[i:]; k − 1 of X[k]
  Binding binding = {};              // of an Operator
  bool value = false;                // of a Constant
  bool quoted = false;               // of a Name: it stood in double quotes
  std::string name;                  // of a Name, quotes and escapes removed
};

class Lexer {
 public:
  Lexer(std::string_view text, Dialect dialect, Notation notation)
      : text_(text), dialect_(dialect), notation_(notation) {}
  Token next();  // throws SyntaxError on a character that starts no token; End at the end, again and again
  std::string_view text() const { return text_; }  // all of it

 private:
  Token scan();
  Token word();
  Token psl_word(std::size_t begin);
  std::size_t word_end(std::size_t at) const;
  void compare(Token& name);
  Token quoted();
  Token operation(Symbol symbol, std::size_t begin);
  void bounds(Token& token);
  void repetition(Token& token);
  void pass_over_frame();
  std::size_t steps();
  void skip_space();
  bool take(std::string_view expected);
  std::optional<std::size_t> number();
  [[noreturn]] void fail(Span where, std::string_view message) const;
  [[noreturn]] void fail_on_character() const;

  std::string_view text_;
  Dialect dialect_;
  Notation notation_;
  std::size_t at_ = 0;
  bool behind_operand_ = false;
  std::optional<Token> pending_;  // the ! of never
};

// Would `name` be read back as the proposition of that name without quotes?
bool is_bare_name(std::string_view name, Notation notation);

}  // namespace waymark::ltl
