#include "libparser/corpus/import/write_corpus.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

#include "libparser/corpus/token.hpp"

namespace waymark::parser {
namespace {

using json = nlohmann::ordered_json;
using plan::Pose;

json json_of(const std::vector<Pose>& path) {
  json out = json::array();
  for (const Pose& p : path) out.push_back({p.x, p.y, p.heading});
  return out;
}

// The trajectory from the heading `from` in the place of the open one: the shortest turns are put in, LEFT LEFT for
// half a turn.
std::vector<Pose> resolved(const std::vector<Pose>& path, int from) {
  std::vector<Pose> out{{path[0].x, path[0].y, from}};
  if (path.size() == 1) return out;
  const int turn = (path[1].heading - from + 360) % 360;
  if (turn == 180) out.push_back({path[0].x, path[0].y, (from + 270) % 360});
  out.insert(out.end(), path.begin() + (turn == 0 ? 2 : 1), path.end());
  return out;
}

json json_of(const ReleasedSentence& sentence) {
  const std::vector<Pose>& path = sentence.trace.poses;
  json out{{"id", sentence.id}, {"text", sentence.text}, {"tokens", tokenize(sentence.text)}, {"path", json_of(path)}};
  if (path.front().heading >= 0) return out;
  const int known = path.size() > 1 ? path[1].heading : 90;
  out["path_north"] = json_of(resolved(path, 0));
  out["path_right90"] = json_of(resolved(path, (known + 270) % 360));
  return out;
}

// "WLH_Grid0_4_7_Dirs_1": author, map, start and goal place, version.
void add_from_name(json& out, const std::string& id) {
  std::vector<std::string> parts(1);
  for (const char c : id)
    if (c == '_')
      parts.emplace_back();
    else
      parts.back() += c;
  if (parts.size() != 6) return;
  out["author"] = parts[0];
  const auto place = [&](const char* key, const std::string& text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size()) out[key] = value;
  };
  place("start_place", parts[2]);
  place("goal_place", parts[3]);
}

}  // namespace

std::string json_line(const ReleasedParagraph& p, const std::vector<Irregularity>& flags) {
  json out{{"id", p.id}};
  if (p.number != 0) out["num"] = p.number;
  out["map"] = p.map;
  add_from_name(out, p.id);
  if (!p.path.empty()) out["start"] = {p.path[0].x, p.path[0].y, p.path[0].heading};
  if (p.goal) out["goal"] = {p.goal->x, p.goal->y};
  out["text"] = p.text;
  out["path"] = json_of(p.path);
  out["sentences"] = json::array();
  for (const ReleasedSentence& sentence : p.sentences) out["sentences"].push_back(json_of(sentence));
  if (!p.properties.empty()) out["properties"] = p.properties;
  out["flags"] = json::array();
  for (const Irregularity& flag : flags) out["flags"].push_back({{"kind", flag.kind}, {"message", flag.message}});
  return out.dump();
}

std::string json_map(const ReleasedMap& map) {
  json out{{"name", map.name},
           {"headings", {{"0", {0, -1}}, {"90", {1, 0}}, {"180", {0, 1}}, {"270", {-1, 0}}}},
           {"objects", map.objects},
           {"floors", map.floors},
           {"walls", map.walls}};
  out["nodes"] = json::array();
  for (const plan::Node& n : map.nodes)
    out["nodes"].push_back({{"x", n.x},
                            {"y", n.y},
                            {"object", n.object ? json(*n.object) : json(nullptr)},
                            {"place", n.place ? json(*n.place) : json(nullptr)}});
  out["edges"] = json::array();
  for (const plan::Edge& e : map.edges) {
    const plan::Node &a = map.nodes[e.a], &b = map.nodes[e.b];
    out["edges"].push_back({{"a", {a.x, a.y}}, {"b", {b.x, b.y}}, {"floor", e.floor}, {"wall", e.wall}});
  }
  return out.dump(1) + "\n";
}

}  // namespace waymark::parser
