#include "libparser/domain/commands/landmark.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "libltl/diagnostic.hpp"
#include "libparser/domain/commands/command.hpp"

namespace waymark::parser {
namespace {

std::filesystem::path written(const std::string& text) {
  std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "landmark_test.json";
  std::ofstream(file) << text;
  return file;
}

TEST(ReadPropositions, APropositionHasANameTagsAndADescription) {
  const auto all = read_propositions(written(R"({"propositions": {
    "charger": {}, "depot": "where parcels are stored",
    "lab_2": {"name": "wet lab", "other_names": ["chemistry"],
              "tags": {"floor": "green"}, "description": "smells"}}})"));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].name, "charger");
  EXPECT_TRUE(all[0].tags.empty());
  EXPECT_EQ(all[1].proposition, "depot");
  EXPECT_EQ(all[1].name, "depot");
  EXPECT_EQ(all[1].tags.at(description_tag), "where parcels are stored");
  EXPECT_EQ(all[2].name, "wet lab");
  EXPECT_EQ(all[2].other_names, (std::vector<std::string>{"chemistry"}));
  EXPECT_EQ(all[2].tags.at("floor"), "green");
  EXPECT_EQ(all[2].tags.at(description_tag), "smells");
}

TEST(ReadPropositions, WithoutANameAPropositionIsCalledAsItReads) {
  EXPECT_EQ(read_propositions(written(R"({"propositions": {"wet_lab_2": {}}})")).front().name, "wet lab 2");
}

TEST(ReadPropositions, AListOfNamesMeansNames) {
  const auto all = read_propositions(written(R"({"propositions": ["request", "wet_lab_2"]})"));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].proposition, "request");
  EXPECT_EQ(all[1].proposition, "wet_lab_2");
  EXPECT_EQ(all[1].name, "wet lab 2");
}

template <typename Read>
std::string refusal(const Read& read, const std::string& text) {
  try {
    (void)read(written(text));
  } catch (const ltl::FormatError& error) {
    return error.what();
  }
  return "it was read";
}

// The key, what was expected there, and the line: never the words of the library that reads JSON.
TEST(Landmarks, WrongShapesNameKeyTypeAndLine) {
  const struct {
    bool propositions;
    const char *text, *says, *line;
  } table[] = {
      {true, "{}", "the key \"propositions\" is missing", ":1:1"},
      {true, "[]", "expected an object", ":1:1"},
      {true, "{\n\"propositions\": 3}", "propositions: expected a list of names, or an object of names", ":2:17"},
      {true, "{\"propositions\":\n{\"a\": 3}}", "propositions.a: expected a description, or an object", ":2:7"},
      {true, "{\"propositions\": [\"a\",\n 1]}", "propositions[1]: expected a text", ":2:2"},
      {true, "{\"propositions\": {\"a\": {\"name\": []}}}", "propositions.a.name: expected a text", ":1:33"},
      {true, "{\"propositions\": {\"a\": {\"tags\": 1}}}", "propositions.a.tags: expected an object", ":1:33"},
      {true, "{\"propositions\"", "malformed JSON", ":1:"},
      {true, "<?xml version=\"1.0\"?><osm/>", "expected JSON: this is an XML document", ":1:1"},
      {false, "{}", "the key \"landmarks\" is missing", ":1:1"},
      {false, "{\"landmarks\": {}}", "landmarks: expected a list", ":1:15"},
      {false, "{\"landmarks\": [3]}", "landmarks[0]: expected an object", ":1:16"},
      {false, "{\"landmarks\": [{\"prop\": 1}]}", "landmarks[0].prop: expected a text", ":1:25"},
      {false, "{\"landmarks\": [{\"prop\": \"\"}]}", "the name of a proposition is empty", ":1:16"},
      {false, "{\"landmarks\": [{\"prop\": \"a\", \"other_names\": \"b\"}]}", "other_names: expected a list of texts",
       ":1:45"},
      {true, "{\"propositions\": {\"a\\u0000b\": {}}}", "has a control character", ":1:"},
      {false, "{\"landmarks\": [{\"prop\": \"\\u001b\"}]}", "expected a text without control characters", ":1:25"},
      {false, "{\"landmarks\": [1e999]}", "a number of the JSON text is out of range", ""},
  };
  for (const auto& row : table) {
    const std::string message =
        row.propositions ? refusal(read_propositions, row.text) : refusal(read_landmarks, row.text);
    EXPECT_NE(message.find(row.says), std::string::npos) << row.text << ": " << message;
    EXPECT_NE(message.find(row.line), std::string::npos) << row.text << ": " << message;
    EXPECT_EQ(message.find("json.exception"), std::string::npos) << message;
  }
}

TEST(Commands, WrongShapesNameKeyTypeAndLine) {
  const char* good = "{\"id\":\"1\",\"domain\":\"d\",\"text\":\"t\"";
  const struct {
    const char *more, *says;
  } table[] = {{"", "it was read"},
               {",\"n\":-1", "n: expected a number that is not negative"},
               {",\"n\":\"two\"", "n: expected a whole number"},
               {",\"lifted\":1", "lifted: expected true or false"},
               {",\"formula\":[]", "formula: expected a text"},
               {",\"propositions\":{}", "propositions: expected a list of texts"},
               {",\"landmarks\":[]", "landmarks: expected an object"},
               {",\"landmarks\":{\"a\":1}", "landmarks.a: expected a text"}};
  for (const auto& row : table) {
    const std::string message = refusal(read_commands, "\n" + std::string(good) + row.more + "}\n");
    EXPECT_NE(message.find(row.says), std::string::npos) << row.more << ": " << message;
    if (*row.more == '\0') continue;
    EXPECT_NE(message.find(":2:"), std::string::npos) << message;
  }
  EXPECT_NE(refusal(read_commands, "[1]\n").find("expected an object"), std::string::npos);
  EXPECT_NE(refusal(read_commands, "{\"id\":3}\n").find("id: expected a text"), std::string::npos);
}

}  // namespace
}  // namespace waymark::parser
