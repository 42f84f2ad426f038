#include "libplan/world/letter_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/printable_name.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t most_instants = 10'000'000;  // between two rows

std::string_view cut(std::string_view text) {
  const auto first = text.find_first_not_of(" \r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \r") - first + 1);
}

bool is_time(std::string_view name) {
  return name == "time" || name == "Time" || name == "TIME" || name == "timestamp" || name == "Timestamp";
}

// Tabs, semicolons and commas outside of quotes, each once.
std::string delimiters_in(std::string_view heading) {
  std::string found;
  bool quoted = false;
  for (const char c : heading) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '\t' || c == ';' || c == ',') && found.find(c) == std::string::npos) found += c;
  }
  return found;
}

// 0,5 is 0.5 where commas are no delimiters.
std::string with_decimal_point(const std::string& cell, char delimiter) {
  if (delimiter == ',' || number_of(cell)) return cell;
  std::string number = cell;
  std::replace(number.begin(), number.end(), ',', '.');
  return number_of(number) ? number : cell;
}

// A cell that begins at the offset with a quote: its text; the offset behind it.
std::string quoted_cell(std::string_view line, std::size_t& at) {
  std::string out;
  for (++at; at < line.size(); ++at) {
    if (line[at] == '"' && (at + 1 == line.size() || line[at + 1] != '"')) break;
    if (line[at] == '"') ++at;
    out += line[at];
  }
  at = std::min(at + 1, line.size());
  return out;
}

}  // namespace

Conditions::Conditions(const ltl::Vocabulary& vocabulary) : names_(vocabulary.names()) {
  for (std::uint32_t p = 0; p < names_.size(); ++p)
    if (auto condition = condition_of(names_[p])) {
      auto& of_column = by_column_[condition->column];
      of_column.emplace_back(std::move(*condition), ltl::Proposition{p});
    }
}

std::optional<std::string> Conditions::insert(const std::string& column, std::string_view value,
                                              ltl::Letter& letter) const {
  const auto found = by_column_.find(column);
  if (found == by_column_.end()) return std::nullopt;
  for (const auto& [condition, proposition] : found->second) {
    const auto holding = holds(condition, value);
    if (!holding) return names_[proposition.index];
    if (*holding) letter.insert(proposition);
  }
  return std::nullopt;
}

std::optional<std::string> Conditions::on_none_of(const std::vector<std::string>& columns) const {
  for (const auto& [column, conditions] : by_column_)
    if (std::find(columns.begin(), columns.end(), column) == columns.end())
      return names_[conditions.front().second.index];
  return std::nullopt;
}

std::vector<std::string> cells_of(std::string_view line, char delimiter) {
  std::vector<std::string> out;
  line = cut(line);
  for (std::size_t at = 0;; ++at) {
    while (at < line.size() && line[at] == ' ') ++at;
    if (at < line.size() && line[at] == '"') {
      out.push_back(quoted_cell(line, at));
      at = std::min(line.find(delimiter, at), line.size());
    } else {
      const std::size_t end = std::min(line.find(delimiter, at), line.size());
      out.emplace_back(cut(line.substr(at, end - at)));
      at = end;
    }
    if (at >= line.size()) return out;
  }
}

std::optional<char> delimiter_of(std::string_view heading, std::string_view source, std::size_t line) {
  const std::string found = delimiters_in(heading);
  if (found.empty()) return std::nullopt;
  if (found.size() > 1)
    throw ltl::FormatError(source, line, 1,
                           "the first line of the table has two delimiters; a name that contains one stands in "
                           "double quotes");
  return found[0];
}

std::optional<char> table_delimiter(std::string_view first, std::string_view second) {
  if (first.find_first_of("{}()[]") != std::string_view::npos) return std::nullopt;
  const std::string used = delimiters_in(first);
  for (const char delimiter : {'\t', ';', ',', ' '}) {
    if (used != (delimiter == ' ' ? std::string() : std::string(1, delimiter))) continue;
    const std::vector<std::string> names = cells_of(first, delimiter), cells = cells_of(second, delimiter);
    if (names.size() != cells.size() || (names.size() == 1 && delimiter != ' ')) continue;
    const auto is_value = [](const std::string& cell) {
      return number_of(cell).has_value() || (truth_of(cell).has_value() && cell.size() > 3);  // true, False
    };
    const bool heads =
        std::none_of(names.begin(), names.end(), [&](const auto& n) { return n.empty() || is_value(n); });
    if (heads && std::any_of(cells.begin(), cells.end(), is_value)) return delimiter;
  }
  return std::nullopt;
}

LetterTable::LetterTable(std::string_view heading, char delimiter, ltl::Vocabulary& names,
                         const ltl::Vocabulary& wanted, std::string source, std::size_t line)
    : heading_(heading),
      source_(std::move(source)),
      delimiter_(delimiter),
      columns_(cells_of(heading, delimiter)),
      conditions_(wanted) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string& name = columns_[i];
    if (name.empty()) fail(line, "the header of the table has a column without a name");
    if (std::find(columns_.begin(), columns_.begin() + static_cast<std::ptrdiff_t>(i), name) !=
        columns_.begin() + static_cast<std::ptrdiff_t>(i))
      fail(line, "the header of the table has two columns '" + name + "'");
    if (!ltl::is_printable_name(name)) fail(line, "the name of a column has a control character: " + name);
    if (number_of(name)) fail(line, "expected the names of the columns, not '" + name + "'");
    wanted_.push_back(wanted.find(name).has_value());
    compared_.push_back(conditions_.compares(name));
    propositions_.push_back(names.add(name));
    if (is_time(name) && !time_) time_ = i;
  }
  std::vector<std::string> known = columns_;
  for (const std::string& name : wanted.names())  // a column may have the name of a condition
    if (std::find(columns_.begin(), columns_.end(), name) != columns_.end())
      if (const auto condition = condition_of(name)) known.push_back(condition->column);
  if (const auto condition = conditions_.on_none_of(known))
    fail(line, "the table has no column to compare in \"" + *condition + '"');
  for (const std::string& name : wanted.names())
    if (std::find(known.begin(), known.end(), name) == known.end() && !condition_of(name))
      fail(line, "the table has no column '" + name + "'");
}

void LetterTable::fail(std::size_t line, const std::string& message) const {
  throw ltl::FormatError(source_, line, 1, message);
}

void LetterTable::count_time_in(double unit, std::size_t line) {
  if (!time_) fail(line, "the table has no column time, which --time-unit counts");
  unit_ = unit;
}

ltl::Letter LetterTable::letter(const std::vector<std::string>& cells, std::size_t number) {
  ltl::Letter out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto truth = truth_of(cells[i]);
    if (truth.value_or(false)) out.insert(propositions_[i]);
    if (!truth && wanted_[i])
      fail(number, "expected a truth value of " + columns_[i] + ", 1 or 0, true or false, not '" + cells[i] +
                       "' (values are compared in quotes: \"" + columns_[i] + " = " + cells[i] + "\")");
    if (!truth) no_truths_.try_emplace(columns_[i], NoTruth{cells[i], number});
    if (!compared_[i]) continue;
    if (const auto condition = conditions_.insert(columns_[i], with_decimal_point(cells[i], delimiter_), out))
      fail(number, "'" + cells[i] + "' cannot be compared: \"" + *condition + '"');
  }
  return out;
}

std::size_t LetterTable::steps_to(const std::string& cell, std::size_t number) {
  const auto time = number_of(with_decimal_point(cell, delimiter_));
  if (!time) fail(number, "expected a number as time, not '" + cell + "'");
  if (!last_) {
    first_time_ = *time;
    instant_ = 0;
    return 1;
  }
  const double instants = (*time - first_time_) / *unit_, whole = std::round(instants);
  if (std::abs(instants - whole) > 1e-6)
    fail(number, "time " + cell + " is no whole number of time units behind the first row");
  if (whole <= static_cast<double>(instant_)) fail(number, "time " + cell + " is not behind that of the row before");
  if (whole - static_cast<double>(instant_) > static_cast<double>(most_instants))
    fail(number, "time " + cell + " is too many time units behind the row before");
  return static_cast<std::size_t>(whole) - std::exchange(instant_, static_cast<std::size_t>(whole));
}

std::vector<ltl::Letter> LetterTable::row(std::string_view line, std::size_t number) {
  const std::vector<std::string> cells = cells_of(line, delimiter_);
  if (cells.size() != columns_.size())
    fail(number,
         "the row has " + std::to_string(cells.size()) + " cells, the header " + std::to_string(columns_.size()));
  const std::size_t steps = unit_ ? steps_to(cells[*time_], number) : 1;
  std::vector<ltl::Letter> out;
  if (steps > 1) out.assign(steps - 1, *last_);  // a row holds until the next one
  out.push_back(letter(cells, number));
  if (unit_) last_ = out.back();
  return out;
}

}  // namespace waymark::plan
