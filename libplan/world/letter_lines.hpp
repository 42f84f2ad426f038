// Letters as they come, line by line: text, JSON, or CSV with a header.
//
//   text   {a, b}        or   a b; ; c              one letter or more on a line, `;` between them
//   JSON   ["a","b"]     or   {"a":true,"b":0}      one letter on a line
//   CSV    a,b           then 1,0                   names, then one letter on a line (letter_table.hpp); also with
//                                                   semicolons, tabs or blanks
// Blank lines and lines that begin with # are passed over; the empty letter is {}, [] or a row of zeros. A line of two
// or more dashes separates traces.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"
#include "libplan/world/letter_table.hpp"

namespace waymark::plan {

// Auto: JSON where the first line is JSON, CSV where it has commas and no braces, else text. Of a whole text, CSV too
// where the second line has numbers below names.
enum class LetterFormat : std::uint8_t { Auto, Text, Json, Csv };

struct LetterOptions {                       // how letters are written, and which names matter
  LetterFormat format = LetterFormat::Auto;  // of the lines
  std::optional<double> time_unit = {};      // of a table with a column time: instants between rows repeat a row
  ltl::Vocabulary wanted = {};  // columns and keys that must have truth values, and conditions on the others
};

class LetterLines {
 public:
  // Letters are over the wanted names, further names behind them. These mean nothing from one letter to the next, for
  // only some thousands are remembered.
  struct Forgetful {
    LetterOptions options;  // of the letters
  };
  LetterLines(Forgetful options, std::string source);
  // Letters are over the wanted names and those that occur, all of which are remembered.
  LetterLines(LetterOptions options, std::string source);

  // The letters of the next line; none of a header, a comment or a blank line. Throws ltl::FormatError or
  // ltl::SyntaxError with the number of the line; of a line that separates traces too.
  std::vector<ltl::Letter> read(std::string_view line);
  void pass_over() { ++line_; }  // a line that the caller knows already
  static bool separates(std::string_view line);
  void begin_trace();             // the line was one that separates; a table may repeat its header
  void split_at(char delimiter);  // the lines are a table with this delimiter
  void name_source(std::string source) { source_ = std::move(source); }  // of the errors from now on
  const ltl::Vocabulary& vocabulary() const { return names_; }
  bool is_table() const { return table_.has_value(); }
  bool has_time() const { return table_ && table_->has_time(); }
  NoTruths no_truths() const;
  // A condition among the wanted names that no letter had a value for.
  std::optional<std::string> uncompared() const;
  std::size_t line() const { return line_; }

 private:
  LetterFormat format_of(std::string_view first) const;
  std::vector<ltl::Letter> text_letters(std::string_view line);
  ltl::Letter json_letter(std::string_view line);
  std::vector<ltl::Letter> table_letters(std::string_view line);
  void begin_table(std::string_view heading);
  void check_name(const std::string& name) const;

  ltl::Vocabulary vocabulary_, names_;
  LetterOptions options_;
  bool forgets_ = true;
  std::string source_;
  std::size_t line_ = 0;
  bool begins_trace_ = false;
  std::optional<char> delimiter_;
  std::optional<LetterTable> table_;
  Conditions conditions_;
  NoTruths no_truths_;             // of JSON
  std::vector<std::string> keys_;  // of JSON, those that conditions compare
};

}  // namespace waymark::plan
