#include "libplan/world/street_map.hpp"

#include <algorithm>
#include <cmath>

#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

using Value = JsonReader::Value;

constexpr double longest = 1e100;  // way; as the costs of all models

class StreetMapReader {
 public:
  StreetMapReader(std::string_view text, StreetView view, std::string_view source)
      : in_(text, source), picture_(view == StreetView::Picture) {}

  StreetMap read() {
    const Value document = in_.parse();
    if (picture_) map_.name = in_.string(in_.member(document, "", "name"), "name");
    in_.each(document, "", "nodes", [&](const Value& v, const std::string& path) { landmark(v, path); });
    if (map_.landmarks.empty()) in_.fail("nodes", "a map without landmarks");
    map_.ways.resize(map_.landmarks.size());
    in_.each(document, "", "edges", [&](const Value& v, const std::string& path) { way(v, path); });
    return std::move(map_);
  }

 private:
  void landmark(const Value& value, const std::string& path) {
    Landmark landmark;
    landmark.id = in_.integer(in_.member(value, path, "id"), path + ".id");
    if (map_.find(landmark.id)) in_.fail(path + ".id", "two landmarks have this id");
    landmark.name = in_.string(in_.member(value, path, "name"), path + ".name");
    const std::string name = landmark_name(landmark.name);
    if (name.empty()) in_.fail(path + ".name", "a landmark without a name");
    if (picture_) {
      const bool drawn = value.contains("u") && value.contains("v");
      landmark.right = number(value, path, drawn ? "u" : "x");
      landmark.up = number(value, path, drawn ? "v" : "y");
    } else if (std::any_of(map_.landmarks.begin(), map_.landmarks.end(),
                           [&](const Landmark& other) { return landmark_name(other.name) == name; })) {
      in_.fail(path + ".name", "two landmarks are called " + name);
    }
    map_.landmarks.push_back(std::move(landmark));
  }

  double number(const Value& value, const std::string& path, const char* key) const {
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
    if (map_.length(a, b)) in_.fail(path, "two ways join these landmarks");
    const char* key = picture_ && value.contains("length") ? "length" : "metres";
    const double length = number(value, path, key);
    if (!(length >= 0 && length <= longest)) in_.fail(path + "." + key, "expected a length from 0 to 1e100");
    map_.ways[a].push_back({b, length});
    map_.ways[b].push_back({a, length});
  }

  const JsonReader in_;
  bool picture_;
  StreetMap map_;
};

}  // namespace

std::optional<LandmarkIndex> StreetMap::find(int id) const {
  for (LandmarkIndex i = 0; i < landmarks.size(); ++i)
    if (landmarks[i].id == id) return i;
  return std::nullopt;
}

std::optional<double> StreetMap::length(LandmarkIndex a, LandmarkIndex b) const {
  for (const Way& way : ways[a])
    if (way.to == b) return way.length;
  return std::nullopt;
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

StreetMap parse_street_map(std::string_view json, StreetView view, std::string_view source) {
  return StreetMapReader(json, view, source).read();
}

std::string landmark_name(std::string_view name) {
  std::string out;
  for (char c : name) {
    if (c == '\'') continue;
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (static_cast<unsigned char>(c) >= 0x80);
    if (plain)
      out += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  if (!out.empty() && out.back() == '_') out.pop_back();
  return out;
}

}  // namespace waymark::plan
