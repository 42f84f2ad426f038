// Letters as they come, line by line: text, JSON, or CSV with a header.
//
//   text   {a, b}        or   a b; ; c              one letter or more on a line, `;` between them
//   JSON   ["a","b"]     or   {"a":true,"b":0}      one letter on a line
//   CSV    a,b           then 1,0                   names, then one letter on a line: 1 or 0, true or false, or nothing
// Blank lines and lines that begin with # are passed over; the empty letter is {}, [] or a row of zeros.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"

namespace waymark::plan {

// Auto: JSON where the first line is JSON, CSV where it has commas and no braces, else text.
enum class LetterFormat : std::uint8_t { Auto, Text, Json, Csv };

class LetterLines {
 public:
  // Letters are over `vocabulary`, further names behind it. These mean nothing from one letter to the next, for only
  // some thousands are remembered.
  LetterLines(ltl::Vocabulary vocabulary, LetterFormat format, std::string source);
  // Letters are over the names that occur, all of which are remembered.
  LetterLines(LetterFormat format, std::string source);

  // The letters of the next line; none of a header, a comment or a blank line. Throws ltl::FormatError or
  // ltl::SyntaxError with the number of the line.
  std::vector<ltl::Letter> read(std::string_view line);
  void pass_over() { ++line_; }  // a line that the caller knows already
  const ltl::Vocabulary& vocabulary() const { return names_; }
  bool is_table() const { return !header_.empty(); }

 private:
  LetterFormat format_of(std::string_view first) const;
  std::vector<ltl::Letter> text_letters(std::string_view line);
  ltl::Letter json_letter(std::string_view line);
  void read_header(std::string_view line);
  ltl::Letter csv_letter(std::string_view line) const;

  ltl::Vocabulary vocabulary_, names_;
  LetterFormat format_;
  bool forgets_ = true;
  std::string source_;
  std::size_t line_ = 0;
  std::vector<ltl::Proposition> header_;  // of CSV, by column
};

struct NamedTrace {            // a word with its names
  ltl::Trace word;             // not empty
  ltl::Vocabulary vocabulary;  // of the word
  bool names_all = false;      // of a table: other propositions are not merely false, they are unknown
};
// All letters of a text. Throws as above, and ltl::FormatError when there is none.
NamedTrace read_letters(std::string_view text, LetterFormat format, const std::string& source);

}  // namespace waymark::plan
