#include "tests/house/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace waymark::house {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> read_lines(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// CMake text without comments, as words; parentheses are words of their own.
std::vector<std::string> cmake_words(const fs::path& path) {
  std::vector<std::string> words;
  for (std::string line : read_lines(path)) {
    line = line.substr(0, line.find('#'));
    line = std::regex_replace(line, std::regex("[()]"), " $& ");
    std::istringstream in(line);
    for (std::string word; in >> word;) words.push_back(word);
  }
  return words;
}

// The arguments of every call of `command`, one list a call.
std::vector<std::vector<std::string>> cmake_calls(const fs::path& path, std::string_view command) {
  std::vector<std::vector<std::string>> calls;
  const std::vector<std::string> words = cmake_words(path);
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] != command || words[i + 1] != "(") continue;
    const auto end = std::find(words.begin() + static_cast<std::ptrdiff_t>(i), words.end(), ")");
    calls.emplace_back(words.begin() + static_cast<std::ptrdiff_t>(i + 2), end);
  }
  return calls;
}

// Appends what folder/CMakeLists.txt lists, and what the folders it adds list, in that order.
void read_lists(const std::string& folder, Library& library) {
  const fs::path path = root() / folder / "CMakeLists.txt";
  for (const char* command : {"waymark_library", "add_library", "add_executable"})
    for (const auto& arguments : cmake_calls(path, command))
      for (const std::string& word : arguments) {
        if (word.ends_with(".cpp") || word.ends_with(".hpp")) library.sources.push_back(folder + "/" + word);
        if (word.starts_with("waymark::"))
          library.below.insert("lib" + word.substr(std::string_view("waymark::").size()));
      }
  for (const auto& arguments : cmake_calls(path, "add_subdirectory"))
    read_lists(folder + "/" + arguments.at(0), library);
}

}  // namespace

const fs::path& root() {
  static const fs::path path = WAYMARK_SOURCE_DIR;
  return path;
}

std::vector<SourceFile> files(std::string_view extensions) {
  std::set<std::string> wanted;
  std::istringstream in{std::string(extensions)};
  for (std::string extension; in >> extension;) wanted.insert("." + extension);
  std::vector<SourceFile> out;
  for (auto entry = fs::recursive_directory_iterator(root()); entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (name.starts_with(".") || name.starts_with("build"))) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && wanted.contains(entry->path().extension().string())) {
      out.push_back({fs::relative(entry->path(), root()).generic_string(), read_lines(entry->path())});
    }
  }
  std::sort(out.begin(), out.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return out;
}

std::vector<Include> includes(const SourceFile& file) {
  static const std::regex pattern("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
  std::vector<Include> out;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    std::smatch match;
    if (std::regex_match(file.lines[i], match, pattern)) out.push_back({match[2], match[1] == "\"", i + 1});
  }
  return out;
}

std::vector<Library> libraries() {
  std::vector<Library> out;
  for (const auto& arguments : cmake_calls(root() / "CMakeLists.txt", "add_subdirectory")) {
    if (arguments.empty() || !arguments[0].starts_with("lib")) continue;
    Library library{arguments[0], {}, {}};
    read_lists(arguments[0], library);
    for (const Library& earlier : out)
      if (library.below.contains(earlier.folder)) library.below.insert(earlier.below.begin(), earlier.below.end());
    out.push_back(std::move(library));
  }
  return out;
}

Library tools() {
  Library library{"tools", {}, {}};
  read_lists("tools", library);
  return library;
}

std::optional<std::size_t> Library::position(std::string_view path) const {
  const auto find = [&](const std::string& name) { return std::find(sources.begin(), sources.end(), name); };
  auto at = find(std::string(path));
  if (at == sources.end() && path.ends_with(".hpp")) at = find(std::string(path.substr(0, path.size() - 4)) + ".cpp");
  if (at == sources.end()) at = find(std::string(path.substr(0, path.rfind('/'))) + "/*.cpp");
  if (at == sources.end()) return std::nullopt;
  return static_cast<std::size_t>(at - sources.begin());
}

std::string folder_of(std::string_view path) { return std::string(path.substr(0, path.find('/'))); }

}  // namespace waymark::house
