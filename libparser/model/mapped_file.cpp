#include "libparser/model/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>

#include "libltl/text/read_text.hpp"

namespace waymark::parser {

MappedFile::MappedFile(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor >= 0 && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const mapping = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor, 0);
    if (mapping != MAP_FAILED) {
      mapping_ = mapping;
      bytes_ = {static_cast<const char*>(mapping), size};
    }
  }
  if (descriptor >= 0) close(descriptor);
  if (mapping_ != nullptr) return;
  constexpr std::size_t most = std::size_t{1} << 28U;  // of a pipe or a device, which may never end
  copy(ltl::read_text(file, most));
}

MappedFile::MappedFile(std::string_view bytes) { copy(bytes); }

MappedFile::~MappedFile() {
  if (mapping_ != nullptr) munmap(mapping_, bytes_.size());
}

void MappedFile::copy(std::string_view bytes) {
  copy_.resize((bytes.size() + 7) / 8);
  if (!bytes.empty()) std::memcpy(copy_.data(), bytes.data(), bytes.size());
  bytes_ = {reinterpret_cast<const char*>(copy_.data()), bytes.size()};
}

}  // namespace waymark::parser
