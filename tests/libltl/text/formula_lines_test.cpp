#include "libltl/text/formula_lines.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "libltl/text/print.hpp"

namespace waymark::ltl {
namespace {

TEST(FormulaLines, AnswersLineForLine) {
  std::istringstream in("\xEF\xBB\xBF# tours\nF chair\r\n\n  F (sofa U  )\n  # indented\nG lamp");
  Arena arena;
  FormulaLines lines(in, "tour.ltl");
  std::string seen;
  while (const auto line = lines.next(arena)) {
    seen += std::to_string(line->number) + ": ";
    if (const auto* f = std::get_if<Formula>(&line->content)) seen += print(*f);
    if (const auto* error = std::get_if<SyntaxError>(&line->content)) seen += error->what();
    seen += '\n';
  }
  EXPECT_EQ(seen,
            "1: \n"
            "2: F chair\n"
            "3: \n"
            "4: expected a formula after 'U'\n"
            "  tour.ltl:4:14\n"
            "  4 |   F (sofa U  )\n"
            "    |              ^\n"
            "5: \n"
            "6: G lamp\n");
}

}  // namespace
}  // namespace waymark::ltl
