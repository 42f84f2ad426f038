// Formula collections of the literature, where they are at hand: every line is read, and printing it reads back.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
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
  std::size_t count = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.find_first_not_of(" \t") == std::string::npos || line.front() == '#') continue;
    ++count;
    Arena arena;
    try {
      const Formula f = parse(line, arena, options);
      EXPECT_EQ(parse(print(f), arena), f) << file << ':' << number;
    } catch (const SyntaxError& error) {
      ADD_FAILURE() << error.in(file.filename().string(), number).what();
    }
  }
  return count;
}

TEST(Corpora, AreReadToTheLastLine) {
  if (!fs::exists(shared() / "ltl")) GTEST_SKIP() << "SKIPPED: no formula collections in " << shared() / "ltl";
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
