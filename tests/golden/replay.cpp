#include "tests/golden/replay.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <utility>

namespace waymark::golden {
namespace {

std::string without_seconds(std::string text) {
  static const std::array<std::pair<std::regex, std::string>, 6> rules{{
      {std::regex(R"("seconds":\{[^}]*\})"), R"("seconds":{SECONDS})"},
      {std::regex(R"("seconds":[0-9.e+-]+)"), R"("seconds":SECONDS)"},
      {std::regex(R"((\n|^)time  .*)"), "$1time SECONDS"},
      {std::regex(R"(\t([01]|-)\t[0-9]+\.[0-9]+\t)"), "\t$1\tSECONDS\t"},
      {std::regex(R"([0-9]+ bytes, [0-9.]+ s:)"), "SIZE bytes, SECONDS:"},
      {std::regex(R"(sampled in .*)"), "sampled in SECONDS"},
  }};
  for (const auto& [pattern, word] : rules) text = std::regex_replace(text, pattern, word);
  return text;
}

}  // namespace

CommandResult run(const std::string& command, const std::filesystem::path& folder) {
  ::setenv("PATH", (std::string(WAYMARK_BIN) + ":" + std::getenv("PATH")).c_str(), 1);
  ::unsetenv("WAYMARK_DATA");
  const std::string line = "cd '" + folder.string() + "' && { " + command + "\n} 2>&1 </dev/null";
  FILE* pipe = ::popen(line.c_str(), "r");
  if (pipe == nullptr) return {"cannot start sh\n"};
  CommandResult out;
  std::array<char, 4096> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
    out.output.append(buffer.data(), got);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) out.exit = WEXITSTATUS(status);
  if (!out.output.empty() && out.output.back() != '\n') out.output += '\n';
  out.output = without_seconds(std::move(out.output));
  return out;
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void compare(const std::filesystem::path& file, const std::string& expected, const std::string& now) {
  const char* mode = std::getenv("WAYMARK_GOLDEN");
  if (mode != nullptr && std::string(mode) == "write")
    std::ofstream(file) << now;
  else
    EXPECT_EQ(now, expected);
}

}  // namespace waymark::golden
