// Commands with marks: their lifted texts and formulas, and the texts of data/language/wordings, nearly all of which
// must give an example to learn from.
#include "libparser/domain/commands/marked_commands.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

std::vector<Command> wordings() {
  std::vector<Command> all;
  for (const auto& entry : std::filesystem::directory_iterator(WAYMARK_SOURCE_DIR "/data/language/wordings"))
    if (entry.path().extension() == ".jsonl")
      for (Command& command : read_commands(entry.path())) all.push_back(std::move(command));
  return all;
}

// Marks and formulas are those of the writers: what cannot be spelled are floors and walls by names that are no names,
// and more visits than there are symbols for.
TEST(MarkedCommands, AllWordingsButAFewAreExamples) {
  const MarkedCommands marked(shipped_maps().front().vocabulary());
  std::map<std::string, std::pair<std::size_t, std::size_t>> by_domain;  // texts, left out
  std::string left_out;
  for (const Command& command : wordings()) {
    auto& [n, out] = by_domain[command.domain];
    ++n;
    if (marked.example(command)) continue;
    ++out;
    left_out += command.id + ": " + command.text + "  " + command.formula + "\n";
  }
  EXPECT_EQ(by_domain.size(), 6U);
  for (const auto& [domain, counts] : by_domain) EXPECT_LE(counts.second * 100, counts.first) << domain << left_out;
}

Command command_of(const char* domain, const std::string& text, std::map<std::string, std::string> things,
                   std::vector<MarkedMention> mentions, const std::string& formula) {
  Command out;
  out.domain = domain, out.text = text, out.formula = formula, out.marked = true;
  out.things = std::move(things), out.mentions = std::move(mentions);
  return out;
}

std::string tokens(const LiftedText& text) {
  std::string out;
  for (const std::string& token : text.tokens) out += (out.empty() ? "" : " ") + token;
  return out;
}

TEST(MarkedCommands, WordsOfTheOppositeBecomeNotAndTheSlot) {
  const MarkedCommands marked(shipped_maps().front().vocabulary());
  const Command command = command_of("system", "Ring once the door is shut, unless it rains.",
                                     {{"A", "the door is open"}, {"E", "it rains"}},
                                     {{10, 26, "A", true}, {35, 43, "E", false}}, "G(!a & !e -> F a)");
  const auto example = marked.example(command);
  ASSERT_TRUE(example);
  EXPECT_EQ(tokens(example->text), "ring once not #1 , unless #2 .");
}

TEST(MarkedCommands, FloorsThatNobodyMarkedAreFoundInHallways) {
  const MarkedCommands marked(shipped_maps().front().vocabulary());
  const Command command = command_of("hallway", "Walk to the couch, but only on brick.", {{"A", "the sofa"}},
                                     {{8, 17, "A", false}}, "F sofa & G(moved -> behind_brick)");
  const auto example = marked.example(command);
  ASSERT_TRUE(example);
  EXPECT_EQ(tokens(example->text), "walk to #1 , but only on #2 .");
  EXPECT_EQ(print(example->lifted), "and eventually #1 stayon #2 end");
}

}  // namespace
}  // namespace waymark::parser
