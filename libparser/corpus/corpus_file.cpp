#include "libparser/corpus/corpus_file.hpp"

#include <algorithm>

#include "libltl/text/read_text.hpp"

namespace waymark::parser {

std::string read_corpus_file(const std::filesystem::path& file) { return ltl::read_text(file); }

std::vector<std::filesystem::path> map_files(const std::filesystem::path& corpus) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(corpus / "maps"))
    for (const auto& entry : std::filesystem::directory_iterator(corpus / "maps"))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  return hash;
}

}  // namespace waymark::parser
