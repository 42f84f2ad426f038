// Formula collections of the literature, where they are at hand: every line is read, and printing it reads back.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "libltl/text/formula_lines.hpp"
#include "libltl/text/print.hpp"

namespace waymark::ltl {
namespace {

namespace fs = std::filesystem;

fs::path shared() {
  const char* const given = std::getenv("WAYMARK_SHARED");
  return given != nullptr ? fs::path(given) : fs::path(WAYMARK_SOURCE_DIR) / ".." / "shared";
}

std::size_t read_all(const fs::path& file, const ParseOptions& options) {
  std::ifstream in(file);
  FormulaLines lines(in, file.filename().string(), options);
  std::size_t count = 0;
  while (true) {
    Arena arena;
    const auto line = lines.next(arena);
    if (!line) return count;
    if (const auto* error = std::get_if<SyntaxError>(&line->content)) {
      ADD_FAILURE() << error->what();
    } else if (const auto* f = std::get_if<Formula>(&line->content)) {
      ++count;
      EXPECT_EQ(parse(print(*f), arena), *f) << file << ':' << line->number;
    }
  }
}

TEST(Corpora, AreReadToTheLastLine) {
  if (!fs::exists(shared() / "ltl"))
    GTEST_SKIP() << "SKIPPED: no formula collections in " << shared() / "ltl";
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(shared() / "ltl")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".ltl" && extension != ".ltlf") continue;
    ++files;
    const Dialect dialect = extension == ".ltlf" ? Dialect::Spot : Dialect::Waymark;
    EXPECT_GT(read_all(entry.path(), {.dialect = dialect}), 0U) << entry.path();
  }
  EXPECT_GT(files, 0U);
}

}  // namespace
}  // namespace waymark::ltl
