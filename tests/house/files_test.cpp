// Files: small, named after the theory, finished, and citing sources that exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "tests/house/source_tree.hpp"

namespace waymark::house {
namespace {

constexpr std::size_t most_header_lines = 150, most_source_lines = 400;
constexpr std::ptrdiff_t most_columns = 120;

TEST(Files, AreSmall) {
  for (const SourceFile& file : files("hpp cpp")) {
    const bool is_test = file.path.starts_with("tests/");
    const std::size_t most = file.path.ends_with(".hpp") && !is_test ? most_header_lines : most_source_lines;
    EXPECT_LE(file.lines.size(), most) << file.path;
  }
}

// Columns are characters of UTF-8. Blocks of code in the manual show output as it is.
TEST(Files, HaveNarrowLines) {
  for (const SourceFile& file : files("hpp cpp md")) {
    bool is_code_block = false;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      const auto columns = std::count_if(line.begin(), line.end(),
                                         [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
      if (file.path.ends_with(".md") && line.starts_with("```")) is_code_block = !is_code_block;
      EXPECT_TRUE(is_code_block || columns <= most_columns) << file.path << ":" << i + 1;
    }
  }
}

TEST(Files, AreNamedAfterWhatTheyHold) {
  const std::set<std::string> vague{"util", "utils", "common", "core", "manager", "base", "helper", "helpers", "misc"};
  for (const SourceFile& file : files("hpp cpp txt md"))
    for (const auto& part : std::filesystem::path(file.path))
      EXPECT_FALSE(vague.contains(part.stem().string())) << file.path;
}

// Two types of one name in one namespace are one type to the linker. (Types inside others, and in unnamed namespaces of
// sources, are not seen: they begin with white space, or are not in headers.)
TEST(Files, NameEveryTypeOnce) {
  const std::regex type("(?:class|struct|enum class) ([A-Z][A-Za-z0-9]*)(?: final)?(?: :[^;]*)?(?: \\{.*)?");
  std::map<std::string, std::string> seen;
  for (const SourceFile& file : files("hpp")) {
    if (!file.path.starts_with("lib")) continue;
    std::string space;
    for (const std::string& line : file.lines) {
      if (line.rfind("namespace ", 0) == 0) space = line.substr(0, line.find('{'));
      std::smatch match;
      if (!std::regex_match(line, match, type) || line.find('{') == std::string::npos) continue;
      const auto [at, fresh] = seen.try_emplace(space + match.str(1), file.path);
      EXPECT_TRUE(fresh) << match.str(1) << " in " << at->second << " and " << file.path;
    }
  }
}

TEST(Files, AreFinished) {
  const std::regex unfinished(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X|HA"
      "CK)\\b");
  for (const SourceFile& file : files("hpp cpp cmake txt"))
    for (std::size_t i = 0; i < file.lines.size(); ++i)
      EXPECT_FALSE(std::regex_search(file.lines[i], unfinished)) << file.path << ":" << i + 1 << ": " << file.lines[i];
}

TEST(Files, HeadersStartWithWhatTheyAre) {
  for (const SourceFile& file : files("hpp")) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_TRUE(file.lines.front().starts_with("// ")) << file.path << ": the first comment says the idea";
    EXPECT_NE(std::find(file.lines.begin(), file.lines.end(), "#pragma once"), file.lines.end()) << file.path;
  }
}

std::set<std::string> bibliography() {
  std::ifstream in(root() / "docs/references.bib");
  const std::regex entry("@\\w+\\{([^,]+),.*");
  std::set<std::string> keys;
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, entry)) continue;
    EXPECT_TRUE(keys.insert(match[1]).second) << "docs/references.bib has " << match[1] << " twice";
  }
  return keys;
}

// [BK08], [BBD+15, Sec. 3]: initials of the authors and two digits of the year.
TEST(Files, CiteSourcesThatExist) {
  const std::set<std::string> keys = bibliography();
  ASSERT_FALSE(keys.empty());
  const std::regex citation("\\[([A-Z][A-Za-z]*\\+?[0-9]{2}[a-z]?)(,[^\\]]*)?\\]");
  std::size_t citations = 0;
  for (const SourceFile& file : files("hpp cpp md"))
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      for (auto match = std::sregex_iterator(line.begin(), line.end(), citation); match != std::sregex_iterator();
           ++match) {
        ++citations;
        EXPECT_TRUE(keys.contains((*match)[1]))
            << file.path << ":" << i + 1 << " cites " << match->str() << ", which docs/references.bib does not have";
      }
    }
  EXPECT_GT(citations, 0U);
}

TEST(Files, LinkToPagesThatExist) {
  const std::regex link("\\]\\(([^)#: ]+)(#[^)]*)?\\)");
  std::size_t links = 0;
  for (const SourceFile& file : files("md"))
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      for (auto match = std::sregex_iterator(line.begin(), line.end(), link); match != std::sregex_iterator();
           ++match) {
        ++links;
        const auto target = root() / std::filesystem::path(file.path).parent_path() / (*match)[1].str();
        EXPECT_TRUE(std::filesystem::exists(target)) << file.path << ":" << i + 1 << " links to " << (*match)[1];
      }
    }
  EXPECT_GT(links, 0U);
}

}  // namespace
}  // namespace waymark::house
