#include "libparser/corpus/import/read_settrc.hpp"

#include <charconv>
#include <map>
#include <string>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

struct TextLine {
  std::string_view text;  // without blanks at its ends
  std::size_t number, column;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

// Blocks are separated by blank lines; comments belong to none.
std::vector<std::vector<TextLine>> blocks_of(std::string_view text) {
  std::vector<std::vector<TextLine>> blocks(1);
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t newline = text.find('\n', begin);
    const std::size_t end = newline == std::string_view::npos ? text.size() : newline;
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    const std::size_t column = line.empty() ? 1 : 1 + static_cast<std::size_t>(line.data() - &text[begin]);
    if (line.empty() && !blocks.back().empty()) blocks.emplace_back();
    if (!line.empty() && line.substr(0, 2) != "//") blocks.back().push_back({line, number, column});
    begin = end + 1;
  }
  if (blocks.back().empty()) blocks.pop_back();
  return blocks;
}

std::map<std::string, std::string, std::less<>> properties_of(const TextLine& line, std::string_view file) {
  std::map<std::string, std::string, std::less<>> properties;
  for (std::size_t begin = 0; begin < line.text.size();) {
    const std::size_t end = std::min(line.text.find('\t', begin), line.text.size());
    const std::string_view property = trimmed(line.text.substr(begin, end - begin));
    begin = end + 1;
    if (property.empty()) continue;
    const std::size_t equals = property.find('=');
    if (equals == std::string_view::npos)
      throw ltl::FormatError(file, line.number, 0, "expected properties key=value, separated by tabs");
    if (!properties.emplace(property.substr(0, equals), property.substr(equals + 1)).second)
      throw ltl::FormatError(file, line.number, 0,
                             "the property " + std::string(property.substr(0, equals)) + " stands twice");
  }
  return properties;
}

int place(const std::map<std::string, std::string, std::less<>>& properties, const char* key, const TextLine& line,
          std::string_view file) {
  const auto at = properties.find(key);
  int value = 0;
  if (at != properties.end()) {
    const std::string& text = at->second;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size()) return value;
  }
  throw ltl::FormatError(file, line.number, 0, std::string("expected a place number in property ") + key);
}

}  // namespace

std::vector<SettrcParagraph> parse_settrc(std::string_view text, std::string_view file) {
  std::vector<SettrcParagraph> paragraphs;
  for (const auto& block : blocks_of(text)) {
    if (block.size() < 2)
      throw ltl::FormatError(file, block[0].number, 0, "expected a line of properties after the id");
    if (block.size() % 2 != 0)
      throw ltl::FormatError(file, block.back().number, 0, "expected a trace after every sentence");
    const auto properties = properties_of(block[1], file);
    const auto map = properties.find("map");
    if (map == properties.end()) throw ltl::FormatError(file, block[1].number, 0, "the property map is missing");
    SettrcParagraph out;
    out.paragraph.id = block[0].text;
    out.paragraph.map = lower(map->second);
    out.paragraph.file = file;
    out.paragraph.line = block[0].number;
    out.start_place = place(properties, "y", block[1], file);
    out.goal_place = place(properties, "x", block[1], file);
    for (const auto& [key, value] : properties)
      if (key != "map" && key != "x" && key != "y") out.paragraph.properties.emplace(key, value);
    for (std::size_t i = 2; i < block.size(); i += 2)
      out.paragraph.sentences.push_back({{},
                                         std::string(block[i].text),
                                         parse_trace(block[i + 1].text, file, block[i + 1].number, block[i + 1].column),
                                         std::string(file),
                                         block[i].number});
    paragraphs.push_back(std::move(out));
  }
  return paragraphs;
}

}  // namespace waymark::parser
