// What the command line prints with --json obeys the schemas in data/schemas/cli, one for each subcommand: all answers
// of the transcripts are checked, and those of the commands below, which no transcript can hold because they have
// times or probabilities; answers with a key too many are refused.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/studio/schemas.hpp"

namespace waymark::studio {
namespace {

using nlohmann::json;

struct Printed {
  std::string subcommand, transcript;
  json answer;
};

// The subcommand whose answers a command prints as they are, if there is one.
std::string subcommand_of(const std::string& command) {
  static const std::regex filtered(R"(\| *(sed|head|cut|grep|tail))");
  static const std::regex as_json(R"(waymark ([a-z-]+)[^|;&]*(--json|--to json|--format json))");
  if (std::regex_search(command, filtered)) return "";
  std::string last;
  for (std::sregex_iterator at(command.begin(), command.end(), as_json), end; at != end; ++at) last = (*at)[1];
  return last;
}

std::vector<Printed> answers_of_transcripts() {
  std::vector<Printed> out;
  for (const auto& entry : std::filesystem::directory_iterator(WAYMARK_DATA_FOLDER "/../tests/golden")) {
    if (entry.path().extension() != ".transcript") continue;
    std::ifstream in(entry.path());
    std::string subcommand;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("$ ")) subcommand = subcommand_of(line);
      if (subcommand.empty() || !line.starts_with("{\"")) continue;
      line = std::regex_replace(line, std::regex(R"("seconds":SECONDS)"), R"("seconds":0)");
      line = std::regex_replace(line, std::regex(R"(\{SECONDS\})"), "{}");
      json answer = json::parse(line, nullptr, false);
      if (!answer.is_discarded()) out.push_back({subcommand, entry.path().filename(), std::move(answer)});
    }
  }
  return out;
}

std::vector<Printed> answers_of_commands() {
  const char* commands[] = {
      "run 'go to the sofa' 'keep coming back to the lamp' 'go to the piano' 'purple monkey' --start 1,9,0 --json",
      "run --demo --json",
      "ground 'turn left and walk to the chair' 'purple monkey' --map grid --json",
      "ground 'go to the sofa' --map grid --json --explain",
      "plan 'F desk' --map home.json --start 0,0,90 --slip 0.1,0.1 --json",
      "plan --case yard.json --json",
      "plan --case yard.json --task go --method pi --json",
      "plan 'G F desk' --map home.json --semantics infinite --json",
      "compose --case yard.json --task go --json",
      "compose --map home.json --model-only --json",
      "compare 'F desk' 'F kitchen' --map home.json --seeds 2 --steps 200 --json",
      "translate 'G F a' --to ldba --json",
      "translate 'F a & F b & F c' --to dfa --limit-edges 3 --json",
      "explain 'F chair & G !blue' 'false' 'a U' --json",
      "monitor 'a U b' 'G F a' --letters letters.txt --semantics finite --json",
      "patterns --list --json",
      "random --count 2 --json",
      "random --automata --json",
      "version --json",
  };
  std::vector<Printed> out;
  for (const std::string command : commands) {
    const std::string line = "cd '" WAYMARK_DATA_FOLDER "/../tests/golden' && { test -f " WAYMARK_SCRATCH
                             "/letters.txt || printf 'a\\nb\\n' >" WAYMARK_SCRATCH "/letters.txt; " WAYMARK_EXECUTABLE
                             " " +
                             std::regex_replace(command, std::regex("letters.txt"), WAYMARK_SCRATCH "/letters.txt") +
                             "; } 2>/dev/null </dev/null";
    FILE* pipe = ::popen(line.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), got);
    ::pclose(pipe);
    std::istringstream lines(text);
    std::size_t printed = 0;
    for (std::string answer; std::getline(lines, answer); ++printed) {
      json document = json::parse(answer, nullptr, false);
      EXPECT_FALSE(document.is_discarded()) << command << ": " << answer;
      out.push_back({command.substr(0, command.find(' ')), command, std::move(document)});
    }
    EXPECT_GT(printed, 0U) << command;
  }
  return out;
}

std::vector<Printed> all_answers() {
  std::vector<Printed> all = answers_of_transcripts();
  for (Printed& printed : answers_of_commands()) all.push_back(std::move(printed));
  return all;
}

TEST(CommandLineSchemas, AllAnswersObeyThem) {
  const std::vector<Printed> all = all_answers();
  std::set<std::string> subcommands;
  for (const Printed& printed : all) {
    subcommands.insert(printed.subcommand);
    EXPECT_EQ(fault("cli/" + printed.subcommand, printed.answer), "")
        << printed.transcript << ": " << printed.answer.dump().substr(0, 300);
  }
  EXPECT_GE(all.size(), 120U);
  EXPECT_GE(subcommands.size(), 16U);
}

TEST(CommandLineSchemas, RefuseOtherAnswers) {
  for (const Printed& printed : all_answers()) {
    json more = printed.answer;
    more["no such key"] = 1;
    EXPECT_NE(fault("cli/" + printed.subcommand, more), "") << printed.subcommand;
  }
  EXPECT_NE(fault("cli/monitor", {{"letters", 1}, {"formula", "a"}}), "");
  EXPECT_NE(fault("cli/explain", {{"formula", 3}}), "");
}

}  // namespace
}  // namespace waymark::studio
