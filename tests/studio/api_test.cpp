// The answers of the studio without a socket, and what it answers to requests that are wrong.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "libparser/model_file.hpp"
#include "tools/studio/api.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {
namespace {

using nlohmann::json;

Api& api() {
  static Api one(parser::load_grounder(WAYMARK_DATA_FOLDER "/models/encoder-decoder.waymark"), WAYMARK_DATA_FOLDER);
  return one;
}

ApiAnswer post(std::string_view path, const std::string& body) { return api().answer("POST", path, body, {}); }

json answer(std::string_view path, const json& request) {
  const ApiAnswer reply = post(path, request.dump());
  EXPECT_EQ(reply.status, 200) << reply.json;
  return json::parse(reply.json);
}

json error(std::string_view path, const std::string& body, int status) {
  const ApiAnswer reply = post(path, body);
  EXPECT_EQ(reply.status, status) << path << ' ' << body.substr(0, 80) << ' ' << reply.json;
  const json read = json::parse(reply.json);
  EXPECT_TRUE(read.contains("error")) << reply.json;
  return read["error"];
}

TEST(Api, ReadsAnInstruction) {
  const json said = answer("/api/run", {{"map", "grid"}, {"start", "1,9,0"}, {"instruction", "go to the sofa"}});
  EXPECT_EQ(said["status"], "solved");
  EXPECT_EQ(said["formula"], said["readings"][0]["formula"]);
  EXPECT_EQ(said["certified_by"], "definition");
  EXPECT_EQ(said["shown"].size(), said["readings"].size());
  EXPECT_NE(said["shown"][0]["english"].get<std::string>().find("sofa"), std::string::npos);
}

TEST(Api, SaysWhatItDidNotUnderstand) {
  const json said = answer("/api/run", {{"instruction", "purple monkey dishwasher"}});
  EXPECT_EQ(said["status"], "not understood");
  EXPECT_EQ(said["words"], (json{"monkey", "dishwasher"}));
  EXPECT_NE(answer("/api/run", {{"instruction", "purple monkey dishwasher"}, {"force", true}})["formula"], json());
}

TEST(Api, SaysWhichWordsNameThings) {
  const json said = answer("/api/words", {{"instruction", "Turn left, then walk to the sofa."}, {"attention", true}});
  EXPECT_EQ(said["words"][0], "turn");
  ASSERT_EQ(said["mentions"].size(), 1U);
  EXPECT_EQ(said["mentions"][0]["name"], "sofa");
  EXPECT_EQ(said["words"][said["mentions"][0]["begin"].get<std::size_t>()], "sofa");
  ASSERT_EQ(said["explain"].size(), 1U);
  EXPECT_EQ(said["explain"][0]["words"], said["words"]);
}

TEST(Api, PlansALassoAndChecksIt) {
  const json plan =
      answer("/api/plan", {{"formula", "G F sofa & G F chair"}, {"start", "1,6,0"}, {"semantics", "infinite"}});
  EXPECT_EQ(plan["status"], "solved");
  const std::size_t cycle = plan["cycle"].size() - 1;
  json request{
      {"formula", "G F sofa & G F chair"}, {"semantics", "infinite"}, {"trajectory", plan["route"]}, {"cycle", cycle}};
  const json check = answer("/api/check", request);
  EXPECT_EQ(check["satisfied"], true);
  EXPECT_EQ(check["steps"].size(), plan["route"].size());
  request["formula"] = "G F sofa & G F hatrack";
  EXPECT_EQ(answer("/api/check", request)["satisfied"], false);
  for (const char* semantics : {"finite", "infinite"})
    for (const json& wrong : {json(-7), json(1.5), json("2"), json(check["steps"].size())}) {
      request["semantics"] = semantics;
      request["cycle"] = wrong;
      EXPECT_EQ(error("/api/check", request.dump(), 400)["kind"], "request") << request;
    }
  request.erase("cycle");
  EXPECT_EQ(answer("/api/check", request)["decided"], false);
}

TEST(Api, RefusesNumbersThatAreTooLarge) {
  EXPECT_EQ(error("/api/learn", R"({"formula": "F easel", "steps": 1011e308})", 400)["kind"], "request");
  EXPECT_EQ(error("/api/check", R"({"formula": "F easel", "trajectory": [[4294967297, 9, 0]]})", 400)["kind"],
            "request");
}

TEST(Api, FollowsATrajectoryLetterByLetter) {
  const json check = answer(
      "/api/check", {{"formula", "F easel & G !lamp"}, {"trajectory", {{1, 9, 0}, {1, 8, 0}, {1, 7, 0}, {1, 6, 0}}}});
  EXPECT_EQ(check["satisfied"], false);
  EXPECT_EQ(check["lost_at"], 3) << "letters are counted from 1";
  EXPECT_EQ(check["steps"][1]["verdict"], "open");
  EXPECT_EQ(check["steps"][2]["verdict"], "lost");
  EXPECT_EQ(check["steps"][2]["remains"], "false");
  EXPECT_EQ(check["steps"][3]["action"], "FORWARD");
}

TEST(Api, PointsAtWhatIsWrongInAFormulaInCharacters) {
  const json wrong = error("/api/formula", R"({"formula": "◇sofa ∧ ◇("})", 422);
  EXPECT_EQ(wrong["kind"], "syntax");
  EXPECT_EQ(wrong["begin"], 10);
  EXPECT_EQ(error("/api/formula", R"({"formula": "F sofa & F sofaa"})", 422)["begin"], 11);
}

TEST(Api, TakesAMapAndPlansOnIt) {
  const json yard{{"name", "yard"},
                  {"objects", {"lamp"}},
                  {"floors", {"<script>"}},
                  {"walls", json::array()},
                  {"nodes", {{{"x", 0}, {"y", 0}}, {{"x", 1}, {"y", 0}, {"object", "lamp"}}}},
                  {"edges", {{{"a", {0, 0}}, {"b", {1, 0}}, {"floor", "<script>"}}}}};
  const json map = answer("/api/maps", yard);
  EXPECT_EQ(map["nodes"].size(), 2U);
  EXPECT_EQ(map["svg"].get<std::string>().find("<script"), std::string::npos);
  const json plan = answer("/api/plan", {{"map", map["map"]}, {"formula", "F lamp"}});
  EXPECT_EQ(plan["status"], "solved");
}

TEST(Api, RefusesAFileThatIsNoMap) {
  for (const char* file : {"", "<html>", "[]", "{}", R"({"nodes": [], "edges": []})", R"({"nodes": 7})", "\xff\xfe"})
    EXPECT_EQ(error("/api/maps", file, 422)["kind"], "format") << file;
  EXPECT_EQ(error("/api/maps", std::string(most_body + 1, ' '), 413)["kind"], "too large");
}

TEST(Api, RefusesMapsThatAreTooLarge) {
  json far{{"nodes", {{{"x", 0}, {"y", 0}}, {{"x", Worlds::most_extent + 1}, {"y", 0}}}}, {"edges", json::array()}};
  EXPECT_EQ(error("/api/maps", far.dump(), 413)["kind"], "too large");
  json many{{"nodes", json::array()}, {"edges", json::array()}};
  for (std::size_t i = 0; i <= Worlds::most_nodes; ++i) many["nodes"].push_back({{"x", i % 100}, {"y", i / 100}});
  EXPECT_EQ(error("/api/maps", many.dump(), 413)["kind"], "too large");
}

TEST(Api, RefusesFormulasThatAreTooLarge) {
  for (const char* path : {"/api/formula", "/api/plan", "/api/values", "/api/automaton"})
    EXPECT_EQ(error(path, R"({"formula": "F<=4000 sofa & F<=4000 chair"})", 413)["kind"], "too large") << path;
}

TEST(Api, DropsTheOldestOfManyMaps) {
  std::string first;
  for (std::size_t i = 0; i <= Worlds::most_given; ++i) {
    const json map{{"name", "m" + std::to_string(i)}, {"nodes", {{{"x", 0}, {"y", 0}}}}, {"edges", json::array()}};
    const std::string id = answer("/api/maps", map)["map"];
    if (i == 0) first = id;
  }
  EXPECT_EQ(error("/api/map", json{{"map", first}}.dump(), 404)["kind"], "no such map");
}

TEST(Api, RefusesRequestsThatAreWrong) {
  for (const char* body : {"", "{", "[1]", "7", "null", R"({"formula": 7})", R"({"formula": ["F sofa"]})",
                           R"({"formula": "F sofa", "semantics": "both"})", R"({"formula": "F sofa", "map": 1})"})
    EXPECT_EQ(error("/api/automaton", body, 400)["kind"], "request") << body;
  EXPECT_EQ(error("/api/run", R"({"instruction": ")" + std::string(most_text + 1, 'a') + "\"}", 413)["kind"],
            "too large");
  error("/api/formula", std::string(most_body + 1, ' '), 413);
}

TEST(Api, BuildsNoTreeThatIsTooLarge) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  const auto many = [](std::size_t values) {  // with the object and the list that hold them
    std::string list = "0";
    for (std::size_t i = 3; i < values; ++i) list += ",0";
    return "[" + list + "]";
  };
  const auto in_object = [](const std::string& value) { return R"({"nodes": )" + value + "}"; };
  for (const char* path : {"/api/automaton", "/api/maps"}) {
    const int wrong = std::string(path) == "/api/maps" ? 422 : 400;
    for (const std::string& large :
         {std::string(500'000, '['), in_object(nested(most_levels)), in_object(many(most_values + 1))})
      EXPECT_EQ(error(path, large, 413)["kind"], "too large") << path;
    for (const std::string& small : {in_object(nested(most_levels - 1)), in_object(many(most_values))})
      error(path, small, wrong);
  }
}

TEST(Api, ReachesNoFile) {
  for (const char* map : {"../../../etc/passwd", "/etc/passwd", "grid.json", "maps/grid", "", "-", "given-0"})
    error("/api/map", json{{"map", map}}.dump(), 404);
  for (const char* path : {"/api/../etc/passwd", "/api/", "/api/maps/", "/etc/passwd", "/api/run/"})
    error(path, "{}", 404);
  EXPECT_EQ(api().answer("GET", "/api/run", "", {}).status, 405);
  EXPECT_EQ(api().answer("PUT", "/api/maps", "", {}).status, 405);
}

TEST(Api, RefusesTrajectoriesThatAreNone) {
  const auto walk = [](const json& poses) { return json{{"formula", "F sofa"}, {"trajectory", poses}}.dump(); };
  for (const json& poses : {json(7), json::array(), json{1, 2}, json{{1, 9}}, json{{1, 9, "0"}}, json{{1, 9, 45}},
                            json{{99, 9, 0}}, json{{1, 9, 0}, {1, 7, 0}}, json{{1, 9, 0}, {1, 9, 180}}})
    EXPECT_EQ(error("/api/check", walk(poses), 400)["kind"], "request") << poses;
  json turning = json::array();
  for (std::size_t i = 0; i <= most_poses; ++i) turning.push_back({1, 9, i % 2 == 0 ? 0 : 90});
  error("/api/check", walk(turning), 413);
}

TEST(Api, StopsWhenItIsAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  const ApiAnswer reply = api().answer("POST", "/api/plan", R"({"formula": "F sofa"})", stop.get_token());
  EXPECT_EQ(reply.status, 422);
  EXPECT_EQ(json::parse(reply.json)["error"]["kind"], "limit");
}

TEST(Api, WritesAutomataInEveryFormat) {
  const auto written = [](const json& request) { return answer("/api/translate", request)["text"].get<std::string>(); };
  EXPECT_TRUE(written({{"formula", "F sofa"}, {"format", "hoa"}}).starts_with("HOA: v1"));
  EXPECT_TRUE(written({{"formula", "F sofa"}, {"format", "dot"}}).starts_with("digraph"));
  EXPECT_TRUE(written({{"formula", "G F sofa"}, {"semantics", "infinite"}, {"to", "buchi"}, {"format", "never"}})
                  .starts_with("never"));
  EXPECT_EQ(error("/api/translate", R"({"formula": "F sofa", "format": "never"})", 422)["kind"], "usage");
  EXPECT_NE(answer("/api/picture", {{"formula", "F sofa"}})["svg"].get<std::string>().find("<svg"), std::string::npos);
}

TEST(Api, AnswersManyAtOnceAndTurnsTheRestAway) {
  std::atomic<int> answered = 0, away = 0;
  {
    std::vector<std::jthread> all;
    for (int i = 0; i < 40; ++i)
      all.emplace_back([&] {
        const int status =
            post("/api/run", R"({"instruction": "walk past the lamp to the easel", "start": "1,9,0"})").status;
        status == 200 ? ++answered : status == 503 ? ++away : 0;
      });
  }
  EXPECT_GT(answered, 0);
  EXPECT_EQ(answered + away, 40);
  EXPECT_EQ(post("/api/formula", R"({"formula": "F sofa"})").status, 200);
}

// Automata that take hours, eight asked for at once: three are worked on until they are stopped, and who asks for
// something else is answered.
TEST(Api, DrawsThreePicturesAtATime) {
  const std::vector<std::string> names = {"chair", "sofa",     "easel",  "lamp",  "hatrack", "barstool", "blue",
                                          "brick", "concrete", "flower", "grass", "gravel",  "wood"};
  std::string hard = "F yellow";
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    hard += " & F(" + names[i] + " & X X X " + names[i + 1] + " & F(" + names[i + 1] + " & G(" + names[i] + " -> X X " +
            names[i + 1] + ")))";
  const std::string body = json{{"formula", hard}}.dump();
  constexpr int asked = Api::most_at_once, turned_away = asked - Api::most_drawn_at_once;
  std::stop_source stop;
  std::atomic<int> away = 0, ended = 0;
  std::vector<std::jthread> all;
  for (int i = 0; i < asked; ++i)
    all.emplace_back([&] {
      const int status = api().answer("POST", "/api/automaton", body, stop.get_token()).status;
      ++(status == 503 ? away : ended);
    });
  while (away < turned_away && ended == 0) std::this_thread::yield();
  EXPECT_EQ(ended, 0) << "the three are not at work";
  EXPECT_EQ(post("/api/picture", R"({"formula": "F sofa"})").status, 503);
  EXPECT_EQ(post("/api/formula", R"({"formula": "F sofa"})").status, 200);
  stop.request_stop();
  all.clear();
  EXPECT_EQ(away, turned_away);
  EXPECT_EQ(ended, Api::most_drawn_at_once);
  EXPECT_EQ(post("/api/picture", R"({"formula": "F sofa"})").status, 200);
}

}  // namespace
}  // namespace waymark::studio
