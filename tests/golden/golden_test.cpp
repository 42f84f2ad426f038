// Transcripts of the command line: command, what it printed (both streams), exit code. A transcript is a text file of
//
//   $ waymark translate 'F a' --format stats
//   1	2	3	1	1	SECONDS	ok	1
//   [exit 0]
//
// run by sh in this transcript_folder, with seconds replaced by a word. To write them anew after a change that was
// meant: WAYMARK_GOLDEN=write build/<preset>/bin/test_golden, then read the diff.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "tests/golden/replay.hpp"

namespace waymark::golden {
namespace {

namespace fs = std::filesystem;

const fs::path transcript_folder = WAYMARK_GOLDEN_FOLDER;

std::vector<fs::path> transcripts() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(transcript_folder))
    if (entry.path().extension() == ".transcript") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The transcript as it would be written now: same commands, same comments, fresh answers.
std::string rerun(const std::string& transcript) {
  std::istringstream in(transcript);
  std::string out;
  bool in_answer = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("[exit ")) in_answer = false;
    if (in_answer) continue;
    if (line.starts_with("$ ")) {
      in_answer = true;
      const CommandResult answer = run(line.substr(2), transcript_folder);
      out += line + '\n' + answer.output + "[exit " + std::to_string(answer.exit) + "]\n";
    } else if (line.starts_with("# ")) {
      out += line + '\n';
    }
  }
  return out;
}

class Transcript : public ::testing::TestWithParam<fs::path> {};

TEST_P(Transcript, IsWhatTheCommandLinePrints) {
  const std::string expected = read(GetParam());
  ASSERT_NE(expected.find("$ "), std::string::npos) << "a transcript without a command";
  compare(GetParam(), expected, rerun(expected));
}

INSTANTIATE_TEST_SUITE_P(Golden, Transcript, ::testing::ValuesIn(transcripts()), [](const auto& parameter) {
  std::string name = parameter.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace waymark::golden
