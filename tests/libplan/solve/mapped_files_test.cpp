// Arrays in files: what they hold, and what a folder cannot hold. (No number depends on them: pipelined_passes_test.)
#include "libplan/solve/mapped_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

namespace waymark::plan {
namespace {

class Folder {
 public:
  Folder() : path_(std::filesystem::path(::testing::TempDir()) / ("waymark_mapped_" + std::to_string(::getpid()))) {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST(MappedFiles, HoldWhatIsWritten) {
  const Folder folder;
  MappedFiles files(folder.path());
  constexpr std::size_t many = 300'000;
  std::pmr::vector<double> numbers(many, 0, &files), few(10, 0, &files);
  EXPECT_EQ(files.most(), many * sizeof(double));
  std::iota(numbers.begin(), numbers.end(), 0);
  std::iota(few.begin(), few.end(), 0);
  numbers.resize(2 * many, -1);
  EXPECT_EQ(files.most(), 3 * many * sizeof(double));
  for (std::size_t i = 0; i < many; ++i) ASSERT_EQ(numbers[i], static_cast<double>(i));
  EXPECT_EQ(numbers.back(), -1);
  EXPECT_EQ(few.back(), 9);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "the files have names";
}

TEST(MappedFiles, SayWhatAFolderCannotHold) {
  const Folder folder;
  MappedFiles files(folder.path()), nowhere(folder.path() / "none");
  const auto message = [](MappedFiles& in, std::size_t bytes) {
    try {
      in.deallocate(in.allocate(bytes), bytes);
    } catch (const MappedFiles::Full& full) {
      return std::string(full.what());
    }
    return std::string("none");
  };
  constexpr std::size_t mebibyte = std::size_t{1} << 20U, too_many = std::size_t{1} << 58U;
  EXPECT_EQ(message(files, mebibyte), "none");
  EXPECT_NE(message(files, too_many).find("no file of 288230376151711744 bytes in " + folder.path().string()),
            std::string::npos)
      << message(files, too_many);
  EXPECT_NE(message(nowhere, mebibyte).find("No such file or directory"), std::string::npos);
}

}  // namespace
}  // namespace waymark::plan
