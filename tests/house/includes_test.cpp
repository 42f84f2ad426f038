// Who may include whom: downwards between libraries, and inside one only what stands before in its CMake list.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "tests/house/source_tree.hpp"

namespace waymark::house {
namespace {

std::string at(const SourceFile& file, const Include& include) {
  return file.path + ":" + std::to_string(include.line) + " includes " + include.path;
}

bool is_library_file(const SourceFile& file) { return file.path.starts_with("lib"); }

TEST(Includes, AreWrittenFromTheRootAndExist) {
  for (const SourceFile& file : files("hpp cpp"))
    for (const Include& include : includes(file)) {
      const bool ours = std::filesystem::is_regular_file(root() / include.path);
      EXPECT_EQ(ours, include.quoted) << at(file, include)
                                      << ": quotes are for our own files, named from the root; brackets for others'";
    }
}

TEST(Includes, PointDownwardsBetweenLibraries) {
  std::size_t edges = 0;
  for (const Library& library : libraries())
    for (const SourceFile& file : files("hpp cpp")) {
      if (folder_of(file.path) != library.folder) continue;
      for (const Include& include : includes(file)) {
        if (!include.quoted || folder_of(include.path) == library.folder) continue;
        ++edges;
        EXPECT_TRUE(library.below.contains(folder_of(include.path)))
            << at(file, include) << ", but " << library.folder << " stands on " << testing::PrintToString(library.below)
            << " only (DEPENDS in its CMakeLists.txt)";
      }
    }
  EXPECT_GT(edges, 0U) << "no include between libraries was read";
}

TEST(Includes, LibrariesStandOnEarlierOnesOnly) {
  std::set<std::string> earlier;
  for (const Library& library : libraries()) {
    for (const std::string& below : library.below)
      EXPECT_TRUE(earlier.contains(below))
          << library.folder << " depends on " << below << ", which stands later or nowhere";
    earlier.insert(library.folder);
  }
  EXPECT_TRUE(earlier.contains("libltl"));
}

TEST(Includes, FollowTheOrderOfTheList) {
  std::vector<Library> listed = libraries();
  listed.push_back(tools());
  for (const Library& library : listed)
    for (const SourceFile& file : files("hpp cpp")) {
      if (folder_of(file.path) != library.folder) continue;
      const auto here = library.position(file.path);
      EXPECT_TRUE(here) << file.path << " is not listed in " << library.folder
                        << "/CMakeLists.txt (a header without a source is listed itself)";
      for (const Include& include : includes(file)) {
        if (!include.quoted || folder_of(include.path) != library.folder || !here) continue;
        const auto there = library.position(include.path);
        EXPECT_TRUE(there && *there <= *here)
            << at(file, include) << ", which does not stand before it in " << library.folder << "/CMakeLists.txt";
      }
    }
}

using Edges = std::map<std::string, std::map<std::string, std::string>>;  // from → to → an include that makes it

// What `name_of` names is one node. Repeatedly removes the nodes that include no node left; what then remains stands on
// a circle.
void expect_no_circle(const std::function<std::string(const std::filesystem::path&)>& name_of) {
  Edges edges;
  for (const SourceFile& file : files("hpp cpp")) {
    if (folder_of(file.path) == "tests") continue;
    for (const Include& include : includes(file)) {
      const std::string from = name_of(file.path), to = name_of(include.path);
      if (include.quoted && from != to) edges[from].try_emplace(to, at(file, include));
    }
  }
  EXPECT_GT(edges.size(), 10U) << "no include was read";
  for (bool removed = true; removed;) {
    removed = false;
    for (auto node = edges.begin(); node != edges.end();) {
      std::erase_if(node->second, [&](const auto& edge) { return !edges.contains(edge.first); });
      removed = removed || node->second.empty();
      node = node->second.empty() ? edges.erase(node) : std::next(node);
    }
  }
  for (const auto& [from, targets] : edges)
    for (const auto& [to, example] : targets) ADD_FAILURE() << from << " and " << to << ": " << example;
}

TEST(Includes, RoomsDoNotIncludeEachOtherInACircle) {
  expect_no_circle([](const auto& path) { return path.parent_path().generic_string(); });
}

// A header and the source of its name are one, unless the header is listed by itself.
TEST(Includes, FilesDoNotIncludeEachOtherInACircle) {
  std::set<std::string> listed;
  for (const Library& library : libraries()) listed.insert(library.sources.begin(), library.sources.end());
  expect_no_circle([&](const auto& path) {
    const std::string name = path.generic_string();
    return name.ends_with(".hpp") && listed.contains(name) ? name : name.substr(0, name.rfind('.'));
  });
}

// The Python module draws what the tools draw.
TEST(Includes, NobodyIncludesToolsOrTests) {
  for (const SourceFile& file : files("hpp cpp"))
    for (const Include& include : includes(file)) {
      const std::string from = folder_of(file.path), to = folder_of(include.path);
      if (!include.quoted || from == to) continue;
      EXPECT_NE(to, "tests") << at(file, include);
      if (from != "tests" && from != "python") {
        EXPECT_NE(to, "tools") << at(file, include);
      }
      EXPECT_NE(to, "python") << at(file, include);
    }
}

// Heavy headers stay behind walls: never in a header of a library, and in as few sources as possible.
struct Heavy {
  const char* name;
  std::regex header;
  std::size_t sources;  // at most, in libraries and tools together
};

std::vector<Heavy> heavy_headers() {
  return {
      {"OMPL", std::regex("ompl/.*"), 2},
      {"Graphviz", std::regex("(graphviz/)?(gvc|cgraph)\\.h"), 1},
      {"CLI11", std::regex("CLI/.*"), 3},
      {"an HTTP server", std::regex("(.*/)?httplib\\.h"), 1},
      {"a Boost.Graph algorithm", std::regex("boost/graph/.*(search|shortest|first|astar|components|visitors).*"), 3}};
}

TEST(Includes, HeavyHeadersStayBehindWalls) {
  for (const Heavy& heavy : heavy_headers()) {
    std::vector<std::string> sources;
    for (const SourceFile& file : files("hpp cpp"))
      for (const Include& include : includes(file)) {
        if (include.quoted || folder_of(file.path) == "tests" || !std::regex_match(include.path, heavy.header))
          continue;
        EXPECT_FALSE(is_library_file(file) && file.path.ends_with(".hpp")) << at(file, include) << ": " << heavy.name;
        if (sources.empty() || sources.back() != file.path) sources.push_back(file.path);
      }
    EXPECT_LE(sources.size(), heavy.sources) << heavy.name << " in " << testing::PrintToString(sources);
  }
}

// One header is for the sources of readers only: no other header includes it, and it is not installed.
TEST(Includes, JsonAndTheCommandLineParserStayOutOfLibraryHeaders) {
  const std::regex header("nlohmann/.*|CLI/.*");
  const std::string of_readers = "libplan/world/json_reader.hpp";
  for (const SourceFile& file : files("hpp"))
    for (const Include& include : includes(file)) {
      EXPECT_NE(include.path, of_readers) << at(file, include);
      if (file.path == of_readers) continue;
      EXPECT_FALSE(is_library_file(file) && std::regex_match(include.path, header)) << at(file, include);
    }
}

TEST(Includes, LibltlNeedsTheStandardLibraryOnly) {
  for (const SourceFile& file : files("hpp cpp"))
    for (const Include& include : includes(file))
      if (folder_of(file.path) == "libltl" && !include.quoted) {
        EXPECT_EQ(include.path.find_first_of("/."), std::string::npos) << at(file, include);
      }
}

}  // namespace
}  // namespace waymark::house
