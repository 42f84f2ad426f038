// The SAIL corpus as it was released [CM11], and as navi passed it on [AZ13], in the JSON Lines that we read.
//
// A directory is looked through for maps (map-*.xml of either release), SingleSentence.xml with Paragraph.xml, or
// *.settrc; one that holds our own instructions.jsonl is read and checked. What is odd is never repaired silently: it
// is reported with file and line, and named among the `flags` of its paragraph. Formats:
// docs/formats/corpus-and-models.md.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "libparser/corpus/import/released.hpp"

namespace waymark::parser {

struct ImportedCorpus {                       // a release in our formats
  std::string format;                         // "xml", "settrc" or "jsonl"
  std::string instructions;                   // JSON Lines
  std::map<std::string, std::string> maps;    // JSON by name
  std::size_t paragraphs = 0, sentences = 0;  // how many
  std::vector<Irregularity> irregularities;   // in the order of the files
};

// Throws ltl::FormatError when there is nothing to read, or a file does not have the shape of its format.
ImportedCorpus import_sail(const std::filesystem::path& directory);

}  // namespace waymark::parser
