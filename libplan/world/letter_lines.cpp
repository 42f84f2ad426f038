#include "libplan/world/letter_lines.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libltl/printable_name.hpp"
#include "libltl/text/foreign.hpp"
#include "libltl/text/read_word.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t most_further_names = 4096;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool is_passed_over(std::string_view line) { return line.empty() || line.front() == '#'; }

}  // namespace

LetterLines::LetterLines(Forgetful options, std::string source)
    : LetterLines(std::move(options.options), std::move(source)) {
  forgets_ = true;
}
LetterLines::LetterLines(LetterOptions options, std::string source)
    : vocabulary_(options.wanted),
      names_(vocabulary_),
      options_(std::move(options)),
      forgets_(false),
      source_(std::move(source)),
      conditions_(vocabulary_) {}

bool LetterLines::separates(std::string_view line) {
  line = trimmed(line);
  return line.size() >= 2 && line.find_first_not_of('-') == std::string_view::npos;
}

void LetterLines::begin_trace() {
  ++line_;
  begins_trace_ = true;
  if (table_) table_->begin_trace();
}

void LetterLines::split_at(char delimiter) {
  options_.format = LetterFormat::Csv;
  delimiter_ = delimiter;
}

NoTruths LetterLines::no_truths() const { return table_ ? table_->no_truths() : no_truths_; }

std::optional<std::string> LetterLines::uncompared() const {
  return table_ ? std::nullopt : conditions_.on_none_of(keys_);
}

std::vector<ltl::Letter> LetterLines::read(std::string_view whole) {
  ++line_;
  const std::string_view line = trimmed(whole);
  if (is_passed_over(line)) return {};
  if (separates(line))
    throw ltl::FormatError(source_, line_, 1, "a line of dashes separates traces, and one is read here");
  if (options_.format == LetterFormat::Auto && line == "{}") return {ltl::Letter()};  // in text as in JSON
  if (options_.format == LetterFormat::Auto) options_.format = format_of(line);
  if (forgets_ && !table_ && names_.size() > vocabulary_.size() + most_further_names) names_ = vocabulary_;
  if (options_.format == LetterFormat::Text) return text_letters(line);
  if (options_.format == LetterFormat::Json) return {json_letter(line)};
  return table_letters(whole);
}

LetterFormat LetterLines::format_of(std::string_view first) const {
  if (const std::string hint = ltl::foreign_hint(first); !hint.empty())
    throw ltl::FormatError(source_, line_, 1, "expected letters: " + hint);
  if ((first.front() == '[' || first.front() == '{') && nlohmann::json::accept(first)) return LetterFormat::Json;
  const bool row = first.find(',') != std::string_view::npos && first.find_first_of("{}();") == std::string_view::npos;
  return row ? LetterFormat::Csv : LetterFormat::Text;
}

std::vector<ltl::Letter> LetterLines::text_letters(std::string_view line) {
  try {
    ltl::AnyWord word = ltl::read_word(line, names_);
    if (const auto* trace = std::get_if<ltl::Trace>(&word)) return {trace->begin(), trace->end()};
  } catch (const ltl::SyntaxError& error) {
    throw error.in(source_, line_);
  }
  throw ltl::FormatError(source_, line_, 1, "expected letters, not the cycle of a lasso");
}

void LetterLines::check_name(const std::string& name) const {
  if (name.empty()) throw ltl::FormatError(source_, line_, 1, "the name of a proposition is empty");
  if (!ltl::is_printable_name(name))
    throw ltl::FormatError(source_, line_, 1, "the name of a proposition has a control character: " + name);
}

ltl::Letter LetterLines::json_letter(std::string_view line) {
  const JsonReader reader(line, source_, line_);
  const JsonReader::Value value = reader.parse();
  ltl::Letter letter;
  if (value.is_array()) {
    for (const std::string& name : reader.strings(value, "letter")) {
      check_name(name);
      letter.insert(names_.add(name));
    }
    return letter;
  }
  if (!value.is_object())
    throw ltl::FormatError(source_, line_, 1, "expected a list of names, or an object of names and truth values");
  for (const auto& [name, member] : value.items()) {
    check_name(name);
    const bool is_text = member.is_string(), is_truth = member.is_boolean() || member == 0 || member == 1;
    const bool wanted = vocabulary_.find(name).has_value();
    if (!is_truth && ((!is_text && !member.is_number()) || wanted)) reader.fail(name, "expected true, false, 1 or 0");
    const std::string shown = is_text ? member.get<std::string>() : member.dump();
    if (member.is_boolean() ? member.get<bool>() : member == 1) letter.insert(names_.add(name));
    if (!is_truth) no_truths_.try_emplace(name, NoTruth{shown, line_});
    if (conditions_.compares(name) && std::find(keys_.begin(), keys_.end(), name) == keys_.end()) keys_.push_back(name);
    if (member.is_boolean()) continue;
    if (const auto condition = conditions_.insert(name, shown, letter))
      reader.fail(name, "cannot be compared: \"" + *condition + '"');
  }
  return letter;
}

void LetterLines::begin_table(std::string_view heading) {
  const char delimiter = delimiter_ ? *delimiter_ : delimiter_of(heading, source_, line_).value_or(',');
  table_.emplace(heading, delimiter, names_, vocabulary_, source_, line_);
  if (options_.time_unit) table_->count_time_in(*options_.time_unit, line_);
}

std::vector<ltl::Letter> LetterLines::table_letters(std::string_view line) {
  const bool repeats = std::exchange(begins_trace_, false) && table_ && table_->is_heading(line);
  if (repeats) return {};
  if (table_) return table_->row(line, line_);
  begin_table(line);
  return {};
}

}  // namespace waymark::plan
