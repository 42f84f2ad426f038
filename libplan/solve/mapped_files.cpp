#include "libplan/solve/mapped_files.hpp"

#include <fcntl.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkostemp
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace waymark::plan {
namespace {

class File {  // open, and already without a name
 public:
  explicit File(const std::filesystem::path& folder) {
#ifdef O_TMPFILE
    number_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
#endif
    if (number_ >= 0) return;
    std::string name = (folder / ".waymark.XXXXXX").string();
    number_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (number_ >= 0) ::unlink(name.c_str());
  }
  ~File() {
    if (number_ >= 0) ::close(number_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int number() const { return number_; }

 private:
  int number_ = -1;
};

[[noreturn]] void fail(const std::filesystem::path& folder, std::size_t bytes, int error) {
  throw MappedFiles::Full("no file of " + std::to_string(bytes) + " bytes in " + folder.string() + ": " +
                          std::generic_category().message(error));
}

}  // namespace

void* MappedFiles::do_allocate(std::size_t bytes, std::size_t alignment) {
  if (bytes < smallest_) return std::pmr::new_delete_resource()->allocate(bytes, alignment);
  const File file(folder_);
  if (file.number() < 0) fail(folder_, bytes, errno);
  if (const int error = ::posix_fallocate(file.number(), 0, static_cast<off_t>(bytes)); error != 0)
    fail(folder_, bytes, error);
  void* at = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), 0);
  if (at == MAP_FAILED) fail(folder_, bytes, errno);
  const std::size_t now = mapped_ += bytes;
  for (std::size_t most = most_; most < now && !most_.compare_exchange_weak(most, now);) {
  }
  return at;
}

void MappedFiles::do_deallocate(void* at, std::size_t bytes, std::size_t alignment) {
  if (bytes < smallest_) return std::pmr::new_delete_resource()->deallocate(at, bytes, alignment);
  ::munmap(at, bytes);
  mapped_ -= bytes;
}

}  // namespace waymark::plan
