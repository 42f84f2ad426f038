// The lines of a text of letters as they come: first the format is settled, then one line is given after the other.
//
// A first line of names alone may be a letter or the header of a table: it is kept until the next one has come. A VCD
// file is read whole and becomes a table.
#pragma once
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libplan/world/letter_lines.hpp"

namespace waymark::plan {

class LetterSource {
 public:
  using NextLine = std::function<bool(std::string&)>;  // false at the end of the text
  LetterSource(LetterLines& lines, LetterFormat format, std::string source, NextLine next)
      : lines_(lines), format_(format), source_(std::move(source)), next_(std::move(next)) {}

  // The next line for `lines`, which reads it, or begins a trace where it separates. Throws ltl::FormatError for a text
  // of another format.
  bool next(std::string& line);

 private:
  void settle();
  void hold_dump(const std::string& text);

  LetterLines& lines_;
  LetterFormat format_;
  std::string source_;
  NextLine next_;
  bool settled_ = false;
  std::deque<std::string> held_;
};

struct NamedTraces {              // words with their names
  std::vector<ltl::Trace> words;  // one or more
  ltl::Vocabulary vocabulary;     // of the words
  bool names_all = false;         // of a table: other propositions are not merely false, they are unknown
  bool has_time = false;          // a column time
  NoTruths no_truths;             // names in the vocabulary that are no propositions
};
// All letters of a text, which may be a VCD file. Throws as above, and ltl::FormatError when a trace has no letters.
NamedTraces read_traces(std::string_view text, const LetterOptions& options, const std::string& source);

}  // namespace waymark::plan
