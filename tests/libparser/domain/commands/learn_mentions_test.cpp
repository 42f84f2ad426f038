#include "libparser/domain/commands/learn_mentions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace waymark::parser {
namespace {

CommandDomains towns() {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "waymark-learn-mentions";
  std::filesystem::create_directories(folder / "maps");
  std::ofstream(folder / "domains.json") << R"({"yard":{"propositions":{"pond":""}}})";
  std::ofstream(folder / "maps" / "town.json") << R"({"landmarks":[
    {"prop":"plum","name":"Plum Garden","tags":{"amenity":"restaurant","cuisine":"thai"}},
    {"prop":"walk","name":"Garden Walk","tags":{"highway":"bus_stop"}},
    {"prop":"books","name":"Heron Books","tags":{"shop":"books"}}]})";
  return {folder / "domains.json", folder / "maps"};
}

Command said(const std::string& text, std::vector<std::string> propositions, bool suspect = false) {
  Command command;
  command.domain = "osm:town";
  command.source = "tests";
  command.text = text;
  command.propositions = std::move(propositions);
  command.suspect = suspect;
  return command;
}

std::vector<std::string> named(CommandDomains& domains, const MentionVector& weights, const std::string& text) {
  return domains.of("osm:town").lift(text, {weights, std::make_shared<const Synonyms>()}).front().slots;
}

TEST(LearnMentions, LearnsWhatCountsFromWhatFormulasName) {
  CommandDomains domains = towns();
  // By hand, "garden" alone is no mention in a text that goes on with another word of the place.
  const std::vector<Command> commands{said("stroll in the garden", {}), said("rest in the garden for a while", {}),
                                      said("see the garden", {}), said("go to the thai restaurant", {"plum"}),
                                      said("visit the bookshop heron books", {"books"})};
  const LearnedMentions learned = learn_mentions(commands, domains, Synonyms(), {.epochs = 200, .penalty = 0});
  EXPECT_EQ(learned.commands, 5U);
  EXPECT_EQ(learned.unexplained, 0U);
  const std::vector<std::string> none;
  EXPECT_NE(named(domains, mention_weights_by_hand(), "look at the garden"), none);
  EXPECT_EQ(named(domains, learned.weights, "look at the garden"), none);
  EXPECT_EQ(named(domains, learned.weights, "look for the thai restaurant"), std::vector<std::string>{"plum"});
}

TEST(LearnMentions, LeavesOutDoubtsOtherDomainsAndWhatNoCoverExplains) {
  CommandDomains domains = towns();
  Command yard = said("go to the pond", {"pond"});
  yard.domain = "yard";
  const LearnedMentions none =
      learn_mentions(std::vector{yard, said("go to the garden", {"walk"}, true)}, domains, Synonyms());
  EXPECT_EQ(none.commands, 0U);
  EXPECT_EQ(none.weights, mention_weights_by_hand());
  const LearnedMentions one = learn_mentions(std::vector{said("go to the pier", {"walk"})}, domains, Synonyms());
  EXPECT_EQ(one.commands, 0U);
  EXPECT_EQ(one.unexplained, 1U);
}

// Marks tell where a thing is named; what else looks like it is no mention.
TEST(LearnMentions, LearnsFromMarks) {
  CommandDomains domains = towns();
  const auto marked = [](const std::string& text, const std::string& words) {
    Command command = said(text, {});
    command.domain = "anything";
    command.marked = true;
    command.things = {{"A", "the lamp is on"}};
    if (!words.empty()) command.mentions = {{text.find(words), text.find(words) + words.size(), "A", false}};
    return command;
  };
  std::vector<Command> commands;
  for (int i = 0; i < 30; ++i) commands.push_back(marked("dust the lamp while the lamp is on", "the lamp is on"));
  const auto found = [&](const MentionVector& weights) {
    const CommandDomain domain = CommandDomain::of_things(commands.front());
    const auto lift =
        domain.lift("buy a lamp if the lamp is on", {weights, std::make_shared<const Synonyms>()}).front();
    return std::count(lift.text.tokens.begin(), lift.text.tokens.end(), "#1");
  };
  const LearnedMentions learned = learn_mentions(commands, domains, Synonyms(), {.epochs = 60, .penalty = 0});
  EXPECT_EQ(learned.marked, 30U);
  EXPECT_EQ(learned.commands, 30U);
  EXPECT_EQ(found(mention_weights_by_hand()), 2);
  EXPECT_EQ(found(learned.weights), 1);
}

TEST(LearnMentions, ASeedFixesTheWeights) {
  CommandDomains domains = towns();
  const std::vector<Command> commands{said("see the garden", {}), said("go to heron books", {"books"})};
  EXPECT_EQ(learn_mentions(commands, domains, Synonyms()).weights,
            learn_mentions(commands, domains, Synonyms()).weights);
}

}  // namespace
}  // namespace waymark::parser
