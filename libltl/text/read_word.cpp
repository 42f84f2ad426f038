#include "libltl/text/read_word.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/printable_name.hpp"
#include "libltl/text/character.hpp"
#include "libltl/text/dialect.hpp"

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
      if (!prefix.empty() && peek() == '\0') break;  // the last ';' ends a letter, and begins none
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
    if (peek() == ')') fail("expected a letter; the empty letter is {}");
    do {
      if (!letters.empty() && peek() == ')') break;
      letters.push_back(letter());
    } while (take(';'));
    if (!take(')')) fail("expected ';' or ')'");
    for (const std::string_view power : {"ʷ", "^w", "^ω", "w", "ω"})
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
    std::string name(text_.substr(begin, at_ - begin));
    const auto refuse = [&](const std::string& message) { throw SyntaxError(text_, {begin, at_}, message); };
    if (name == "cycle" && peek() == '{') refuse("expected a lasso as {a}; ({b})w: cycle{b} is not read");
    if (is_name(name)) return name;
    if (std::all_of(name.begin(), name.end(), is_digit))
      refuse("a bare number is no name (of a table, the first line has the names: --letter-format csv)");
    if (name[0] == '!' || name[0] == '~') refuse("a letter lists what holds; what does not hold is left out");
    refuse("'" + name + "' is no name (names with such characters go in double quotes)");
    return name;
  }

  // An identifier that is no constant.
  static bool is_name(std::string_view name) {
    return is_letter(name[0]) &&
           std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); }) &&
           !constant_word(name, Notation::Infix, Dialect::Psl);
  }

  std::string quoted() {
    std::string name;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      const bool escaped = text_[at_] == '\\' && at_ + 1 < text_.size();
      if (escaped) ++at_;
      name += escaped && text_[at_] == 'n' ? '\n' : text_[at_];
    }
    if (at_ == text_.size()) fail("expected '\"' at the end of the name");
    ++at_;
    if (name.empty()) fail("a name is never empty");
    if (!is_printable_name(name)) fail("a name has no control characters, and is UTF-8");
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
