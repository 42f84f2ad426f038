// Files written whole, and what is left of a process that is killed while it writes.
#include "libparser/model/whole_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace waymark::parser {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) out.push_back(entry.path().filename().string());
  return out;
}

TEST(WholeFile, ReplacesWhatWasThereAndKeepsModeAndLink) {
  const TemporaryFolder folder("whole-file-test-");
  const fs::path file = folder.path() / "file", link = folder.path() / "link";
  write_file(file, "old");
  EXPECT_EQ(fs::status(file).permissions() & fs::perms::owner_all, fs::perms::owner_read | fs::perms::owner_write);
  fs::permissions(file, fs::perms::owner_all);
  fs::create_symlink("file", link);
  write_file(link, "new");
  EXPECT_EQ(read(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_all);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(names_in(folder.path()).size(), 2U);
}

TEST(WholeFile, OfAProcessKilledWhileItWritesIsOldOrNewAndNothingElseIsLeft) {
  const TemporaryFolder folder("whole-file-test-");
  const int probe = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (probe < 0) GTEST_SKIP() << "no files without a name here";
  ::close(probe);
  const fs::path file = folder.path() / "file";
  const std::string old(1 << 20, 'o'), fresh(32 << 20, 'n');
  for (int kills = 0; kills < 10; ++kills) {
    write_file(file, old);
    const pid_t child = ::fork();
    if (child == 0) {
      write_file(file, fresh);
      ::_exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(kills));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string now = read(file);
    EXPECT_TRUE(now == old || now == fresh) << now.size();
    EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"file"});
  }
}

TEST(TemporaryFolder, GoesWithItsObjectOrWithAllThatIsUnfinished) {
  fs::path gone;
  {
    const TemporaryFolder folder("whole-file-test-");
    gone = folder.path();
    write_file(gone / "inside", "x");
  }
  EXPECT_FALSE(fs::exists(gone));
  const TemporaryFolder discarded("whole-file-test-");
  write_file(discarded.path() / "inside", "x");
  discard_unfinished_files();
  EXPECT_FALSE(fs::exists(discarded.path()));
}

}  // namespace
}  // namespace waymark::parser
