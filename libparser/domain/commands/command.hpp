// English commands with LTL formulas: one JSON object a line. Format: docs/formats/commands.md.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace waymark::parser {

// Words of a text that name a thing, marked by who wrote it.
struct MarkedMention {
  std::size_t begin = 0, end = 0;  // bytes of the text
  std::string thing;               // a key of `things`
  bool negated = false;            // the words state the opposite: "the door is shut" of a door that may be open
};

struct Command {
  std::string id, from, source,
      domain;                             // `from`: the row it was made of; "lifted", "cleanup", "osm:boston" …
  std::string type;                       // the template; "free" without one
  std::size_t n = 0;                      // its size, 0 without one
  bool lifted = false;                    // propositions stand in the text as they are
  std::string text, formula;              // as the file has them
  std::vector<std::string> propositions;  // of the formula
  std::map<std::string, std::optional<std::string>> landmarks;  // proposition → its words in the text, if verbatim
  std::map<std::string, std::string> things;  // what the text may name: in formulas the key in lower case → its name
  bool marked = false;                        // says what it may name, and where
  std::vector<MarkedMention> mentions;        // of things, in the order of the text
  std::vector<std::string> also;              // formulas that are right, too
  std::string hand, style;                    // who wrote the text, and in which manner
  std::size_t count = 1;                      // of times that the file has it
  bool suspect = false;                       // there are reasons to doubt the label
};

// Throws ltl::FormatError naming the line.
std::vector<Command> read_commands(const std::filesystem::path& file);
// The ids of a fold: the first column of a table with a header.
std::vector<std::string> read_fold(const std::filesystem::path& file);

}  // namespace waymark::parser
