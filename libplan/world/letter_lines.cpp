#include "libplan/world/letter_lines.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "libltl/diagnostic.hpp"
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

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> out;
  while (true) {
    const auto comma = line.find(',');
    std::string_view cell = trimmed(line.substr(0, comma));
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    out.emplace_back(cell);
    if (comma == std::string_view::npos) return out;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

LetterLines::LetterLines(ltl::Vocabulary vocabulary, LetterFormat format, std::string source)
    : vocabulary_(std::move(vocabulary)), names_(vocabulary_), format_(format), source_(std::move(source)) {}
LetterLines::LetterLines(LetterFormat format, std::string source) : LetterLines({}, format, std::move(source)) {
  forgets_ = false;
}

std::vector<ltl::Letter> LetterLines::read(std::string_view line) {
  ++line_;
  line = trimmed(line);
  if (line.empty() || line.front() == '#') return {};
  if (format_ == LetterFormat::Auto && line == "{}") return {ltl::Letter()};  // in text as in JSON
  if (format_ == LetterFormat::Auto) format_ = format_of(line);
  if (forgets_ && header_.empty() && names_.size() > vocabulary_.size() + most_further_names) names_ = vocabulary_;
  if (format_ == LetterFormat::Text) return text_letters(line);
  if (format_ == LetterFormat::Json) return {json_letter(line)};
  if (!header_.empty()) return {csv_letter(line)};
  read_header(line);
  return {};
}

LetterFormat LetterLines::format_of(std::string_view first) const {
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

ltl::Letter LetterLines::json_letter(std::string_view line) {
  const JsonReader reader(line, source_, line_);
  const JsonReader::Value value = reader.parse();
  ltl::Letter letter;
  const auto insert = [&](const std::string& name) {
    if (name.empty()) throw ltl::FormatError(source_, line_, 1, "the name of a proposition is empty");
    letter.insert(names_.add(name));
  };
  if (value.is_array()) {
    for (const std::string& name : reader.strings(value, "letter")) insert(name);
    return letter;
  }
  if (!value.is_object())
    throw ltl::FormatError(source_, line_, 1, "expected a list of names, or an object of names and truth values");
  for (const auto& [name, holds] : value.items()) {
    const bool is_number = holds.is_number_integer() && (holds == 0 || holds == 1);
    if (!holds.is_boolean() && !is_number) reader.fail(name, "expected true, false, 1 or 0");
    if (holds.is_boolean() ? holds.get<bool>() : holds == 1) insert(name);
  }
  return letter;
}

void LetterLines::read_header(std::string_view line) {
  for (const std::string& name : cells_of(line)) {
    if (name.empty()) throw ltl::FormatError(source_, line_, 1, "the header of the table has a column without a name");
    header_.push_back(names_.add(name));
  }
}

ltl::Letter LetterLines::csv_letter(std::string_view line) const {
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != header_.size())
    throw ltl::FormatError(
        source_, line_, 1,
        "the row has " + std::to_string(cells.size()) + " cells, the header " + std::to_string(header_.size()));
  ltl::Letter letter;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] == "1" || cells[i] == "true" || cells[i] == "True" || cells[i] == "TRUE")
      letter.insert(header_[i]);
    else if (!(cells[i].empty() || cells[i] == "0" || cells[i] == "false" || cells[i] == "False" ||
               cells[i] == "FALSE"))
      throw ltl::FormatError(source_, line_, 1, "expected 1, 0, true, false or nothing, not '" + cells[i] + "'");
  }
  return letter;
}

NamedTrace read_letters(std::string_view text, LetterFormat format, const std::string& source) {
  LetterLines lines(format, source);
  std::vector<ltl::Letter> letters;
  while (!text.empty()) {
    const auto end = text.find('\n');
    for (ltl::Letter& letter : lines.read(text.substr(0, end))) letters.push_back(std::move(letter));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  if (letters.empty()) throw ltl::FormatError(source, 0, 0, "there are no letters; the empty letter is {}");
  return {ltl::Trace(std::move(letters)), lines.vocabulary(), lines.is_table()};
}

}  // namespace waymark::plan
