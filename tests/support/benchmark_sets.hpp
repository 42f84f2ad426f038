// The open benchmark sets and what the peers answer on them.
#pragma once
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tests/support/places.hpp"

namespace waymark::testing {

inline std::filesystem::path benchmark_sets() { return shared() / "ltl"; }

// By line of the set: the number in a column of a tab-separated file with headings, where there is one.
inline std::map<std::size_t, std::size_t> column(const std::filesystem::path& path, const std::string& name) {
  std::map<std::size_t, std::size_t> out;
  std::ifstream in(path);
  std::string line, cell;
  std::getline(in, line);
  std::istringstream head(line);
  std::size_t at = 0;
  while (std::getline(head, cell, '\t') && cell != name) ++at;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream row(line);
    for (std::size_t i = 0; i <= at; ++i) std::getline(row, cell, '\t');
    if (!cell.empty() && cell.find_first_not_of("0123456789") == std::string::npos) out[number] = std::stoul(cell);
  }
  return out;
}

}  // namespace waymark::testing
