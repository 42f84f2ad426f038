// The source tree as the house tests see it: its files, their lines, the libraries as CMake lists them.
#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::house {

struct SourceFile {
  std::string path;  // from the root, "libltl/word.hpp"
  std::vector<std::string> lines;
};

struct Include {
  std::string path;  // what stands between the quotes or brackets
  bool quoted;       // "…" rather than <…>
  std::size_t line;  // 1-based
};

struct Library {
  std::string folder;                // "libltl"
  std::vector<std::string> sources;  // from the root, in the order of its CMakeLists.txt
  std::set<std::string> below;       // folders of the libraries it may include, transitively
  // Where the file stands in the list: by its own name, for a header by that of the source beside it, or by the
  // pattern of its room.
  std::optional<std::size_t> position(std::string_view path) const;
};

const std::filesystem::path& root();                         // of the source tree
std::vector<SourceFile> files(std::string_view extensions);  // "hpp cpp md", every such file of the project, sorted
std::vector<Include> includes(const SourceFile& file);
std::vector<Library> libraries();              // in the order of the root CMakeLists.txt
Library tools();                               // the command line, read the same way
std::string folder_of(std::string_view path);  // "libltl" of "libltl/word.hpp"

}  // namespace waymark::house
