// A position among the tokens of one HOA automaton, and the error messages about that position.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libautomata/hoa/lexer.hpp"
#include "libltl/diagnostic.hpp"

namespace waymark::automata {

class HoaCursor {
 public:
  using Kind = HoaToken::Kind;
  HoaCursor(std::vector<HoaToken> tokens, std::string_view source) : source_(source), tokens_(std::move(tokens)) {}

  const HoaToken& peek() const { return tokens_[at_]; }                                // the token at the cursor
  const HoaToken& take() { return tokens_[at_ + 1 == tokens_.size() ? at_ : at_++]; }  // the last one stays
  // Is it this character?
  bool punctuation(char c) const { return peek().kind == Kind::Punctuation && peek().text[0] == c; }
  bool accept(char c) {  // takes the character if it stands here
    if (!punctuation(c)) return false;
    take();
    return true;
  }
  std::size_t position() const { return at_; }               // for go_back_to
  void go_back_to(std::size_t position) { at_ = position; }  // of an earlier token

  [[noreturn]] void fail(const HoaToken& at, std::string_view message) const {  // throws FormatError at the token
    throw ltl::FormatError(source_, at.line, at.column, message);
  }
  [[noreturn]] void expected(std::string_view what) const {  // throws FormatError at the cursor
    fail(peek(), "expected " + std::string(what) + ", not " + described(peek()));
  }
  void demand(char c) {  // takes the character, or throws
    if (!accept(c)) expected(std::string("'") + c + "'");
  }
  const HoaToken& demand(Kind kind, std::string_view what) {  // takes a token of the kind, or throws
    if (peek().kind != kind) expected(what);
    return take();
  }

 private:
  std::string_view source_;
  std::vector<HoaToken> tokens_;
  std::size_t at_ = 0;
};

}  // namespace waymark::automata
