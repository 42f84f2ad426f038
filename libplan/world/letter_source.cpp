#include "libplan/world/letter_source.hpp"

#include <algorithm>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/world/read_vcd.hpp"

namespace waymark::plan {
namespace {

bool says_nothing(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#';
}

// Braces and brackets are in letters alone.
bool may_be_header(std::string_view line) { return line.find_first_of("{}()[]") == std::string_view::npos; }

}  // namespace

bool LetterSource::next(std::string& line) {
  if (!settled_) settle();
  if (held_.empty()) return next_(line);
  line = std::move(held_.front());
  held_.pop_front();
  return true;
}

void LetterSource::settle() {
  settled_ = true;
  if (format_ != LetterFormat::Auto) return;
  std::string text, first;
  for (std::string line; next_(line);) {
    held_.push_back(line);
    text += line + '\n';
    if (says_nothing(line)) continue;
    if (first.empty() && is_vcd(text)) return hold_dump(text);
    ltl::refuse_foreign(text, source_, "letters");
    const bool is_second = !first.empty();
    if (is_second) {
      if (const auto delimiter = table_delimiter(first, line)) lines_.split_at(*delimiter);
    }
    if (is_second || !may_be_header(line)) return;
    first = line;
  }
}

void LetterSource::hold_dump(const std::string& begun) {
  std::string text = begun;
  for (std::string line; next_(line);) {
    text += line + '\n';
    if (text.size() > ltl::most_file_bytes) throw ltl::FormatError(source_, 0, 0, "the VCD file is too large");
  }
  held_.clear();
  const std::string table = table_of_vcd(text, source_);
  for (std::size_t begin = 0, end = 0; begin < table.size(); begin = end + 1) {
    end = std::min(table.find('\n', begin), table.size());
    held_.push_back(table.substr(begin, end - begin));
  }
  lines_.split_at('\t');
  lines_.name_source(source_ + " as a table");
}

NamedTraces read_traces(std::string_view text, const LetterOptions& options, const std::string& source) {
  if (options.format == LetterFormat::Auto && !is_vcd(text)) ltl::refuse_foreign(text, source, "letters");
  LetterLines lines(options, source);
  LetterSource from(lines, options.format, source, [&](std::string& line) {
    if (text.empty()) return false;
    const auto end = text.find('\n');
    line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return true;
  });
  NamedTraces out;
  std::vector<ltl::Letter> letters;
  const auto end_trace = [&] {
    if (letters.empty())
      throw ltl::FormatError(source, lines.line(), 0, "there are no letters; the empty letter is {}");
    out.words.emplace_back(std::exchange(letters, {}));
  };
  for (std::string line; from.next(line);) {
    if (LetterLines::separates(line)) {
      end_trace();
      lines.begin_trace();
      continue;
    }
    for (ltl::Letter& letter : lines.read(line)) letters.push_back(std::move(letter));
  }
  if (!letters.empty() || out.words.empty()) end_trace();
  if (const auto condition = lines.uncompared())
    throw ltl::FormatError(source, 0, 0, "no letter has a value to compare in \"" + *condition + '"');
  out.vocabulary = lines.vocabulary();
  out.names_all = lines.is_table();
  out.has_time = lines.has_time();
  out.no_truths = lines.no_truths();
  return out;
}

}  // namespace waymark::plan
