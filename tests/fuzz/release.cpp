// Released files of SAIL: refused with a FormatError, or what is made of them is what our own readers take. The text
// says by its beginning what it is: "<map", other XML, or set traces.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/import/irregularities.hpp"
#include "libparser/corpus/import/read_settrc.hpp"
#include "libparser/corpus/import/read_xml.hpp"
#include "libparser/corpus/import/released_text.hpp"
#include "libparser/corpus/import/write_corpus.hpp"
#include "libparser/corpus/sail_corpus.hpp"
#include "libplan/world/read_map.hpp"

namespace {

using namespace waymark;

std::vector<parser::ReleasedParagraph> paragraphs_of(std::string_view text) {
  std::vector<parser::ReleasedParagraph> out;
  if (text.substr(0, 1) != "<") {
    for (parser::SettrcParagraph& read : parser::parse_settrc(text, "fuzz")) out.push_back(read.paragraph);
    return out;
  }
  for (const parser::XmlExample& example : parser::parse_xml_examples(text, "fuzz")) {
    parser::ReleasedParagraph& paragraph = out.emplace_back();
    paragraph.id = example.file_name;
    paragraph.map = example.map;
    paragraph.number = 1;
    paragraph.start = example.start;
    paragraph.goal = example.end;
    paragraph.path = example.path;
    parser::ReleasedSentence& sentence = paragraph.sentences.emplace_back();
    sentence.id = example.id;
    sentence.text = example.text;
    sentence.trace.poses = example.path;
  }
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 4'096) return 0;
  std::string json;
  bool is_map = false;
  try {
    const std::string text = parser::released_text({reinterpret_cast<const char*>(data), size}, "fuzz");
    is_map = text.rfind("<map", 0) == 0;
    if (is_map)
      json = parser::json_map(parser::parse_xml_map(text, "fuzz"));
    else
      for (parser::ReleasedParagraph& paragraph : paragraphs_of(text))
        json += parser::json_line(paragraph, parser::find_irregularities(paragraph, nullptr)) + "\n";
  } catch (const ltl::FormatError&) {
    return 0;
  }
  if (is_map)
    plan::parse_map(json);
  else
    parser::parse_sail_corpus(json);
  return 0;
}
