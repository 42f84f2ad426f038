// Tokens of the PRISM language [KNP11], and a place among them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {

struct PrismToken {                                                      // a token with its place
  enum class Kind : std::uint8_t { Name, Number, String, Symbol, End };  // what a token is
  Kind kind = Kind::End;                                                 // of the token
  std::string_view text;                                                 // of a string: what stands between the quotes
  ltl::Span where;                                                       // its bytes
};

// The tokens of a text, comments left out, the end last. Throws ltl::SyntaxError.
std::vector<PrismToken> prism_tokens(std::string_view text, std::string_view source);

class ModelText {  // what a model was read from: what its errors are about
 public:
  ModelText() = default;
  ModelText(const ModelText&) = default;
  ModelText& operator=(const ModelText&) = default;
  virtual ~ModelText() = default;
  virtual ltl::Span end() const = 0;  // where errors about what is missing are
  // Throws the error of its kind. What a span counts is the text's own affair.
  [[noreturn]] void fail(ltl::Span where, const std::string& message) const {
    std::rethrow_exception(error(where, message));
  }

 private:
  virtual std::exception_ptr error(ltl::Span where, const std::string& message) const = 0;
};

class PrismTokens final : public ModelText {  // a place in a text that is being read
 public:
  PrismTokens(std::string_view text, std::string_view source)
      : text_(text), source_(source), tokens_(prism_tokens(text, source)) {}

  // The last token is End, again and again.
  const PrismToken& peek(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  const PrismToken& next() { return tokens_[at_ + 1 < tokens_.size() ? at_++ : at_]; }  // reads it
  bool is(std::string_view word, std::size_t ahead = 0) const;  // a symbol or a word of the language
  bool accept(std::string_view word);                           // reads the word if it stands here
  const PrismToken& expect(std::string_view word);              // reads the word, or throws
  const PrismToken& expect_name(std::string_view what);         // reads a name, or throws
  using ModelText::fail;                                        // throws SyntaxError
  ltl::Span end() const override { return peek().where; }       // the next token
  // Throws SyntaxError at the next token.
  [[noreturn]] void fail(const std::string& message) const { fail(peek().where, message); }

 private:
  std::exception_ptr error(ltl::Span where, const std::string& message) const override;

  std::string_view text_, source_;
  std::vector<PrismToken> tokens_;
  std::size_t at_ = 0;
};

}  // namespace waymark::plan
