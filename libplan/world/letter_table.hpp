// A table of letters: its first line has the names of the columns, each further line is one letter.
//
// A column whose cells are truth values is a proposition. Other columns are compared by conditions (condition.hpp):
// names of the vocabulary such as "x >= 3" are propositions of the rows.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"
#include "libplan/world/condition.hpp"

namespace waymark::plan {

struct NoTruth {         // a value that is neither true nor false
  std::string value;     // the first of its column
  std::size_t line = 0;  // where it stands
};
using NoTruths = std::map<std::string, NoTruth>;  // by the name of the column

// What the conditions of a vocabulary say about values.
class Conditions {
 public:
  explicit Conditions(const ltl::Vocabulary& vocabulary);
  bool compares(const std::string& column) const { return by_column_.contains(column); }  // is some condition on it?
  // A condition on none of these columns. O(conditions · columns).
  std::optional<std::string> on_none_of(const std::vector<std::string>& columns) const;
  // Inserts those that hold of this value; the condition that cannot be compared with it, if there is one.
  std::optional<std::string> insert(const std::string& column, std::string_view value, ltl::Letter& letter) const;

 private:
  std::map<std::string, std::vector<std::pair<Condition, ltl::Proposition>>> by_column_;
  std::vector<std::string> names_;  // by proposition
};

// The cells of a line. A cell in double quotes may have the delimiter inside, and "" for a quote.
std::vector<std::string> cells_of(std::string_view line, char delimiter);
// The delimiter of a heading: tab, semicolon or comma, outside of quotes; nothing when it has none. Throws
// ltl::FormatError when it has two of them.
std::optional<char> delimiter_of(std::string_view heading, std::string_view source, std::size_t line);
// The delimiter, a blank among them, with which these two lines are a heading and a row that is no line of names.
std::optional<char> table_delimiter(std::string_view first, std::string_view second);

class LetterTable {
 public:
  // Throws ltl::FormatError: a column without a name, or two of one name. `wanted`: the propositions whose columns
  // must have truth values; others are noted where they have none.
  LetterTable(std::string_view heading, char delimiter, ltl::Vocabulary& names, const ltl::Vocabulary& wanted,
              std::string source, std::size_t line);

  // The letters of a row: one, or with a time unit that of each instant since the row before.
  std::vector<ltl::Letter> row(std::string_view line, std::size_t number);
  // Rows are numbered by a column time, in steps of this unit.
  void count_time_in(double unit, std::size_t line);
  void begin_trace() { last_.reset(); }
  bool is_heading(std::string_view line) const { return line == heading_; }
  bool has_time() const { return time_.has_value(); }
  const NoTruths& no_truths() const { return no_truths_; }

 private:
  ltl::Letter letter(const std::vector<std::string>& cells, std::size_t number);
  std::size_t steps_to(const std::string& cell, std::size_t number);
  [[noreturn]] void fail(std::size_t line, const std::string& message) const;

  std::string heading_, source_;
  char delimiter_;
  std::vector<std::string> columns_;
  std::vector<ltl::Proposition> propositions_;
  std::vector<bool> wanted_, compared_;  // by column
  Conditions conditions_;
  NoTruths no_truths_;
  std::optional<std::size_t> time_;  // the column
  std::optional<double> unit_;
  double first_time_ = 0;
  std::size_t instant_ = 0;
  std::optional<ltl::Letter> last_;
};

}  // namespace waymark::plan
