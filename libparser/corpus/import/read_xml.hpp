// Maps and examples of the release in XML, of Chen and Mooney [CM11] and of navi [AZ13].
#pragma once
#include <string_view>
#include <vector>

#include "libparser/corpus/import/released.hpp"

namespace waymark::parser {

// Nodes and edges at any depth: both releases read alike. Throws ltl::FormatError.
ReleasedMap parse_xml_map(std::string_view xml, std::string_view file);

struct XmlExample {                      // of SingleSentence.xml or Paragraph.xml
  std::string id, map, file_name, text;  // attributes and text
  std::optional<plan::Pose> start, end;  // of paragraphs
  std::vector<plan::Pose> path;          // of the example
  std::size_t line = 0;                  // where the element begins
};
std::vector<XmlExample> parse_xml_examples(std::string_view xml, std::string_view file);  // throws ltl::FormatError

}  // namespace waymark::parser
