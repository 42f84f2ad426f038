#include "libparser/domain/streets/street_map.hpp"

#include <algorithm>

#include "libparser/corpus/corpus_file.hpp"

namespace waymark::streets {

StreetMap parse_street_map(std::string_view json, std::string_view source) {
  StreetMap map = plan::parse_street_map(json, plan::StreetView::Picture, source);
  for (auto& ways : map.ways)
    std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.to < b.to; });
  return map;
}

StreetMap read_street_map(const std::filesystem::path& file) {
  return parse_street_map(parser::read_corpus_file(file), file.string());
}

}  // namespace waymark::streets
