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

  const HoaToken& peek() const { return tokens_[at_]; }
  const HoaToken& take() { return tokens_[at_ + 1 == tokens_.size() ? at_ : at_++]; }  // the last one stays
  bool punctuation(char c) const { return peek().kind == Kind::Punctuation && peek().text[0] == c; }
  bool accept(char c) {
    if (!punctuation(c)) return false;
    take();
    return true;
  }
  std::size_t position() const { return at_; }
  void go_back_to(std::size_t position) { at_ = position; }

  [[noreturn]] void fail(const HoaToken& at, std::string_view message) const {
    throw ltl::FormatError(source_, at.line, at.column, message);
  }
  [[noreturn]] void expected(std::string_view what) const {
    fail(peek(), "expected " + std::string(what) + ", not " + described(peek()));
  }
  void demand(char c) {
    if (!accept(c)) expected(std::string("'") + c + "'");
  }
  const HoaToken& demand(Kind kind, std::string_view what) {
    if (peek().kind != kind) expected(what);
    return take();
  }

 private:
  std::string_view source_;
  std::vector<HoaToken> tokens_;
  std::size_t at_ = 0;
};

}  // namespace waymark::automata
