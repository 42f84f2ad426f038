#include "libparser/language/synchronous_grammar.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

class Written {
 public:
  explicit Written(const std::string& text)
      : file_(std::filesystem::temp_directory_path() / ("waymark_grammar_" + std::to_string(getpid()))) {
    std::ofstream(file_) << text;
  }
  ~Written() { std::filesystem::remove(file_); }
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
  SynchronousGrammar grammar() const { return SynchronousGrammar(file_); }

 private:
  std::filesystem::path file_;
};

std::string joined(const std::vector<std::string>& tokens) {
  std::string text;
  for (const std::string& token : tokens) text += (text.empty() ? "" : " ") + token;
  return text;
}

TEST(SynchronousGrammars, SayATextAndWhatItDenotesAtOnce) {
  const Written written(
      "# a comment\n$go = walk to\n@GOAL\n$go <N> => eventually 1\n@TWO\n"
      "after <N> , <GOAL> and back to <#1> => sequence 1 2 1 end\n");
  ltl::Random random(1);
  const auto said = written.grammar().say("TWO", random);
  EXPECT_EQ(joined(said.tokens), "after #1 , walk to #2 and back to #1");
  EXPECT_EQ(print(said.lifted), "sequence #1 eventually #2 #1 end");
  EXPECT_EQ(said.slots, 2U);
}

// Slots count in the order in which a text names them, whatever the order in the formula.
TEST(SynchronousGrammars, NumberSlotsByFirstMention) {
  const Written written("@A\n<N> only after <N> => ordered 2 1 end\n");
  ltl::Random random(1);
  const auto said = written.grammar().say("A", random);
  EXPECT_EQ(joined(said.tokens) + " = " + print(said.lifted), "#1 only after #2 = ordered #2 #1 end");
}

TEST(SynchronousGrammars, DrawByWeightAndFromAlternatives) {
  const Written written("@A\n1: (a|b) <N> => eventually 1\n9: c <N> => eventually 1\n");
  const SynchronousGrammar grammar = written.grammar();
  ltl::Random random(1);
  std::map<std::string, int> said;
  for (int i = 0; i < 4000; ++i) ++said[grammar.say("A", random).tokens.front()];
  EXPECT_NEAR(said["a"], 200, 60);
  EXPECT_NEAR(said["b"], 200, 60);
  EXPECT_NEAR(said["c"], 3600, 90);
}

TEST(SynchronousGrammars, ErrorsNameTheLine) {
  const auto refused = [](const std::string& text, const std::string& line, const std::string& why) {
    try {
      Written(text).grammar();
      ADD_FAILURE() << "accepted: " << text;
    } catch (const ltl::FormatError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(why), std::string::npos) << message;
      EXPECT_NE(message.find(":" + line), std::string::npos) << message;
    }
  };
  refused("\ngo to <N> => eventually 1\n", "2", "no rule");
  refused("@A\ngo to <N>\n", "2", "no rule");
  refused("$go walk\n", "1", "'='");
  refused("@A\n$go <N> => eventually 1\n", "2", "$go");
  refused("$a = x $b\n$b = y\n", "1", "$b");
  refused("$a = x <#1>\n@A\n$a <N> => eventually 1\n", "1", "no category");
  refused("@A\n<B> => 1\n", "2", "'B'");
  refused("@A\n<N => eventually #1\n", "2", "''");
  refused("@A\n<N> => eventually 2\n", "2", "'2' refers");
  refused("@A\n<N> <#2> => eventually 1\n", "2", "'2' refers");
  refused("@A\n<N> => perhaps 1\n", "2", "'perhaps'");
  refused("@A\n(a|b <N> => eventually 1\n", "2", "not closed");
  refused("@A\na) <N> => eventually 1\n", "2", "not opened");
  refused("@A\n.: <N> => eventually 1\n", "2", "weight");
  refused("@A\n@B\n<N> => eventually 1\n", "1", "has no rule");
  refused("@A\n<B> => 1\n@B\n<A> => 1\n<N> => 1\n", "1", "leads back");
  EXPECT_THROW(SynchronousGrammar("/no/such/file"), ltl::FormatError);
}

TEST(SynchronousGrammars, AWordThatAnAlternativeIsJoinedToIsRefused) {
  const SynchronousGrammar grammar = Written("$a = x\n@A\n($a|$a)c <N> => eventually 1\n").grammar();
  ltl::Random random(1);
  EXPECT_THROW((void)grammar.say("A", random), ltl::FormatError);
}

// Of the shipped grammar, whatever is said can be read: in its scope, and to be spelled as it is denoted.
TEST(SynchronousGrammars, WhatTheShippedOneSaysIsAllowed) {
  const SynchronousGrammar grammar(WAYMARK_SOURCE_DIR "/data/language/commands.grammar");
  ltl::Random random(1);
  for (const char* category : {"COMMAND", "COMMAND", "COMMAND", "COMMAND", "INSTRUCTION", "CHATTER"})
    for (int i = 0; i < 8000; ++i) {
      const auto said = grammar.say(category, random);
      LiftedPrefix prefix;
      for (const LiftedSymbol s : said.lifted) {
        ASSERT_TRUE(prefix.allows(s, {.slots = said.slots, .constants = 0, .spatial = true}))
            << joined(said.tokens) << " = " << print(said.lifted) << " at " << name(s);
        prefix.append(s);
      }
      ASSERT_TRUE(prefix.ended()) << print(said.lifted);
      const auto named = static_cast<std::size_t>(std::count_if(
          said.tokens.begin(), said.tokens.end(), [](const std::string& t) { return t.size() > 1 && t[0] == '#'; }));
      ASSERT_GE(named, said.slots);
    }
}

}  // namespace
}  // namespace waymark::parser
