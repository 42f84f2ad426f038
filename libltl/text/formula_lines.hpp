// Files of formulas, one a line: blank lines and lines that start with '#' hold none.
//
// Every line of the file is reported, the empty ones too, so that a batch can answer line for line; an error on one
// line does not stop the next. SyntaxErrors carry the file's name and the line's number in it.
#pragma once
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libltl/formula.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::ltl {

struct FormulaLine {
  std::size_t number = 0;                                      // 1-based
  std::string text;                                            // without the line end
  std::variant<std::monostate, Formula, SyntaxError> content;  // monostate: blank or a comment
};

class FormulaLines {
 public:
  // The stream must outlive the reader. `source` names the file in messages.
  FormulaLines(std::istream& in, std::string source, const ParseOptions& options = {});
  std::optional<FormulaLine> next(
      Arena& arena);  // nothing at the end; the arena may differ from line to line

 private:
  std::istream& in_;
  std::string source_;
  ParseOptions options_;
  std::size_t number_ = 0;
};

}  // namespace waymark::ltl
