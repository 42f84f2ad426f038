// Landmarks of a city: their names, and what a map says of them. Format: docs/formats/commands.md.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace waymark::parser {

struct Landmark {
  std::string proposition, name;
  std::vector<std::string> other_names;
  std::map<std::string, std::string> tags;
};

// Throws ltl::FormatError naming what is wrong with the file.
std::vector<Landmark> read_landmarks(const std::filesystem::path& file);

}  // namespace waymark::parser
