// One instruction of a batch: a line of text, or a JSON object that says where it is spoken, too.
//
//   go to the chair
//   {"text":"go to the chair","map":"grid","start":[1,9,0]}       map and start may be left out; "start":"1,9,0" does
//     as well
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace waymark::parser {

struct Instruction {
  std::string text;                       // the sentence
  std::optional<std::string> map;         // a name
  std::optional<std::string> start;       // "x,y,heading"
  std::optional<std::string> id, domain;  // of commands: a name of theirs; "cleanup", "osm:boston" …
};

// Throws ltl::FormatError naming the value that is wrong.
Instruction parse_instruction(std::string_view line, std::string_view source, std::size_t number);

}  // namespace waymark::parser
