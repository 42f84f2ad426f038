#include "libltl/text/formula_lines.hpp"

#include <utility>

namespace waymark::ltl {

FormulaLines::FormulaLines(std::istream& in, std::string source, const ParseOptions& options)
    : in_(in), source_(std::move(source)), options_(options) {}

std::optional<FormulaLine> FormulaLines::next(Arena& arena) {
  FormulaLine line;
  if (!std::getline(in_, line.text)) return std::nullopt;
  line.number = ++number_;
  if (!line.text.empty() && line.text.back() == '\r') line.text.pop_back();
  if (number_ == 1 && line.text.substr(0, 3) == "\xEF\xBB\xBF") line.text.erase(0, 3);  // byte order mark
  const std::size_t begin = line.text.find_first_not_of(" \t");
  if (begin == std::string::npos || line.text[begin] == '#') return line;
  try {
    line.content = parse(line.text, arena, options_);
  } catch (const SyntaxError& error) {
    line.content = error.in(source_, line.number);
  }
  return line;
}

}  // namespace waymark::ltl
