#include "libparser/domain/streets/street_map.hpp"

#include <algorithm>
#include <cmath>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/token.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::streets {
namespace {

using plan::JsonReader;
using Value = JsonReader::Value;

class Reader {
 public:
  Reader(std::string_view text, std::string_view source) : in_(text, source) {}

  StreetMap read() {
    const Value document = in_.parse();
    map_.name = in_.string(in_.member(document, "", "name"), "name");
    in_.each(document, "", "nodes", [&](const Value& v, const std::string& path) { landmark(v, path); });
    if (map_.landmarks.empty()) in_.fail("nodes", "a map without landmarks");
    map_.ways.resize(map_.landmarks.size());
    in_.each(document, "", "edges", [&](const Value& v, const std::string& path) { way(v, path); });
    for (auto& ways : map_.ways)
      std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.to < b.to; });
    return std::move(map_);
  }

 private:
  void landmark(const Value& value, const std::string& path) {
    Landmark landmark;
    landmark.id = in_.integer(in_.member(value, path, "id"), path + ".id");
    if (map_.find(landmark.id)) in_.fail(path + ".id", "two landmarks have this id");
    landmark.name = in_.string(in_.member(value, path, "name"), path + ".name");
    landmark.tokens = parser::tokenize(landmark.name);
    if (landmark.tokens.empty()) in_.fail(path + ".name", "a landmark without a name");
    const bool picture = value.contains("u") && value.contains("v");
    landmark.right = coordinate(value, path, picture ? "u" : "x");
    landmark.up = coordinate(value, path, picture ? "v" : "y");
    map_.landmarks.push_back(std::move(landmark));
  }

  double coordinate(const Value& value, const std::string& path, const char* key) const {
    return in_.number(in_.member(value, path, key), path + "." + key);
  }

  LandmarkIndex end(const Value& value, const std::string& path, const char* key) const {
    const auto at = map_.find(in_.integer(in_.member(value, path, key), path + "." + key));
    if (!at) in_.fail(path + "." + key, "there is no landmark with that id");
    return *at;
  }

  void way(const Value& value, const std::string& path) {
    const LandmarkIndex a = end(value, path, "a"), b = end(value, path, "b");
    if (a == b) in_.fail(path + ".b", "a way from a landmark to itself");
    if (has(a, b)) in_.fail(path, "two ways join these landmarks");
    const char* key = value.contains("length") ? "length" : "metres";
    const double length = coordinate(value, path, key);
    if (length < 0) in_.fail(path + "." + key, "a negative length");
    map_.ways[a].push_back({b, length});
    map_.ways[b].push_back({a, length});
  }

  bool has(LandmarkIndex a, LandmarkIndex b) const {
    return std::any_of(map_.ways[a].begin(), map_.ways[a].end(), [b](const Way& w) { return w.to == b; });
  }

  const JsonReader in_;
  StreetMap map_;
};

}  // namespace

std::optional<LandmarkIndex> StreetMap::find(int id) const {
  for (LandmarkIndex i = 0; i < landmarks.size(); ++i)
    if (landmarks[i].id == id) return i;
  return std::nullopt;
}

std::optional<double> StreetMap::length(LandmarkIndex a, LandmarkIndex b) const {
  const auto at = std::lower_bound(ways[a].begin(), ways[a].end(), b,
                                   [](const Way& w, LandmarkIndex i) { return w.to < i; });
  if (at == ways[a].end() || at->to != b) return std::nullopt;
  return at->length;
}

double StreetMap::distance(LandmarkIndex a, LandmarkIndex b) const {
  return std::hypot(landmarks[a].right - landmarks[b].right, landmarks[a].up - landmarks[b].up);
}

double StreetMap::mean_way() const {
  double sum = 0;
  std::size_t count = 0;
  for (LandmarkIndex a = 0; a < ways.size(); ++a)
    for (const Way& way : ways[a]) sum += distance(a, way.to), ++count;
  return sum > 0 ? sum / static_cast<double>(count) : 1;
}

StreetMap parse_street_map(std::string_view json, std::string_view source) {
  return Reader(json, source).read();
}

StreetMap read_street_map(const std::filesystem::path& file) {
  return parse_street_map(parser::read_corpus_file(file), file.string());
}

}  // namespace waymark::streets
