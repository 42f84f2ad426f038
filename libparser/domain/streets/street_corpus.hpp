// Street instructions, each paired with the route it describes: JSON Lines beside the maps of their cities.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "libparser/domain/streets/street_map.hpp"

namespace waymark::streets {

struct StreetInstruction {          // a text with its route
  std::string id, text;             // as the file has them
  std::vector<std::string> tokens;  // of the text
  std::size_t map = 0;              // position in StreetCorpus::maps
  LandmarkIndex start = 0;          // of the route
  StreetRoute path;                 // the route described: the only supervision
};

struct StreetCorpus {
  std::vector<StreetMap> maps;                  // by name
  std::vector<StreetInstruction> instructions;  // in the order of the file
  std::uint64_t checksum = 0;                   // FNV-1a of the instruction file as read
};

// Is this a corpus of streets? Its first instruction has a route over landmarks where others have sentences.
bool is_street_corpus(const std::filesystem::path& directory);

// directory/instructions.jsonl and directory/maps/*.json. Throws ltl::FormatError with file, line and key.
StreetCorpus read_street_corpus(const std::filesystem::path& directory);
// The lines alone, about these maps.
std::vector<StreetInstruction> parse_street_instructions(std::string_view json_lines,
                                                         const std::vector<StreetMap>& maps,
                                                         std::string_view source = "");

}  // namespace waymark::streets
