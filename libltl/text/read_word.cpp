#include "libltl/text/read_word.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/diagnostic.hpp"

namespace waymark::ltl {
namespace {

class WordReader {
 public:
  WordReader(std::string_view text, Vocabulary& vocabulary) : text_(text), vocabulary_(vocabulary) {}

  AnyWord word() {
    std::vector<Letter> prefix;
    std::optional<std::vector<Letter>> cycle;
    do {
      if (take('(')) {
        cycle = cycle_behind_parenthesis();
        break;
      }
      prefix.push_back(letter());
    } while (take(';'));
    expect_end();
    if (cycle) return Lasso(std::move(prefix), std::move(*cycle));
    return Trace(std::move(prefix));
  }

  Letter only_letter() {
    Letter read = letter();
    expect_end();
    return read;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  static bool ends_name(char c) {
    return is_blank(c) || std::string_view("{}();,\"").find(c) != std::string_view::npos;
  }

  char peek() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(std::string_view message) {
    peek();
    throw SyntaxError(text_, {at_, at_ < text_.size() ? at_ + 1 : at_}, message);
  }
  void expect_end() {
    if (peek() != '\0' || at_ < text_.size()) fail("expected ';' or the end of the word");
  }

  std::vector<Letter> cycle_behind_parenthesis() {
    std::vector<Letter> letters;
    do letters.push_back(letter());
    while (take(';'));
    if (!take(')')) fail("expected ';' or ')'");
    for (const std::string_view power : {"ʷ", "^w", "w"})
      if (text_.substr(at_, power.size()) == power) {
        at_ += power.size();
        return letters;
      }
    fail("expected 'ʷ', '^w' or 'w' behind the cycle of a lasso");
  }

  Letter letter() {
    Letter read;
    const bool braces = take('{');
    while (true) {
      const char c = peek();
      if (braces && take('}')) return read;
      if (braces && (c == '\0' || c == ';')) fail("expected a name or '}'");
      if (!braces && (c == '\0' || c == ';' || c == ')')) return read;
      read.insert(vocabulary_.add(name()));
      take(',');
    }
  }

  std::string name() {
    if (take('"')) return quoted();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !ends_name(text_[at_])) ++at_;
    if (begin == at_) fail("expected the name of a proposition");
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string quoted() {
    std::string name;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      name += text_[at_];
    }
    if (at_ == text_.size()) fail("expected '\"' at the end of the name");
    ++at_;
    if (name.empty()) fail("a name is never empty");
    return name;
  }

  std::string_view text_;
  Vocabulary& vocabulary_;
  std::size_t at_ = 0;
};

}  // namespace

AnyWord read_word(std::string_view text, Vocabulary& vocabulary) { return WordReader(text, vocabulary).word(); }

Letter read_letter(std::string_view text, Vocabulary& vocabulary) { return WordReader(text, vocabulary).only_letter(); }

}  // namespace waymark::ltl
