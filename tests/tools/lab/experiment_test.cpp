// An experiment that is killed, not asked to stop, goes on where it was and ends with the same bytes.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "libparser/language/generate.hpp"
#include "libplan/world/read_map.hpp"
#include "tests/support/sanitizers.hpp"
#include "tools/shell/json.hpp"

namespace {

namespace fs = std::filesystem;
using waymark::tools::JsonArray, waymark::tools::JsonObject;

using waymark::testing::sanitized;

// Some paragraphs of our own on the maps that come with waymark.
void write_corpus(const fs::path& directory) {
  std::vector<waymark::plan::Map> maps;
  for (const char* name : {"grid", "jelly", "l"}) maps.push_back(waymark::plan::read_map(name, WAYMARK_DATA_FOLDER));
  const auto corpus = waymark::parser::generate_corpus(
      maps, {.seed = 3, .paragraphs = sanitized ? 3 : 6, .sentences = sanitized ? 1 : 2});
  std::ofstream out(directory / "instructions.jsonl");
  for (const auto& paragraph : corpus.paragraphs) {
    JsonArray sentences;
    for (const auto& sentence : paragraph.sentences) {
      JsonArray tokens, path;
      for (const auto& token : sentence.tokens) tokens.add(token);
      for (const auto& pose : sentence.absolute) path.add(JsonArray().add(pose.x).add(pose.y).add(pose.heading));
      sentences.add(
          JsonObject().add("id", sentence.id).add("text", sentence.text).add("tokens", tokens).add("path", path));
    }
    out << JsonObject()
               .add("id", paragraph.id)
               .add("map", paragraph.map)
               .add("text", paragraph.text)
               .add("sentences", sentences)
               .text()
        << '\n';
  }
}

pid_t start(const fs::path& corpus, const fs::path& checkpoints, const fs::path& output) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::dup2(::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
  ::execl(WAYMARK_EXECUTABLE, WAYMARK_EXECUTABLE, "experiment", "table4", "--corpus", corpus.c_str(), "--checkpoints",
          checkpoints.c_str(), "--ensemble", "2", "--epochs", "1", "--convention", "relative", "--json", nullptr);
  ::_exit(127);
}

int wait_for(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// Without the unfinished file that a killed write leaves behind.
std::size_t files_in(const fs::path& directory) {
  if (!fs::exists(directory)) return 0;
  return static_cast<std::size_t>(std::count_if(fs::directory_iterator(directory), {}, [](const auto& entry) {
    return entry.path().filename().string().rfind(".waymark.", 0) != 0;
  }));
}

std::string contents(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Experiment, KilledAgainAndAgainEndsWithTheSameBytes) {
  std::string name = (fs::temp_directory_path() / "waymark-experiment-XXXXXX").string();
  const fs::path directory = ::mkdtemp(name.data());
  write_corpus(directory);
  ASSERT_EQ(wait_for(start(directory, directory / "whole", directory / "whole.json")), 0);
  const std::size_t parts = files_in(directory / "whole");
  ASSERT_GT(parts, 30U);
  for (std::size_t kill_at = 3; kill_at < parts; kill_at += sanitized ? 26 : 13) {
    const pid_t child = start(directory, directory / "killed", directory / "killed.json");
    int status = 0;
    bool runs = true;
    while (runs && files_in(directory / "killed") < kill_at) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      runs = ::waitpid(child, &status, WNOHANG) == 0;
    }
    ASSERT_TRUE(runs);
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
  }
  ASSERT_EQ(wait_for(start(directory, directory / "killed", directory / "killed.json")), 0);
  EXPECT_EQ(contents(directory / "whole.json"), contents(directory / "killed.json"));
  EXPECT_EQ(parts, files_in(directory / "killed"));
  fs::remove_all(directory);
}

}  // namespace
