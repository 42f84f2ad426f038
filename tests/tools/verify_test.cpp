// `waymark verify` of answers in which one value was changed at random: every key of every kind of answer. What is
// changed must be refused, refuted or named as not examined, but for labels and the figures of the run.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/sanitizers.hpp"
#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

const std::string golden = std::string(WAYMARK_DATA_FOLDER) + "/../tests/golden/";
const std::string streets = golden + "streets.json", yard = golden + "yard.json", lift = golden + "lift.nm";

struct Kind {
  Arguments asked, examined;  // by plan, run, check or translate; by verify
  std::size_t line = 0;       // of what is printed
};

void add_checks_and_properties(std::vector<Kind>& out) {
  for (const auto& [model, formula] : {std::pair(streets, "G !mill"), std::pair(streets, "G !(mill & market)"),
                                       std::pair(yard, "!x U b"), std::pair(yard, "F b"), std::pair(yard, "G !x")})
    out.push_back({{"check", formula, "--model", model}, {"--model", model}});
  const Arguments of{"--model", lift, "--const", "floors=2,sticks=0"};
  for (std::size_t line = 0; line < 5; ++line) {
    out.push_back({{"plan", "--properties", golden + "lift.props"}, of, line});
    out.back().asked.insert(out.back().asked.end(), of.begin(), of.end());
  }
}

std::vector<Kind> all_kinds() {
  std::vector<Kind> out;
  for (const Arguments& on_map : {Arguments{"plan", "F sofa", "--start", "1,9,0"},
                                  {"plan", "F(sofa & X F chair)", "--top", "3"},
                                  {"plan", "G F chair & G F sofa", "--semantics", "infinite", "--start", "1,9,0"},
                                  {"plan", "G F chair & G F sofa", "--semantics", "infinite", "--order", "mean"},
                                  {"plan", "G F chair", "--semantics", "infinite", "--order", "cycle"},
                                  {"plan", "G F chair & G !chair", "--semantics", "infinite", "--start", "1,9"},
                                  {"plan", "F chair & G !chair", "--start", "1,9,0"},
                                  {"plan", "F chair & X !moved & X moved", "--start", "1,9", "--top", "2"},
                                  {"plan", "X(moved & X moved) & X X N false", "--top", "3", "--start", "1,9,0"},
                                  {"run", "go to the easel", "--start", "1,9,0"},
                                  {"run", "always come back to the easel", "--start", "1,9,0"}})
    out.push_back({on_map, {}});
  for (const char* to : {"tgba", "buchi", "parity", "rabin", "generic"})
    out.push_back({{"translate", "G(a -> F b)", "--to", to, "--format"}, {}});
  out.push_back({{"translate", "F a & G !b", "--semantics", "finite", "--format"}, {}});
  for (const Arguments& question : {Arguments{"F bridge & F mill", "--query", "steps", "--top", "3"},
                                    {"F mill", "--query", "steps"},
                                    {"F bridge & G !bridge", "--query", "steps"},
                                    {"G F market & G F mill", "--query", "lasso"},
                                    {"F mill & G !mill & F bridge", "--query", "lasso"},
                                    {"F mill", "--query", "rmin"}})
    out.push_back({{"plan", "--model", streets}, {"--model", streets}}),
        out.back().asked.insert(out.back().asked.end(), question.begin(), question.end());
  for (const Arguments& question : {Arguments{"!x U b", "--query", "pmax"},
                                    {"!x U b", "--query", "pmin"},
                                    {"G !x", "--query", "pmax"},
                                    {"F b", "--query", "rmin"},
                                    {"F b", "--query", "rmax"},
                                    {"G F a & G F b", "--query", "pmax"},
                                    {"F b", "--query", "discounted"},
                                    {"F b & G !b", "--query", "pmax"}})
    out.push_back({{"plan", "--model", yard}, {"--model", yard}}),
        out.back().asked.insert(out.back().asked.end(), question.begin(), question.end());
  add_checks_and_properties(out);
  return out;
}

std::vector<json> lines_of(const std::string& text) {
  std::istringstream printed(text);
  std::vector<json> out;
  for (std::string line; std::getline(printed, line);) out.push_back(json::parse(line));
  return out;
}

json answer_of(Kind kind) {
  kind.asked.emplace_back(kind.asked[0] == "translate" ? "json" : "--json");
  return lines_of(run_helper(WAYMARK_EXECUTABLE, kind.asked, "").output).at(kind.line);
}

// Labels, figures of the run that found the answer, and what is no less true without it.
const std::set<std::string> no_claims{
    "/id",       "/line",    "/case",          "/task",           "/method",          "/seconds",
    "/peak_mib", "/product", "/product_edges", "/product_states", "/automaton_states"};
bool is_no_claim(const std::string& pointer, const json& answer) {
  const std::string key = pointer.substr(0, pointer.find('/', 1));
  return no_claims.contains(key) || (key == "/automaton" && !answer.contains("hoa")) ||
         pointer == "/automaton/symbolic_nodes";
}

// Of no route, it is as true of fewer starts; where all routes are there, of more that were asked for; a model may read
// a misspelt text as the right one; every run satisfies `true`; and of what has no answer, a variant may have none.
bool may_stay_true(const std::string& pointer, const json& value, const json& answer) {
  if (pointer.starts_with("/starts")) return answer.at("status") == "infeasible" && pointer == "/starts";
  if (pointer == "/asked") return answer.at("routes").size() < value;
  if (pointer == "/property") return answer.at("status") == "not answered";
  return pointer == "/instruction" || (pointer == "/formula" && value == "true" && answer.contains("holds"));
}

std::vector<json> changes_of(const json& value) {
  if (value.is_number())
    return {value.get<double>() + 1, value.get<double>() * 2 + 0.5, -1 - value.get<double>(), "x", nullptr};
  if (value.is_string()) {
    const auto text = value.get<std::string>();
    return {text + "x", "", "!(" + text + ')', "true", "infeasible", "exhausted", 1, nullptr};
  }
  if (value.is_boolean()) return {!value.get<bool>(), nullptr};
  if (!value.is_array() || value.empty()) return {nullptr};
  json less = value, twice = value, turned = value;
  less.erase(less.begin());
  twice.push_back(value.back());
  std::reverse(turned.begin(), turned.end());
  return {less, twice, turned, json::array(), nullptr};
}

struct Changed {
  std::string pointer, line;
};
std::vector<Changed> all_changed(const json& answer, std::mt19937& random) {
  std::vector<Changed> out;
  const json flat = answer.flatten();
  std::set<std::string> pointers;
  for (const auto& leaf : flat.items())
    for (std::string at = leaf.key(); !at.empty(); at = at.substr(0, at.rfind('/'))) pointers.insert(at);
  for (const std::string& at : pointers) {
    if (is_no_claim(at, answer)) continue;
    const json& value = answer.at(json::json_pointer(at));
    std::vector<json> changes = changes_of(value);
    std::shuffle(changes.begin(), changes.end(), random);
    changes.resize(std::min<std::size_t>(changes.size(), at.find('/', 1) == std::string::npos ? 8 : 2));
    for (const json& change : changes) {
      json copy = answer;
      copy.at(json::json_pointer(at)) = change;
      if (change != value && !may_stay_true(at, change, answer)) out.push_back({at, copy.dump()});
    }
  }
  return out;
}

std::vector<json> verdicts_on(const std::vector<Changed>& changed, const Kind& kind) {
  std::string lines;
  for (const Changed& one : changed) lines += one.line + '\n';
  Arguments arguments{"verify", "-", "--json", "--words", "300"};
  arguments.insert(arguments.end(), kind.examined.begin(), kind.examined.end());
  return lines_of(run_helper(WAYMARK_EXECUTABLE, arguments, lines).output);
}

TEST(Verify, BelievesNoAnswerInWhichSomethingWasChanged) {
  std::mt19937 random(34);
  for (const Kind& kind : all_kinds()) {
    const json answer = answer_of(kind);
    const std::string whole = verdicts_on({{"", answer.dump()}}, kind).at(0).at("verdict");
    EXPECT_TRUE(whole == "verified" || whole == "partly verified") << answer;
    const std::vector<Changed> changed = all_changed(answer, random);
    const std::vector<json> verdicts = verdicts_on(changed, kind);
    ASSERT_EQ(verdicts.size(), changed.size());
    for (std::size_t i = 0; i < changed.size(); ++i)
      EXPECT_NE(verdicts[i].value("verdict", "refused"), "verified") << changed[i].pointer << " of " << changed[i].line;
  }
}

// Of every order, from one start and from four headings, and where there is no walk.
TEST(Verify, DecidesWalksWithoutEnd) {
  const std::string formulas =
      "G F chair & F G !sofa\nG F chair & G F sofa & G F easel\nF(easel & X G !chair)\nG(chair -> X X moved) & G F "
      "chair\n"
      "F G(moved | turned_left) & G F turned_left\n!chair W sofa & G F lamp\nG !moved & G !turned_left & G F sofa\n"
      "F G moved\nG F (chair & X !moved) & F sofa\nG(X moved <-> turned_left)\nF sofa & G F easel & G !chair & G "
      "chair\n";
  for (const char* map : {"grid", "jelly", "l"})
    for (const char* order : {"prefix", "cycle", "mean"}) {
      const Arguments asked{"plan", "--semantics", "infinite", "--order", order, "--map", map, "--json", "-F", "-"};
      const std::string answers = run_helper(WAYMARK_EXECUTABLE, asked, formulas).output;
      const std::vector<json> said = lines_of(run_helper(WAYMARK_EXECUTABLE, {"verify", "--json"}, answers).output);
      EXPECT_GE(said.size(), 8U);
      for (const json& one : said) EXPECT_EQ(one.value("verdict", "refused"), "verified") << one << answers;
    }
}

// What nobody knows how to examine is named, wherever it stands.
TEST(Verify, NamesWhatIsNotExamined) {
  for (const Kind& kind : all_kinds()) {
    json answer = answer_of(kind);
    answer["shortest"] = true;
    const json verdict = verdicts_on({{"", answer.dump()}}, kind).at(0);
    EXPECT_EQ(verdict.at("verdict"), "partly verified");
    EXPECT_NE(verdict.at("claims").dump().find(R"({"claim":"shortest","holds":null})"), std::string::npos) << verdict;
  }
}

// Two roads between two places, the dearer one first: the route is told by names, and takes the cheaper.
TEST(Verify, TakesTheRoadThatARouteMeans) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "waymark-verify";
  std::filesystem::create_directories(folder);
  const std::string roads = (folder / "twins.gr").string();
  std::ofstream(roads) << "p sp 3 4\na 1 2 9\na 1 2 5\na 2 3 7\na 2 3 4\n";
  std::ofstream(folder / "twins.lab") << "0=\"init\" 1=\"home\"\n1: 0\n3: 1\n";
  for (const Arguments& more : {Arguments{}, {"--top", "2"}}) {
    Arguments asked{"plan", "--model", roads, "F home", "--query", "steps"};
    asked.insert(asked.end(), more.begin(), more.end());
    const json answer = answer_of({asked, {}});
    EXPECT_EQ(answer.at("value"), 9);
    EXPECT_NE(verdicts_on({{"", answer.dump()}}, {{}, {"--model", roads}}).at(0).at("verdict"), "refuted") << answer;
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace waymark::tools
