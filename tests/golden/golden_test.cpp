// Transcripts of the command line: command, what it printed (both streams), exit code. A transcript is a text file of
//
//   $ waymark translate 'F a' --format stats
//   1	2	3	1	1	SECONDS	ok	1
//   [exit 0]
//
// run by sh in this folder, with seconds replaced by a word. To write them anew after a change that was meant:
// WAYMARK_GOLDEN=write build/<preset>/bin/test_golden, then read the diff.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path folder = WAYMARK_GOLDEN_FOLDER;

std::vector<fs::path> transcripts() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".transcript") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// What differs from run to run, by name.
std::string without_seconds(std::string text) {
  static const std::array<std::pair<std::regex, std::string>, 4> rules{{
      {std::regex(R"("seconds":\{[^}]*\})"), R"("seconds":{SECONDS})"},
      {std::regex(R"("seconds":[0-9.e+-]+)"), R"("seconds":SECONDS)"},
      {std::regex(R"((\n|^)time  .*)"), "$1time SECONDS"},
      {std::regex(R"(\t([01]|-)\t[0-9]+\.[0-9]+\t)"), "\t$1\tSECONDS\t"},
  }};
  for (const auto& [pattern, word] : rules) text = std::regex_replace(text, pattern, word);
  return text;
}

std::string run(const std::string& command) {
  const std::string line = "cd '" + folder.string() + "' && ( " + command + " ) 2>&1 </dev/null";
  FILE* pipe = ::popen(line.c_str(), "r");
  if (pipe == nullptr) return "cannot start sh\n";
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), got);
  const int status = ::pclose(pipe);
  if (!output.empty() && output.back() != '\n') output += '\n';
  return without_seconds(output) + "[exit " + std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : -1) +
         "]\n";
}

// The transcript as it would be written now: same commands, same comments, fresh answers.
std::string rerun(const std::string& transcript) {
  std::istringstream in(transcript);
  std::string out, line;
  while (std::getline(in, line)) {
    if (line.starts_with("$ "))
      out += line + '\n' + run(line.substr(2));
    else if (line.starts_with("# "))
      out += line + '\n';
  }
  return out;
}

class Transcript : public testing::TestWithParam<fs::path> {};

TEST_P(Transcript, IsWhatTheCommandLinePrints) {
  ::setenv("PATH", (std::string(WAYMARK_BIN) + ":" + std::getenv("PATH")).c_str(), 1);
  ::unsetenv("WAYMARK_DATA");
  std::ifstream file(GetParam());
  const std::string expected{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  ASSERT_NE(expected.find("$ "), std::string::npos) << "a transcript without a command";
  const std::string now = rerun(expected);
  const char* mode = std::getenv("WAYMARK_GOLDEN");
  if (mode != nullptr && std::string(mode) == "write")
    std::ofstream(GetParam()) << now;
  else
    EXPECT_EQ(now, expected);
}

INSTANTIATE_TEST_SUITE_P(Golden, Transcript, testing::ValuesIn(transcripts()), [](const auto& parameter) {
  std::string name = parameter.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
