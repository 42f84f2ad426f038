#include "libparser/domain/commands/command_domain.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

// A folder of files that is gone after the test.
class Folder {
 public:
  Folder() { std::filesystem::create_directories(path_ / "maps"); }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator()(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("waymark_commands_" + std::to_string(getpid()));
};

TEST(Commands, AreReadLineByLine) {
  const Folder folder;
  const auto all = read_commands(folder(
      "c.jsonl", R"({"id":"1","domain":"yard","type":"visit","n":1,"text":"see the oak","formula":"F oak","count":3,)"
                 R"("propositions":["oak"],"landmarks":{"oak":"the oak"}})"
                 "\n\n"
                 R"({"id":"2","domain":"yard","text":"x","formula":"a","suspect":"why","landmarks":{"a":null}})"));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].formula, "F oak");
  EXPECT_EQ(all[0].count, 3U);
  EXPECT_EQ(all[0].landmarks.at("oak"), "the oak");
  EXPECT_EQ(all[1].type, "free");
  EXPECT_TRUE(all[1].suspect);
  EXPECT_FALSE(all[1].landmarks.at("a"));
}

TEST(Commands, ErrorsNameTheLine) {
  const Folder folder;
  const auto message = [&](const std::string& text) {
    try {
      read_commands(folder("c.jsonl", text));
    } catch (const ltl::FormatError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("\n{\"id\":\"1\"}\n").find(":2"), std::string::npos);
  EXPECT_NE(message("no json\n").find(":1"), std::string::npos);
  EXPECT_THROW(read_commands(folder.path() / "none"), ltl::FormatError);
}

TEST(Commands, AFoldIsTheFirstColumnBelowAHeader) {
  const Folder folder;
  EXPECT_EQ(read_fold(folder("f.tsv", "id\tfold\na\t1\n\nb\t2\n")), (std::vector<std::string>{"a", "b"}));
}

TEST(CommandDomains, AreFoundByNameAndCitiesByTheirMaps) {
  const Folder folder;
  const auto file = folder("domains.json", R"({"yard":{"propositions":{"oak_tree":"","pond":""}}})");
  folder("maps/town.json", R"({"landmarks":[{"prop":"inn","name":"The Inn","tags":{"cuisine":"thai"}}]})");
  folder("maps/bad.json", R"({"landmarks":[{"name":"no proposition"}]})");
  CommandDomains domains(file, folder.path() / "maps");
  EXPECT_EQ(domains.of("yard").lift("go to the pond and the oak tree").front().slots,
            (std::vector<std::string>{"pond", "oak_tree"}));
  EXPECT_EQ(domains.of("osm:town").lift("go to the inn").front().slots, (std::vector<std::string>{"inn"}));
  for (const char* name : {"garden", "osm:nowhere", "osm:bad", "osm:../maps/town"})
    EXPECT_THROW(domains.of(name), ltl::FormatError) << name;
  EXPECT_THROW(CommandDomains(folder("d.json", R"({"yard":{}})"), folder.path()), ltl::FormatError);
}

TEST(CommandDomains, ASlotOfASmallDomainIsFollowedByItsName) {
  const CommandDomain rooms = CommandDomain::small("rooms", {"blue_room", "green_room", "chair_in_blue_room"});
  const auto lift = rooms.lift("push the chair into the blue room").front();
  EXPECT_EQ(lift.text.tokens, (std::vector<std::string>{"push", "the", "chair", "into", "#1", "blue", "room"}));
  EXPECT_EQ(lift.slots, (std::vector<std::string>{"blue_room"}));
}

TEST(CommandDomains, LabelsAreSpelledOverTheSlotsOfTheText) {
  const CommandDomain letters = CommandDomain::with_letters("lifted");
  const auto lift = letters.lift("go to b and after that to a").front();
  EXPECT_EQ(lift.slots, (std::vector<std::string>{"b", "a"}));
  const auto label = letters.label(lift, "F (b & F a)");
  ASSERT_TRUE(label);
  EXPECT_EQ(print(*label), "sequence #1 #2 end");
  ltl::Arena arena(ltl::Vocabulary({"a", "b"}));
  const auto f = formula_of(*label, letters.bindings(arena, lift.slots));
  ASSERT_TRUE(f);
  EXPECT_FALSE(letters.label(lift, "F c"));
}

}  // namespace
}  // namespace waymark::parser
