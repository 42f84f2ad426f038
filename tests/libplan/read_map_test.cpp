#include "libplan/world/read_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <tuple>

#include "libltl/diagnostic.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

std::string message_of(const std::string& json) {
  try {
    parse_map(json, "m.json");
  } catch (const ltl::FormatError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadMap, ReadsTheParts) {
  const Map map = parse_map(R"({"name": "tiny", "walls": ["fish", "tower"],
    "nodes": [{"x": -1, "y": 2, "object": "pine cone", "place": 2}, {"x": -1, "y": 3, "object": null, "place": null}],
    "edges": [{"a": [-1,2], "b": [-1,3], "floor": "moss", "wall": "fish"}]})");
  EXPECT_EQ(map.name(), "tiny");
  EXPECT_EQ(map.objects(), std::vector<std::string>{"pine cone"});  // not listed: the values used
  EXPECT_EQ(map.floors(), std::vector<std::string>{"moss"});
  EXPECT_EQ(map.walls(), (std::vector<std::string>{"fish", "tower"}));
  EXPECT_EQ(map.places(), 2);
  EXPECT_EQ(map.nodes()[0].object, "pine cone");
  EXPECT_EQ(map.hallway(0, 180)->floor, "moss");
  EXPECT_EQ(map.hallway(0, 0), nullptr);
}

TEST(ReadMap, FaultsAreReportedWhereTheyStand) {
  const std::pair<const char*, const char*> table[] = {
      {R"([])", "expected an object with \"name\", \"nodes\" and \"edges\"\n  m.json:1:1"},
      {R"({"nodes": []})", "the key \"edges\" is missing\n  m.json:1:1"},
      {R"({"nodes": [], "edges": []})", "nodes: a map needs at least one node\n  m.json:1:11"},
      {R"({"nodes": 7, "edges": []})", "nodes: expected a list\n  m.json:1:11"},
      {"{\"nodes\": [{\"x\": 0, \"y\": 0},\n {\"x\": 1.5, \"y\": 0}], \"edges\": []}",
       "nodes[1].x: expected a whole number\n  m.json:2:8"},
      {"{\"nodes\": [{\"x\": 0, \"y\": 99999999999999999999999}], \"edges\": []}",
       "nodes[0].y: expected a whole number\n  m.json:1:26"},
      {"{\"nodes\": [{\"x\": 0, \"y\": 18446744073709551615}], \"edges\": []}",
       "nodes[0].y: the number is too large\n  m.json:1:26"},
      {R"({"nodes": [{"x": 0}], "edges": []})", "nodes[0]: the key \"y\" is missing\n  m.json:1:12"},
      {R"({"nodes": [{"x": 0, "y": 0, "objet": "chair"}], "edges": []})",
       "nodes[0]: unknown key \"objet\" (did you mean \"object\"?)\n  m.json:1:12"},
      {R"({"nodes": [{"x": 0, "y": 0, "object": 3}], "edges": []})", "nodes[0].object: expected a text\n  m.json:1:39"},
      {R"({"nodes": [{"x": 0, "y": 0}, {"x": 0, "y": 0}], "edges": []})",
       "nodes[1]: there is already a node at (0,0)\n  m.json:1:30"},
      {R"({"nodes": [{"x": 0, "y": 0}], "edges": [{"a": [0,0], "b": [0,1]}]})",
       "edges[0].b: there is no node at (0,1)\n  m.json:1:59"},
      {R"({"nodes": [{"x": 0, "y": 0}, {"x": 0, "y": 2}], "edges": [{"a": [0,0], "b": [0,2]}]})",
       "edges[0]: (0,0) and (0,2) are not orthogonal neighbours at distance 1\n  m.json:1:59"},
      {R"({"objects": ["sofa"], "nodes": [{"x": 0, "y": 0, "object": "chair"}], "edges": []})",
       "nodes[0].object: \"chair\" is not among \"objects\"\n  m.json:1:60"},
      {R"({"headings": {"0": [0,1]}, "nodes": [{"x": 0, "y": 0}], "edges": []})",
       "headings: must be {\"0\": [0,-1], \"90\": [1,0], \"180\": [0,1], \"270\": [-1,0]}: y grows "
       "downwards\n  m.json:1:14"},
      {R"({"objects": ["tee"], "nodes": [{"x": 0, "y": 0}], "edges": []})",
       "two observables would share the proposition 'tee'\n  m.json:1:1"},
  };
  for (const auto& [json, expected] : table) EXPECT_EQ(message_of(json), expected) << json;
}

TEST(ReadMap, SyntaxErrorsHaveLineAndColumn) {
  const std::string message = message_of("{\"nodes\": [\n  {\"x\": 1,, }]}");
  EXPECT_TRUE(message.starts_with("malformed JSON: ")) << message;
  EXPECT_TRUE(message.ends_with("m.json:2:11")) << message;
  EXPECT_EQ(message_of("{\"nodes\": 1e999}"), "a number of the JSON text is out of range\n  m.json");
  EXPECT_NE(message_of(""), "accepted");
  EXPECT_NE(message_of(std::string(100'000, '[')), "accepted");
  EXPECT_NE(message_of(std::string(50'000, '[') + std::string(50'000, ']')), "accepted");
}

TEST(ReadMap, NotesOfTheAuthorAreLeftAlone) {
  EXPECT_EQ(message_of(R"({"survey": {"year": 2006}, "nodes": [{"x": 0, "y": 0, "colour": "red"}], "edges": []})"),
            "accepted");
}

TEST(ReadMap, UnknownNamesListTheKnownOnes) {
  try {
    read_map("grd", data_directory());
    FAIL() << "accepted";
  } catch (const ltl::FormatError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("did you mean 'grid'?"), std::string::npos) << what;
    EXPECT_NE(what.find("grid, jelly, l"), std::string::npos) << what;
  }
  EXPECT_THROW(read_map(".", data_directory()), ltl::FormatError);
  EXPECT_EQ(read_map((data_directory() / "maps" / "l.json").string(), "nowhere").name(), "l");
}

using Facts = std::tuple<std::string, std::multiset<std::string>, std::multiset<std::string>>;

Facts facts(const Map& map) {
  std::multiset<std::string> nodes, edges;
  const auto place = [&](std::uint32_t n) {
    return std::to_string(map.nodes()[n].x) + "," + std::to_string(map.nodes()[n].y);
  };
  for (std::uint32_t n = 0; n < map.nodes().size(); ++n)
    nodes.insert(place(n) + " " + map.nodes()[n].object.value_or("-") + " " +
                 std::to_string(map.nodes()[n].place.value_or(0)));
  for (const Edge& edge : map.edges()) {
    const std::string a = place(edge.a), b = place(edge.b);
    edges.insert(std::min(a, b) + " " + std::max(a, b) + " " + edge.floor + " " + edge.wall);
  }
  return {map.name(), nodes, edges};
}

TEST(ReadMap, TheShippedMapsHoldTheFactsOfTheCorpus) {
  const char* shared = std::getenv("WAYMARK_SHARED");
  const std::filesystem::path sail = (shared != nullptr ? std::filesystem::path(shared)
                                                        : std::filesystem::path(WAYMARK_SOURCE_DIR) / ".." / "shared") /
                                     "sail" / "maps";
  if (!std::filesystem::exists(sail))
    GTEST_SKIP() << "the SAIL maps are not at " << sail << "; set WAYMARK_SHARED to the folder that holds sail/";
  for (const char* name : {"grid", "jelly", "l"}) {
    const Map ours = shipped(name), theirs = read_map((sail / (std::string(name) + ".json")).string(), "");
    EXPECT_EQ(facts(ours), facts(theirs)) << name;
    EXPECT_EQ(ours.vocabulary(), theirs.vocabulary()) << name;
  }
}

TEST(ReadMap, TheShippedMapsAreAsLargeAsPublished) {
  const std::tuple<const char*, std::size_t, std::size_t> table[] = {
      {"grid", 28, 40}, {"jelly", 38, 41}, {"l", 34, 40}};
  for (const auto& [name, nodes, edges] : table) {
    EXPECT_EQ(shipped(name).nodes().size(), nodes) << name;
    EXPECT_EQ(shipped(name).edges().size(), edges) << name;
  }
}

// Every prefix of a map, and every map with one byte changed, is read or refused with a FormatError.
TEST(ReadMap, DamagedFilesAreRefusedNotCrashed) {
  std::ifstream in(data_directory() / "maps" / "grid.json");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  ASSERT_GT(text.size(), 1'000U);
  std::size_t refused = 0;
  const auto attempt = [&](const std::string& damaged) {
    try {
      parse_map(damaged);
    } catch (const ltl::FormatError&) {
      ++refused;
    }
  };
  for (std::size_t n = 0; n < text.size() - 2; n += 7) {
    attempt(text.substr(0, n));
    for (char c : {'"', '{', ']', '-', '9', '\xff', '\0'}) {
      std::string damaged = text;
      damaged[n] = c;
      attempt(damaged);
    }
  }
  EXPECT_GT(refused, text.size() / 7);
}

}  // namespace
}  // namespace waymark::plan
