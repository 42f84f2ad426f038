// Files are written whole or not at all.
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>
#include <csignal>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "libltl/diagnostic.hpp"
#include "libltl/watch.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 public:
  Files() {
    std::string name = (fs::temp_directory_path() / "waymark-files-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Files() override { fs::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

 protected:
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(Files, AreCreatedReplacedAndLeaveNothingBehind) {
  const fs::path file = folder_ / "a.txt";
  write_file(file, "first");
  write_file(file, std::string(200'000, 'x'));
  EXPECT_EQ(read_file(file.string()), std::string(200'000, 'x'));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, HaveTheModeThatAnOrdinaryFileGets) {
  std::ofstream(folder_ / "ordinary") << "x";
  write_file(folder_ / "ours", "x");
  EXPECT_EQ(fs::status(folder_ / "ours").permissions(), fs::status(folder_ / "ordinary").permissions());
}

TEST_F(Files, KeepTheModeOfWhatTheyReplace) {
  write_file(folder_ / "script", "old");
  fs::permissions(folder_ / "script", fs::perms::owner_all);
  write_file(folder_ / "script", "new");
  EXPECT_EQ(fs::status(folder_ / "script").permissions(), fs::perms::owner_all);
}

TEST_F(Files, AreMadeWhereALinkPoints) {
  fs::create_symlink("later", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file((folder_ / "later").string()), "new");
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THROW(write_file(folder_ / "loop", "x"), ltl::FormatError);
}

TEST_F(Files, MayHaveLongNames) {
  const fs::path file = folder_ / std::string(255, 'n');
  write_file(file, "x");
  EXPECT_EQ(read_file(file.string()), "x");
}

TEST_F(Files, ReplaceWhatASymbolicLinkNames) {
  write_file(folder_ / "target", "old");
  fs::create_symlink("target", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file((folder_ / "target").string()), "new");
}

TEST_F(Files, AreNotTouchedWhenWritingFails) {
  EXPECT_THROW(write_file(folder_ / "no" / "such" / "folder.txt", "x"), ltl::FormatError);
  EXPECT_THROW(write_file(folder_, "x"), ltl::FormatError);
  EXPECT_EQ(entries(), 0U);
}

TEST_F(Files, LetDevicesBe) {
  write_file("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, ThatCannotBeReadSayWhy) {
  try {
    read_file((folder_ / "absent").string());
    FAIL() << "an absent file was read";
  } catch (const ltl::FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
  EXPECT_THROW(read_file(folder_.string()), ltl::FormatError);
}

TEST(Process, TalksBothWaysWithoutWaitingForItself) {
  const std::string text(3'000'000, 'y');  // far more than a pipe holds
  const Finished finished = run_helper("/bin/cat", {}, text);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.output, text);
}

TEST(Process, EndsAHelperWhenAsked) {
  const ltl::Watch watch({.seconds = 0.1}, {});
  EXPECT_THROW(run_helper("/bin/sh", {"-c", "exec sleep 1000"}, "", watch.token()), HelperStopped);
  EXPECT_THROW(run_helper("/bin/sh", {"-c", "exec sleep 1000"}, std::string(1'000'000, 'y'), watch.token()),
               HelperStopped);
}

// Ctrl-C reaches all processes of a terminal: helpers are ours to end.
TEST(Process, KeepsCtrlCFromHelpersOnly) {
  const std::vector<std::string> interrupted{"-c", "kill -INT $$; kill -TERM $$; echo still here"};
  EXPECT_EQ(run_helper("/bin/sh", interrupted, "").output, "still here\n");
  EXPECT_EQ(run_program("/bin/sh", interrupted, "").exit_code, 128 + SIGINT);
}

TEST(Process, SurvivesAHelperThatDoesNotRead) {
  const Finished finished = run_helper("/bin/sh", {"-c", "exit 3"}, std::string(1'000'000, 'y'));
  EXPECT_EQ(finished.exit_code, 3);
}

}  // namespace
}  // namespace waymark::tools
