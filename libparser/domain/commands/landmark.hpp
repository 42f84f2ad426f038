// Landmarks of a city, and other named propositions: their names, and what is said of them. Formats:
// docs/formats/commands.md.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace waymark::parser {

struct Landmark {
  std::string proposition, name;            // as the file has them
  std::vector<std::string> other_names;     // by which people call it
  std::map<std::string, std::string> tags;  // of OpenStreetMap
};

// Throws ltl::FormatError naming what is wrong with the file.
std::vector<Landmark> read_landmarks(const std::filesystem::path& file);
// Propositions with names, tags and descriptions; what has no name is called as its proposition reads.
std::vector<Landmark> read_propositions(const std::filesystem::path& file);

inline constexpr const char* description_tag = "waymark:description";  // words that are worth as much as tags

}  // namespace waymark::parser
