// Arrays in files: what they hold, and what a folder cannot hold. (No number depends on them: pipelined_passes_test.)
#include "libplan/solve/mapped_files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
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

TEST(MappedFiles, CountWhatIsInFilesAtOneTime) {
  const Folder folder;
  MappedFiles files(folder.path()), others(folder.path());
  constexpr std::size_t mebibyte = std::size_t{1} << 20U;
  EXPECT_EQ(files.most(), 0U);
  for (int i = 0; i < 3; ++i) files.deallocate(files.allocate(mebibyte), mebibyte);
  EXPECT_EQ(files.most(), mebibyte);
  void* one = files.allocate(2 * mebibyte);
  files.deallocate(files.allocate(mebibyte), mebibyte);
  files.deallocate(one, 2 * mebibyte);
  EXPECT_EQ(files.most(), 3 * mebibyte);
  EXPECT_TRUE(files.is_equal(files));
  EXPECT_FALSE(files.is_equal(others)) << "what one has mapped another one would not count";
}

// The number that a file gets which is opened now: the least that is free.
int next_descriptor() {
  const int number = ::dup(STDERR_FILENO);
  ::close(number);
  return number;
}

// A mapped file needs no descriptor, whatever its number was: 0 where a process has no standard input.
TEST(MappedFiles, LeaveNoDescriptorOpen) {
  const Folder folder;
  MappedFiles files(folder.path());
  constexpr std::size_t mebibyte = std::size_t{1} << 20U;
  const int input = ::dup(STDIN_FILENO), before = next_descriptor();
  ::close(STDIN_FILENO);
  EXPECT_EQ(next_descriptor(), STDIN_FILENO);
  void* at = nullptr;
  EXPECT_NO_THROW(at = files.allocate(mebibyte));
  EXPECT_EQ(next_descriptor(), STDIN_FILENO);
  if (at != nullptr) files.deallocate(at, mebibyte);
  if (input >= 0) {
    ::dup2(input, STDIN_FILENO);
    EXPECT_EQ(next_descriptor(), before);
    files.deallocate(files.allocate(mebibyte), mebibyte);
    EXPECT_EQ(next_descriptor(), before);
    ::close(input);
  }
}

// From here on files without a name are refused to this process, as by file systems that know none. False: it cannot be
// told to.
bool refuse_files_without_names() {
  constexpr auto unnamed = static_cast<std::uint32_t>(O_TMPFILE & ~O_DIRECTORY);
  std::array<sock_filter, 6> filter{
      sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_openat, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[2])),
      BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, unnamed, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EOPNOTSUPP),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

// Then a file loses its name at once, also the one of descriptor 0.
TEST(MappedFiles, HaveNoNameWhereverTheyAre) {
  const Folder folder;
  const auto allocate = [&] {
    if (!refuse_files_without_names()) std::_Exit(0);  // it cannot be tried here
    if (::open(folder.path().c_str(), O_TMPFILE | O_RDWR, 0600) >= 0) std::_Exit(3);
    ::close(STDIN_FILENO);
    MappedFiles files(folder.path());
    std::pmr::vector<double> numbers(300'000, 1, &files), more(300'000, 2, &files);
    const bool holds = numbers.back() == 1 && more.front() == 2 && std::filesystem::is_empty(folder.path());
    std::_Exit(holds && next_descriptor() == STDIN_FILENO ? 0 : 1);
  };
  EXPECT_EXIT(allocate(), ::testing::ExitedWithCode(0), "");
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
