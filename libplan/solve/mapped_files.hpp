// Memory in files: for arrays of values that do not fit into that of the machine.
//
// Each large array is a file without a name in a folder, mapped. The system keeps the pages in memory that were used
// last, and writes others back; what is swept in an order, such as the window of a grid, is read and written about once
// a sweep. The room is reserved at once, so that a full disk is found out before the work and not in it.
#pragma once
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory_resource>
#include <new>
#include <string>
#include <utility>

namespace waymark::plan {

class MappedFiles : public std::pmr::memory_resource {
 public:
  class Full : public std::bad_alloc {  // the folder cannot hold an array
   public:
    explicit Full(std::string why) : why_(std::move(why)) {}
    const char* what() const noexcept override { return why_.c_str(); }  // names folder, size and reason

   private:
    std::string why_;
  };

  // What has fewer bytes than `smallest` stays in memory.
  explicit MappedFiles(std::filesystem::path folder, std::size_t smallest = std::size_t{1} << 20U)
      : folder_(std::move(folder)), smallest_(smallest) {}
  std::size_t most() const { return most_; }  // bytes in files at one time

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override;  // throws Full
  void do_deallocate(void* at, std::size_t bytes, std::size_t alignment) override;
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

  std::filesystem::path folder_;
  std::size_t smallest_;
  std::atomic<std::size_t> mapped_{0}, most_{0};  // bytes
};

}  // namespace waymark::plan
