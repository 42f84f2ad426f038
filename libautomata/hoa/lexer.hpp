// The tokens of the HOA format. [BBD+15, Sec. 3]
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::automata {

struct HoaToken {
  // What a token is.
  enum class Kind : std::uint8_t { Header, Identifier, Alias, String, Integer, Punctuation, Body, End, Abort, Eof };
  Kind kind = Kind::Eof;               // of the token
  std::string_view text;               // as written; of a header without the colon
  std::uint64_t value = 0;             // of an Integer
  std::uint32_t line = 0, column = 0;  // where it begins, from 1
};

// The tokens of one automaton after the other. Throws ltl::FormatError. Comments may be nested.
class HoaLexer {
 public:
  HoaLexer(std::string_view text, std::string_view source) : text_(text), source_(source) {}
  // Up to --END--, --ABORT-- or the end of the text, whose token is the last one. After the end: Eof alone.
  std::vector<HoaToken> automaton();

 private:
  bool more() const { return at_ < text_.size(); }
  bool looking_at(std::string_view what) const { return text_.substr(at_).starts_with(what); }
  [[noreturn]] void fail(std::string_view message) const;
  void advance(std::size_t bytes);
  void blanks();
  void comment();
  HoaToken token();
  void string();
  std::uint64_t integer();
  HoaToken::Kind marker();

  std::string_view text_, source_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1, column_ = 1;
};

std::string unquoted(std::string_view quoted);  // of a String: quotes and escapes removed
std::string described(const HoaToken& token);   // for messages: "'['", "the end of the file", …

}  // namespace waymark::automata
