#include "libparser/domain/commands/mention_scores.hpp"

#include <gtest/gtest.h>

namespace waymark::parser {
namespace {

// A command whose marks stand in brackets: "[A:the hatch is open]", "[!A:it's shut]".
Command marked(const std::string& text, std::map<std::string, std::string> things) {
  Command out;
  out.domain = "tests";
  out.things = std::move(things);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '[') {
      out.text += text[i];
      continue;
    }
    const bool negated = text[i + 1] == '!';
    const std::size_t key = i + (negated ? 2 : 1), end = text.find(']', i);
    const std::string words = text.substr(key + 2, end - key - 2);
    out.mentions.push_back({out.text.size(), out.text.size() + words.size(), text.substr(key, 1), negated});
    out.text += words;
    i = end;
  }
  return out;
}

const std::map<std::string, std::string> things{{"A", "the hatch is open"}, {"B", "the fan runs"}};
using Names = std::vector<std::string>;

TEST(MentionScores, MarksNameThingsInTheOrderOfTheText) {
  const NamedThings named =
      marked_things(marked("if [B:the fan runs], [!A:shut the hatch]; no [B:running fan]", things));
  EXPECT_EQ(named.slots, (Names{"b", "a"}));
  EXPECT_EQ(named.negated, (Names{"a", "b"}));
  EXPECT_EQ(named.sequence, (Names{"b", "!a", "!b"}));
}

TEST(MentionScores, TwoNegationsCancel) {
  EXPECT_EQ(marked_things(marked("[!A:the hatch is shut], and not [!A:the shut hatch]", things)).negated, (Names{"a"}));
  EXPECT_TRUE(marked_things(marked("[!A:the hatch is shut], [!A:closed]", things)).negated.empty());
}

TEST(MentionScores, TheLiftOfTheMarksHasSlotsForThem) {
  const CommandDomain::Lift lift = marked_lift(marked("if [B:the fan runs], then [!A:the hatch is shut] .", things));
  EXPECT_EQ(lift.text.tokens, (Names{"if", "#1", ",", "then", "not", "#2", "."}));
  EXPECT_EQ(lift.slots, (Names{"b", "a"}));
  EXPECT_EQ(found_things(lift), marked_things(marked("[B:the fan runs] [!A:the hatch is shut]", things)));
}

TEST(MentionScores, CountsWhatIsFound) {
  const std::vector<Command> commands{marked("keep [A:the hatch is open] until [B:the fan runs]", things),
                                      marked("until [B:the fan runs], [A:whatever happens]", things),
                                      marked("never [B:a running fan], never", things)};
  const MentionScores scores = score_mentions(commands, {});
  EXPECT_EQ(scores.commands, 3U);
  EXPECT_EQ(scores.named, 2U);
  EXPECT_EQ(scores.stated, 2U);
  EXPECT_EQ(scores.exact, 2U);
  EXPECT_EQ(scores.lifted, 2U);
  const std::vector<std::string> others{"the lamp is on", "the fan runs"};
  EXPECT_EQ(score_mentions(commands, {}, others).named, 2U);
}

}  // namespace
}  // namespace waymark::parser
