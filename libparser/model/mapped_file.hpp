// The bytes of a file, read-only and where the kernel keeps them: a mapping, not a copy.
//
// A file that cannot be mapped (a pipe) is read into memory instead, and bytes that are in memory already are copied.
// In all three cases the first byte is aligned to eight. A file must not be cut short in place while it is mapped;
// waymark replaces files by renaming.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace waymark::parser {

class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& file);  // throws ltl::FormatError when it cannot be read
  explicit MappedFile(std::string_view bytes);             // a copy in memory
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }  // valid as long as the object

 private:
  void copy(std::string_view bytes);

  std::string_view bytes_;
  void* mapping_ = nullptr;
  std::vector<std::uint64_t> copy_;
};

}  // namespace waymark::parser
