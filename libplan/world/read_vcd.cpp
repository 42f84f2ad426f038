#include "libplan/world/read_vcd.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"

namespace waymark::plan {
namespace {

struct Variable {
  std::string name, scope;
  std::string value = "?";
};

class VcdReader {
 public:
  VcdReader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  std::string table() {
    while (const auto word = next()) {
      if (word->front() == '$')
        keyword(*word);
      else
        change(*word);
    }
    end_row();
    if (rows_.empty()) fail("there is no time (#0) with values");
    return header() + rows_;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw ltl::FormatError(source_, line_, 0, message); }

  std::optional<std::string_view> next() {
    for (; at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos; ++at_)
      if (text_[at_] == '\n') ++line_;
    if (at_ == text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }

  std::string expected(std::string_view what) {
    const auto word = next();
    if (!word) fail("expected " + std::string(what) + ", not the end of the file");
    return std::string(*word);
  }

  void keyword(std::string_view word) {
    if (word == "$dumpvars" || word == "$dumpall" || word == "$dumpon" || word == "$dumpoff" || word == "$end") return;
    std::vector<std::string> words;
    for (std::string inside = expected("$end"); inside != "$end"; inside = expected("$end")) words.push_back(inside);
    if (word == "$scope" && words.size() > 1) scopes_.push_back(words[1]);
    if (word == "$upscope" && !scopes_.empty()) scopes_.pop_back();
    if (word != "$var") return;
    if (words.size() < 4) fail("expected $var with a type, a size, an identifier and a name");
    std::string scope;
    for (const std::string& outer : scopes_) scope += outer + '.';
    by_code_[words[2]].push_back(variables_.size());  // several names may share one
    variables_.push_back({words[3], scope});
  }

  // #5, 1!, b101 !, r2.5 !
  void change(std::string_view word) {
    const char kind = word.front();
    if (kind == '#') {
      end_row();
      time_ = std::string(word.substr(1));
      return;
    }
    if (kind == 'b' || kind == 'B' || kind == 'r' || kind == 'R' || kind == 's') {
      const std::string value = kind == 'b' || kind == 'B' ? number(word.substr(1)) : std::string(word.substr(1));
      return set(expected("the identifier of a variable"), value);
    }
    if (std::string_view("01xXzZ").find(kind) == std::string_view::npos) fail("expected a change of a value");
    set(std::string(word.substr(1)), kind == '0' || kind == '1' ? std::string(1, kind) : "?");
  }

  // Of binary digits; 52 of them fit a double.
  std::string number(std::string_view digits) const {
    double value = 0;
    for (const char c : digits) {
      if (c != '0' && c != '1') return "?";
      value = 2 * value + (c == '1' ? 1 : 0);
    }
    constexpr double most = 9007199254740992;
    return value > most ? "?" : std::to_string(static_cast<unsigned long long>(value));
  }

  void set(const std::string& code, const std::string& value) {
    const auto found = by_code_.find(code);
    if (found == by_code_.end()) fail("no $var has the identifier '" + code + "'");
    for (const std::size_t i : found->second) variables_[i].value = value;
  }

  void end_row() {
    if (!time_) return;
    rows_ += *time_;
    for (const Variable& variable : variables_) rows_ += '\t' + variable.value;
    rows_ += '\n';
    time_.reset();
  }

  std::string header() const {
    const auto count = [&](const std::string& name) {
      return std::count_if(variables_.begin(), variables_.end(), [&](const auto& v) { return v.name == name; });
    };
    std::string out = "time";
    for (const Variable& variable : variables_) {
      const bool shared = count(variable.name) > 1 || variable.name == "time";
      out += "\t\"" + (shared ? variable.scope : "") + variable.name + '"';
    }
    return out + '\n';
  }

  std::string_view text_, source_;
  std::size_t at_ = 0, line_ = 1;
  std::vector<std::string> scopes_;
  std::vector<Variable> variables_;
  std::map<std::string, std::vector<std::size_t>> by_code_;
  std::optional<std::string> time_;
  std::string rows_;
};

}  // namespace

bool is_vcd(std::string_view text) {
  const auto found = ltl::foreign_format(text);
  return found && found->name == "a VCD file";
}

std::string table_of_vcd(std::string_view text, std::string_view source) { return VcdReader(text, source).table(); }

}  // namespace waymark::plan
