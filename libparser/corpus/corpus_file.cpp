#include "libparser/corpus/corpus_file.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {

std::string read_corpus_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  if (in && in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();  // of an empty file, << fails
  if (!in || !bytes) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  return std::move(bytes).str();
}

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
