// The whole corridor as a process: the lines that others rely on keep their shape, and what is answered is true.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

using nlohmann::json;

Finished waymark(const std::vector<std::string>& arguments, const std::string& input = "") {
  return run_helper(WAYMARK_EXECUTABLE, arguments, input);
}

std::vector<std::string> keys(const json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;  // nlohmann sorts them
}

TEST(Corridor, OnlyWhatWasCertifiedIsCalledCertified) {
  const auto says_so = [](const Finished& drawn) {
    EXPECT_EQ(drawn.exit_code, 0);
    return drawn.output.find(", certified<") != std::string::npos;
  };
  const std::string walk = "1,9,0 LEFT LEFT FORWARD";
  EXPECT_FALSE(says_so(waymark({"draw", "--map", "grid", "--route", "-", "--svg", "-"}, walk)));
  EXPECT_TRUE(says_so(waymark({"draw", "--map", "grid", "--start", "1,9,0", "--formula", "F easel", "--svg", "-"})));
  const Finished lasso =
      waymark({"plan", "G F easel", "--semantics", "infinite", "--map", "grid", "--start", "1,9,0", "--svg", "-"});
  EXPECT_TRUE(says_so(lasso));
  EXPECT_NE(lasso.output.find(" for ever, certified<"), std::string::npos);
}

TEST(Corridor, AnswersTheDemoWithACertifiedRoute) {
  const Finished finished = waymark({"run", "--demo", "--json"});
  ASSERT_EQ(finished.exit_code, 0) << finished.output;
  const json answer = json::parse(finished.output);
  EXPECT_EQ(keys(answer), (std::vector<std::string>{"alternatives", "automaton", "certified", "certified_by", "cost",
                                                    "formula", "instruction", "map", "product", "readings", "route",
                                                    "seconds", "status", "understood"}));
  EXPECT_EQ(keys(answer["automaton"]), (std::vector<std::string>{"edges", "propositions", "states", "symbolic_nodes"}));
  EXPECT_EQ(keys(answer["product"]), (std::vector<std::string>{"edges", "states"}));
  EXPECT_EQ(keys(answer["seconds"]),
            (std::vector<std::string>{"certify", "compose", "ground", "load", "solve", "total", "translate"}));
  EXPECT_EQ(answer["certified"], true);
  EXPECT_EQ(answer["readings"][0]["formula"], answer["formula"]);
  EXPECT_EQ(answer["cost"], answer["route"].size() - 1);
  EXPECT_EQ(answer["route"][0], json::parse("[1,9,0]"));
}

TEST(Corridor, EveryPrefixCanBeFedBackIn) {
  const std::string instruction = "walk to the easel";
  const json grounded = json::parse(waymark({"ground", instruction, "--start", "1,9,0", "--json"}).output);
  const std::string answer = waymark({"run", instruction, "--start", "1,9,0", "--json"}).output;
  const json run = json::parse(answer);
  EXPECT_EQ(grounded["formula"], run["formula"]);
  const std::string formula = run["formula"];
  const json planned = json::parse(waymark({"plan", formula, "--start", "1,9,0", "--json"}).output);
  EXPECT_EQ(planned["route"], run["route"]);
  const std::string hoa = waymark({"translate", "--to", "dfa", formula}).output;
  const json by_automaton =
      json::parse(waymark({"plan", "--automaton", "-", "--start", "1,9,0", "--json"}, hoa).output);
  EXPECT_EQ(by_automaton["route"], run["route"]);
  EXPECT_EQ(by_automaton["certified_by"], "automaton");
  EXPECT_EQ(waymark({"check", formula, "--trajectory", "-"}, answer).exit_code, 0);
}

TEST(Corridor, ProbabilitiesOfAllReadingsSumToOne) {
  const json run =
      json::parse(waymark({"run", "go to the chair", "--start", "1,9,0", "--json", "--top", "1000"}).output);
  double sum = 0;
  for (const json& reading : run["readings"]) sum += reading["probability"].get<double>();
  EXPECT_GT(run["readings"].size(), 1U);
  EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(Corridor, AnswersABatchInOrderAndReportsTheBadLine) {
  const Finished finished =
      waymark({"run", "--start", "1,9,0", "--json"}, "turn left\n\n{\"map\":\"grid\"}\nturn right\n");
  EXPECT_EQ(finished.exit_code, 21) << finished.output;
  std::istringstream lines(finished.output);
  std::vector<json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(json::parse(line));
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0]["instruction"], "turn left");
  EXPECT_EQ(answers[1]["status"], "error");
  EXPECT_EQ(answers[1]["line"], 3);
  EXPECT_EQ(answers[2]["instruction"], "turn right");
}

TEST(Corridor, SaysWhatItDoesNotUnderstand) {
  const Finished coffee = waymark({"run", "bring me a coffee", "--start", "1,9,0", "--json"});
  EXPECT_EQ(coffee.exit_code, 12) << coffee.output;
  EXPECT_EQ(json::parse(coffee.output)["status"], "not understood");
  EXPECT_EQ(waymark({"run", "bring me a coffee", "--start", "1,9,0", "--force"}).exit_code, 0);
  EXPECT_EQ(waymark({"ground", "xyzzy plugh", "--start", "1,9,0"}).exit_code, 12);
}

TEST(Corridor, ReadsTemporalWords) {
  const auto formula = [](const std::string& text) {
    return json::parse(waymark({"run", text, "--start", "1,9,0", "--json"}).output)["formula"];
  };
  EXPECT_EQ(formula("do not go to the sofa"), "G !sofa");
  EXPECT_EQ(formula("go to the easel without stepping on blue"), "F easel & G !blue");
  EXPECT_EQ(formula("go to the chair or the lamp"), "F(chair | lamp)");
  const json patrol =
      json::parse(waymark({"run", "keep coming back to the lamp", "--start", "1,9,0", "--json"}).output);
  EXPECT_EQ(patrol["formula"], "G F lamp");
  EXPECT_EQ(patrol["understood"], "go to the lamp again and again.");
  EXPECT_TRUE(patrol.contains("prefix") && patrol.contains("cycle")) << patrol;
}

TEST(Corridor, LinesMayNameTheirMapAndStart) {
  const Finished finished =
      waymark({"run", "--json"}, R"({"id":"a","text":"go to the chair","map":"jelly","start":[16,19,270]})"
                                 "\n");
  const json answer = json::parse(finished.output);
  EXPECT_EQ(answer["id"], "a");
  EXPECT_EQ(answer["map"], "jelly");
  EXPECT_EQ(answer["route"][0], json({16, 19, 270}));
}

TEST(Corridor, DrawsThePictureWholeWithTheAutomatonInIt) {
  const auto svg = std::filesystem::temp_directory_path() / ("waymark-corridor-" + std::to_string(::getpid()) + ".svg");
  ASSERT_EQ(waymark({"run", "--demo", "--svg", svg.string()}).exit_code, 0);
  std::ifstream file(svg);
  const std::string picture{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::filesystem::remove(svg);
  EXPECT_TRUE(picture.ends_with("</svg>\n"));
  EXPECT_NE(picture.find("class=\"node\""), std::string::npos) << "no automaton that Graphviz drew";
}

TEST(Corridor, RefusesAModelThatIsNone) {
  const Finished finished = waymark({"run", "turn left", "--model-file", WAYMARK_EXECUTABLE});
  EXPECT_EQ(finished.exit_code, 21);
  EXPECT_EQ(finished.output, "");
}

TEST(Corridor, TrainsAndEvaluatesOnASmallCorpus) {
  const auto folder = std::filesystem::temp_directory_path() / ("waymark-corpus-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::ofstream corpus(folder / "instructions.jsonl");
  const auto paragraph = [&](int number, const std::string& map, const std::string& path) {
    corpus << R"({"id":"own_)" << number << R"(","num":)" << number << R"(,"map":")" << map
           << R"(","author":"own","start_place":1,"goal_place":2,"start":[0,0,0],"goal":[0,0],"text":"turn left",)"
           << R"("path":)" << path << R"(,"sentences":[{"id":")" << number
           << R"(-1","text":"turn left","tokens":["turn","left","position",")" << number << R"("],)"
           << R"("path":)" << path << R"(}],"flags":[]})" << '\n';
  };
  paragraph(1, "grid", "[[1,9,0],[1,9,270]]");
  paragraph(2, "jelly", "[[17,17,0],[17,17,270]]");
  paragraph(3, "l", "[[23,18,0],[23,18,270]]");
  corpus.close();
  const auto model = folder / "model.waymark";
  EXPECT_EQ(waymark({"train", "--corpus", folder.string(), "--epochs", "2", "--out", model.string()}).exit_code, 0);
  EXPECT_EQ(waymark({"run", "turn left", "--model-file", model.string(), "--start", "1,9,0"}).exit_code, 0);
  const std::vector<std::string> evaluate{"evaluate", "--corpus", folder.string(), "--leave-one-map-out",
                                          "--epochs", "2",        "--json"};
  const Finished evaluated = waymark(evaluate);
  std::vector<std::string> tell = evaluate;
  tell.emplace_back("--tell-place-numbers");
  const json told = json::parse(waymark(tell).output);
  std::filesystem::remove_all(folder);
  ASSERT_EQ(evaluated.exit_code, 0);
  const json scores = json::parse(evaluated.output);
  EXPECT_EQ(keys(scores),
            (std::vector<std::string>{"folds", "n", "paragraph", "paragraph_path", "path", "place_numbers", "published",
                                      "satisfiable", "seconds", "sentence", "staying", "unheard"}));
  EXPECT_EQ(keys(scores["folds"]), (std::vector<std::string>{"grid", "jelly", "l"}));
  EXPECT_EQ(scores["n"]["sentences"], 3);
  EXPECT_EQ(scores["place_numbers"], "hidden");
  EXPECT_EQ(scores["unheard"]["n"], 0);  // without their numbers all sentences are one
  EXPECT_EQ(told["place_numbers"], "told");
  EXPECT_EQ(told["unheard"]["n"], 3);
  EXPECT_EQ(keys(told["unheard"]), (std::vector<std::string>{"absolute", "n", "relative"}));
  EXPECT_EQ(scores["sentence"]["absolute"], 100.0);  // "turn left" is learnt from two other lefts
}

}  // namespace
}  // namespace waymark::tools
