// The answers of the API obey the JSON schemas that are installed with waymark, and the schemas refuse other objects.
#include <gtest/gtest.h>

#include "libparser/model_file.hpp"
#include "tests/studio/schemas.hpp"
#include "tools/studio/api.hpp"

namespace waymark::studio {
namespace {

using nlohmann::json;

ApiAnswer ask(const std::string& method, const std::string& path, const std::string& body) {
  static Api one(parser::load_grounder(WAYMARK_DATA_FOLDER "/models/encoder-decoder.waymark"), WAYMARK_DATA_FOLDER);
  return one.answer(method, "/api/" + path, body, {});
}

struct Case {
  std::string schema, path, body;
  std::string method = "POST";
};

std::vector<Case> cases() {
  const std::string forever = R"({"formula": "G F sofa & G F chair", "semantics": "infinite")";
  const std::string walk = R"(, "trajectory": [[1,9,0],[1,9,90],[1,9,0]])";
  return {
      {"maps", "maps", "", "GET"},
      {"map", "map", R"({"map": "jelly"})"},
      {"run", "run", R"({"instruction": "walk past the lamp to the easel. take a left.", "start": "1,9,0"})"},
      {"run", "run", R"({"instruction": "visit the chair and the sofa forever"})"},
      {"run", "run", R"({"instruction": "purple monkey dishwasher"})"},
      {"run", "run", R"({"instruction": "walk to the piano"})"},
      {"words", "words", R"({"instruction": "turn left and walk to the sofa", "attention": true})"},
      {"plan", "plan", R"({"formula": "F sofa"})"},
      {"plan", "plan", R"({"formula": "F sofa & G !sofa"})"},
      {"plan", "plan", forever + "}"},
      {"check", "check", R"({"formula": "F sofa")" + walk + "}"},
      {"check", "check", forever + walk + "}"},
      {"check", "check", forever + walk + R"(, "cycle": 2})"},
      {"explain", "explain", R"({"formula": "F sofa & F chair"})"},
      {"explain", "explain", R"({"formula": "false"})"},
      {"explain", "explain", forever + "}"},
      {"formula", "formula", R"({"formula": "F sofa & F chair"})"},
      {"automaton", "automaton", R"({"formula": "F sofa & F chair"})"},
      {"automaton", "automaton", forever + "}"},
      {"translate", "translate", R"({"formula": "F sofa", "format": "tsv"})"},
      {"translate", "prism", R"({"formula": "F easel & G !chair", "start": "1,9,0", "slip": 0.2})"},
      {"picture", "picture", R"({"formula": "F sofa"})"},
      {"values", "values", R"({"formula": "F easel & G !chair", "start": "1,9,0", "slip": 0.2})"},
      {"values", "values", R"({"formula": "F easel & G !chair", "start": "1,9,0", "slip": 0.2, "query": "mincost"})"},
      {"values", "values", R"({"formula": "F easel", "start": "1,9,0", "slip": 0.2, "query": "mincost"})"},
      {"values", "values", R"({"formula": "false"})"},
      {"learn", "learn", R"({"formula": "F easel", "start": "1,9,0", "steps": 500})"},
      {"learn", "learn", R"({"formula": "false", "steps": 500})"},
      {"error", "formula", R"({"formula": "F ("})"},
      {"error", "nothing", "{}"},
      {"error", "maps", "no map"},
  };
}

TEST(Schemas, HoldOfEveryAnswer) {
  for (const Case& one : cases()) {
    const ApiAnswer answer = ask(one.method, one.path, one.body);
    EXPECT_EQ(answer.status == 200, one.schema != "error") << one.path << ' ' << one.body << ' ' << answer.json;
    EXPECT_EQ(fault(one.schema, json::parse(answer.json)), "") << one.path << ' ' << one.body << '\n' << answer.json;
  }
}

// Every key that an answer always has is required, and no other key is allowed.
TEST(Schemas, RefuseOtherObjects) {
  for (const Case& one : cases()) {
    json document = json::parse(ask(one.method, one.path, one.body).json);
    document["surprise"] = 1;
    EXPECT_NE(fault(one.schema, document), "") << one.schema;
    EXPECT_NE(fault(one.schema, json::object()), "") << one.schema;
    EXPECT_NE(fault(one.schema, json::array()), "") << one.schema;
  }
}

}  // namespace
}  // namespace waymark::studio
