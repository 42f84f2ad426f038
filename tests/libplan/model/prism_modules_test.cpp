// Programs of several modules against the module that they amount to, Markov chains, constants, renaming; properties.
#include <gtest/gtest.h>

#include <random>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/prism_properties.hpp"
#include "libplan/model/formats/result_comment.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/solve/finite_horizon.hpp"
#include "tests/libplan/model/models.hpp"

namespace waymark::plan {
namespace {

using test::difference;

struct Part {   // a command of x or y, whose guard and updates are numbers
  char action;  // or ' '
  int at;
  std::vector<std::pair<int, int>> updates;  // eighths, the next value
};

std::vector<Part> random_commands(std::mt19937& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<Part> out;
  for (int i = 0, n = 2 + below(4); i < n; ++i) {
    Part& part = out.emplace_back(Part{"abc " [below(4)], below(3), {}});
    const int first = 1 + below(7);
    part.updates = {{first, below(3)}, {8 - first, below(3)}};
  }
  return out;
}

std::string guard(const std::string& v, const Part& p) { return v + "=" + std::to_string(p.at); }
std::string update(const std::string& v, int to) { return "(" + v + "'=" + std::to_string(to) + ")"; }
std::string label(char action) { return action == ' ' ? "[]" : std::string("[") + action + "]"; }

std::string command(const std::string& v, const Part& p) {
  std::string out = label(p.action) + guard(v, p) + "->";
  for (std::size_t i = 0; i < 2; ++i)
    out += (i > 0 ? "+" : "") + std::to_string(p.updates[i].first) + "/8:" + update(v, p.updates[i].second);
  return out + ";\n";
}

std::string together(const Part& p, const Part& q) {
  std::string out = label(p.action) + guard("x", p) + "&" + guard("y", q) + "->";
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      out += (i + j > 0 ? "+" : "") + std::to_string(p.updates[i].first * q.updates[j].first) +
             "/64:" + update("x", p.updates[i].second) + "&" + update("y", q.updates[j].second);
  return out + ";\n";
}

bool has(const std::vector<Part>& parts, char action) {
  for (const Part& p : parts)
    if (p.action == action && action != ' ') return true;
  return false;
}

TEST(PrismModules, AreTheModuleThatTheyAmountTo) {
  std::mt19937 random(3);
  const std::string rest =
      "label \"a\" = x=2; label \"b\" = y>x; rewards [a] x=1 : 3; [] true : 2; y=0 : 1; endrewards\n";
  for (int i = 0; i < 500; ++i) {
    const std::vector<Part> xs = random_commands(random), ys = random_commands(random);
    std::string two = "mdp module m x : [0..2];\n", one = "mdp module m x : [0..2]; y : [0..2];\n";
    for (const Part& p : xs) {
      two += command("x", p);
      if (!has(ys, p.action)) one += command("x", p);
      for (const Part& q : ys)
        if (p.action != ' ' && p.action == q.action) one += together(p, q);
    }
    two += "endmodule module n y : [0..2];\n";
    for (const Part& q : ys) {
      two += command("y", q);
      if (!has(xs, q.action)) one += command("y", q);
    }
    ASSERT_EQ(difference(parse_prism(two + "endmodule\n" + rest), parse_prism(one + "endmodule\n" + rest)), "") << two;
  }
}

TEST(PrismModules, AreRenamedWithTheFormulasThatTheyUse) {
  const std::string head =
      "mdp const int n = 2; formula full = x=n; global g : [0..9] init 4;\n"
      "module one x : [0..n]; ready : bool init true;\n"
      "[go] !full & ready -> 0.5:(x'=x+1) + 0.5:(ready'=false);\n"
      "[] full & g<9 -> (g'=g+1) & (x'=0);\n[back] !ready -> (ready'=true); endmodule\n";
  const std::string rest = "label \"both\" = x=n & z=n;";
  const Mdp renamed = parse_prism(head + "module two = one [x=z, ready=r2, back=again] endmodule\n" + rest);
  const Mdp written = parse_prism(head +
                                  "module two z : [0..n]; r2 : bool init true;\n"
                                  "[go] !(z=n) & r2 -> 0.5:(z'=z+1) + 0.5:(r2'=false);\n"
                                  "[] z=n & g<9 -> (g'=g+1) & (z'=0);\n[again] !r2 -> (r2'=true); endmodule\n" +
                                  rest);
  EXPECT_EQ(difference(renamed, written), "");
  EXPECT_GT(renamed.states(), 50U);
}

TEST(PrismModules, OfAMarkovChainDrawTheirCommands) {
  const Mdp chain = parse_prism(
      "dtmc module m x : [0..2]; [a] x=0 -> (x'=1); [] x=0 -> 0.5:(x'=2) + 0.5:(x'=1); "
      "endmodule rewards [a] true : 8; x=0 : 1; endrewards");
  ASSERT_EQ(chain.choices(0), 1U);
  ASSERT_EQ(chain.outcomes(0, 0).size(), 2U);
  EXPECT_DOUBLE_EQ(chain.outcomes(0, 0)[0].probability, 0.75);
  EXPECT_DOUBLE_EQ(chain.outcomes(0, 0)[1].probability, 0.25);
  EXPECT_DOUBLE_EQ(chain.cost(0, 0), 5);
}

TEST(PrismModules, WithoutVariablesHaveOneState) {
  const Mdp chain = parse_prism("dtmc\nmodule m\n [] true -> true;\nendmodule\nlabel \"a\" = true;\n");
  EXPECT_EQ(chain.states(), 1U);
  EXPECT_EQ(chain.name(0), "()");
  EXPECT_EQ(answer({"", chain, {}}, {"", "G a", CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability}).value.lower, 1);
  const Mdp dead = parse_prism("mdp\nmodule m\nendmodule\nmodule n\n [go] false -> true;\nendmodule\n");
  EXPECT_EQ(dead.states(), 1U);
  const Mdp rewarded = parse_prism(
      "mdp\nmodule m\n [a] true -> true;\n [b] true -> true;\nendmodule\nrewards\n [a] true : 2;\n true : "
      "1;\nendrewards\n");
  EXPECT_EQ(rewarded.cost(0, 0), 3);
  EXPECT_EQ(rewarded.cost(0, 1), 1);
}

TEST(PrismModules, TakeConstantsAndRewards) {
  const std::string text =
      "mdp const int n; const double p; const bool b; module m x : [0..n]; [] x<n & b -> "
      "p:(x'=x+1) + 1-p:true; endmodule rewards \"one\" true : 1; endrewards rewards \"two\" "
      "true : 2; endrewards";
  const PrismOptions given{{{"n", "7"}, {"p", "0.25"}, {"b", "true"}}, "two"};
  const Mdp mdp = parse_prism(text, "", {.states = 100}, given);
  EXPECT_EQ(mdp.states(), 8U);
  EXPECT_EQ(mdp.cost(0, 0), 2);
  EXPECT_EQ(mdp.outcomes(0, 0)[0].probability, 0.25);
  for (const PrismOptions& wrong : {PrismOptions{}, PrismOptions{{{"n", "7.5"}, {"p", "1"}, {"b", "true"}}, ""},
                                    PrismOptions{{{"n", "7"}, {"p", "1"}, {"b", "1"}}, ""},
                                    PrismOptions{{{"n", "7"}, {"p", "1"}, {"b", "true"}, {"q", "1"}}, ""},
                                    PrismOptions{{{"n", "7"}, {"p", "1"}, {"b", "true"}}, "three"}})
    EXPECT_THROW(parse_prism(text, "", {.states = 100}, wrong), ltl::SyntaxError);
}

TEST(PrismModules, BeginWhereInitSays) {
  const std::string text =
      "mdp module m x : [0..9]; y : [0..9]; [] true -> true; endmodule label \"l\" = \"here\"; "
      "label \"here\" = x=3; init ";
  const Mdp mdp = parse_prism(text + "x=3 & y=2*x endinit");
  EXPECT_EQ(mdp.name(0), "3,6");
  for (const char* label : {"l", "here"})
    EXPECT_TRUE(mdp.letters()[mdp.initial_letter()].contains(*mdp.letters().vocabulary().find(label)));
  EXPECT_THROW(parse_prism(text + "x=3 endinit"), ltl::SyntaxError);
  EXPECT_THROW(parse_prism(text + "x=30 endinit"), ltl::SyntaxError);
}

constexpr std::string_view walk =
    "mdp const int n; module m x : [0..n] init 1;\n"
    "[slow] x<n -> (x'=x+1); [fast] x<n -> 0.5:(x'=min(x+2,n)) + 0.5:(x'=0);\n"
    "endmodule rewards \"time\" x<n : 1; [fast] true : 2; endrewards\n"
    "rewards \"free\" endrewards";

std::vector<PrismProperty> asked(std::string_view properties) {
  return parse_prism_properties({walk, "walk.nm"}, {properties, "walk.props"}, {{"n", "5"}});
}

TEST(PrismProperties, AreAnswered) {
  const struct {
    std::string_view text;
    double value;
  } rows[] = {{"Pmax=? [ F x=5 ]", 1},
              {"Pmin=? [ F<=2 x>=3 ]", 0.5},
              {"Pmax=? [ F<=1 x>=3 ]", 0.5},
              {"Pmax=? [ F<2 x>=3 ]", 0.5},
              {"Pmin=? [ G[0,1] x<3 ]", 0.5},
              {"Pmax=? [ x<4 U<=4 x=5 ]", 0.5},
              {"Pmin=? [ x<4 U<=2 x=2 ]", 0},
              {"Pmax=? [ x<4 U[1,2] x=3 ]", 1},
              {"Pmax=? [ X x=0 ]", 0.5},
              {"Pmax=? [ F=2 x=3 ]", 1},
              {"Pmax=? [ (F x=0) & (G F x=5) ]", 0.75},
              {"R{\"time\"}min=? [ F x=5 ]", 4},
              {"Rmin=? [ C<=2 ]", 2},
              {"R{\"time\"}max=? [ C<=2 ]", 6},
              {"R{\"time\"}max=? [ I=1 ]", 1},
              {"R{\"free\"}min=? [ F x=5 ]", 0}};
  for (const auto& row : rows) {
    const std::vector<PrismProperty> properties = asked(row.text);
    ASSERT_EQ(properties.size(), 1U) << row.text;
    const PrismProperty& p = properties[0];
    ASSERT_EQ(p.fault, "") << row.text;
    EXPECT_EQ(p.text, row.text);
    const double value = p.steps ? *expected_cost(std::get<Mdp>(p.model->model),
                                                  {*p.steps, p.instantaneous, p.task.query == CaseTask::Query::MaxCost})
                                 : answer(*p.model, p.task, {.explain = false}).value.middle();
    EXPECT_NEAR(value, row.value, 1e-5 * std::max(1.0, row.value)) << row.text << ": " << p.task.formula;
  }
}

TEST(PrismProperties, HaveResultsComparisonsAndFaults) {
  const std::vector<PrismProperty> p = asked(
      "const int k = 3; label \"far\" = x>k;\n// RESULT (n=4): 7\n"
      "// RESULT (n=5): 1/2\n\"name\": Pmax=? [ F \"far\" & x!=5 ];\n"
      "P>=0.5 [ F \"init\" ]\n// RESULT: true\nS=? [ x=1 ]; Pmax=? [ F P=? [ X x=0 ] ]\n"
      "P=? [ F x=5 ]; Pmin=? [ !F x=5 ]; R{\"none\"}min=? [ F x=5 ]; Pmin=?[ F (x=1");
  ASSERT_EQ(p.size(), 8U);
  EXPECT_EQ(p[0].result, "1/2");
  EXPECT_EQ(p[0].text, "\"name\": Pmax=? [ F \"far\" & x!=5 ]");
  EXPECT_EQ(p[1].comparison, ">=");
  EXPECT_EQ(p[1].bound, 0.5);
  EXPECT_EQ(p[1].task.query, CaseTask::Query::MinProbability);
  EXPECT_FALSE(p[1].result.has_value());
  EXPECT_EQ(p[2].result, "true");
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(p[i].fault.empty(), i < 2) << i << ": " << p[i].text;
  EXPECT_TRUE(p[0].model == p[1].model);
}

TEST(PrismProperties, AgreeWithWhatIsSaid) {
  EXPECT_EQ(agrees("1/4", 0.2500001, std::nullopt), true);
  EXPECT_EQ(agrees("0.25", 0.2501, std::nullopt), false);
  EXPECT_EQ(agrees("Infinity", INFINITY, std::nullopt), true);
  EXPECT_EQ(agrees("Infinity", 1e9, std::nullopt), false);
  EXPECT_EQ(agrees("0", 1e-9, std::nullopt), true);
  EXPECT_EQ(agrees("false", 0.3, true), false);
  EXPECT_EQ(agrees("true", 0.3, std::nullopt), std::nullopt);
  EXPECT_EQ(agrees("Error: no", 0.3, std::nullopt), false) << "there is a value";
  EXPECT_EQ(agrees("no error", 0.3, std::nullopt), std::nullopt);
}

}  // namespace
}  // namespace waymark::plan
