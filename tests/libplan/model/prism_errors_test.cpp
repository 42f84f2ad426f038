// What the readers of PRISM's formats say of models that they cannot take, and where; small models by hand.
#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"
#include "libplan/model/prism/read_prism.hpp"
#include "libplan/model/prism/read_prism_explicit.hpp"

namespace waymark::plan {
namespace {

std::string complaint(const std::string& text) {
  try {
    parse_prism(text);
  } catch (const ltl::SyntaxError& error) {
    return std::to_string(error.line()) + ':' + std::to_string(error.column()) + ": " + error.message();
  }
  return "";
}

TEST(PrismLanguage, SaysWhatIsWrongAndWhere) {
  const struct {
    std::string text, message;
  } rows[] = {
      {"ctmc", "1:1: models of the kind ctmc are not read: mdp and dtmc are"},
      {"mdp module m x : int; endmodule", "1:18: an unbounded integer is not read: give its range, such as [0..9]"},
      {"mdp module m x : clock; endmodule", "1:18: a clock is not read: mdp and dtmc have none"},
      {"mdp module m x : [0..1]; [] true -> [0.1,0.2]:(x'=1); endmodule",
       "1:37: an interval of probabilities is not read: a number is"},
      {"mdp system m endsystem",
       "1:5: system … endsystem is not read: modules run side by side and meet in their actions"},
      {"mdp const int k = 1; dtmc", "1:22: a second kind of model"},
      {"mdp module m x : [0..1]; [] x=0 || x=1 -> true; endmodule",
       "1:34: || is not read: 'or' is written |, and conditional probabilities are not answered"},
      {"mdp\n", "2:1: expected a module"},
      {"mdp module m x : [0..1] endmodule", "1:25: expected ';'"},
      {"mdp module m x : [1..0]; endmodule", "1:14: the range of this variable is empty"},
      {"mdp module m x : [0..1] init 2; endmodule", "1:14: the initial value is out of range"},
      {"mdp module m x : [0..1]; [a] y=1 -> true; endmodule", "1:30: there is no variable, constant or formula 'y'"},
      {"mdp module m x : [0..1]; [a] x -> true; endmodule", "1:30: expected a condition"},
      {"mdp module m x : [0..1]; [a] x=0 -> (x'=x+2); endmodule", "1:41: the variable leaves its range in state 0"},
      {"mdp module m x : [0..1]; [a] x=0 -> 0.5:(x'=1); endmodule",
       "1:26: the probabilities do not add up to 1 in state 0"},
      {"mdp module m x : [0..1]; [a] true -> (z'=1); endmodule", "1:39: there is no variable of this name"},
      {"mdp module m x : [0..1]; [a] true -> (x'=1/2); endmodule", "1:42: expected a whole number"},
      {"mdp formula f = g; formula g = f; module m x : [0..1]; [] f -> true; endmodule",
       "1:17: a formula that needs itself"},
      {"mdp module m x : [0..1]; endmodule module m y : [0..1]; endmodule", "1:43: a second module of this name"},
      {"mdp module m x : [0..1]; endmodule module n y : [0..1]; [] true -> (x'=1); endmodule",
       "1:69: this variable is of another module"},
      {"mdp global g : [0..1]; module m [a] true -> (g'=1); endmodule module n [a] true -> true; endmodule",
       "1:46: a command with an action assigns a global variable, which others may assign at once"},
      {"mdp module m x : [0..1]; endmodule module n = k [x=y] endmodule", "1:47: there is no module of this name"},
      {"mdp module m x : [0..1]; endmodule module n = m [z=y] endmodule", "1:47: this name has a meaning already"},
      {"mdp module m x : [0..1]; endmodule label \"\" = x=0;", "1:42: a label needs a name"},
      {"mdp const int k; module m x : [0..k]; endmodule", "1:15: the constant k has no value: give one with --const"},
      {"mdp module m x : [0..9]; [a] true -> true; [a] true -> true; endmodule module n = m [x=n1] endmodule "
       "module o = m [x=o1] endmodule module p = m [x=p1] endmodule module q = m [x=q1] endmodule "
       "module r = m [x=r1] endmodule module s = m [x=s1] endmodule module t = m [x=t1] endmodule "
       "module u = m [x=u1] endmodule module v = m [x=v1] endmodule module w = m [x=w1] endmodule "
       "module x1 = m [x=x2] endmodule module y = m [x=y1] endmodule module z = m [x=z1] endmodule "
       "module a1 = m [x=a2] endmodule module b = m [x=b1] endmodule module c = m [x=c1] endmodule "
       "module d = m [x=d1] endmodule",
       "1:26: modules meet here in more than 100,000 ways"},
      {"mdp module m x : [0..1]; [] \"l\" -> true; endmodule", "1:29: there is no label \"l\""},
      {"mdp const int x = 1; module m x : [0..1]; endmodule", "1:31: this name has a meaning already"},
      {"mdp module m x : [0..1]; [max] true -> true; endmodule", "1:27: expected the name of an action"},
      {"mdp module m x : [0..mod(1,0)]; endmodule", "1:22: mod by a number that is not positive"},
      {"mdp module m x : [0..1]; y : [0..x]; endmodule", "1:34: a variable where a constant is expected"},
      {"mdp module m x : [0..1]; [] x=$ -> true; endmodule", "1:31: a character that the language does not have"},
      {"mdp rewards \"r\" true : -1; endrewards module m x : [0..1]; [] true -> true; endmodule",
       "1:60: a reward that is negative or infinite in state 0"},
  };
  for (const auto& row : rows) EXPECT_EQ(complaint(row.text), row.message) << row.text;
}

TEST(PrismLanguage, ReadsEveryOperator) {
  const struct {
    std::string condition;
    bool holds;  // with x = 3
  } rows[] = {{"x=3", true},          {"x!=3", false},          {"!x=4", true},         {"x<3|x>=3", true},
              {"x<=2&true", false},   {"x>3=>false", true},     {"x=3<=>x>2", true},    {"(x=3?1:2)=1", true},
              {"-x+4=1", true},       {"2*x-1=5", true},        {"x/2=1.5", true},      {"mod(x-5,4)=2", true},
              {"min(x,7,2)=2", true}, {"max(x,1)=3", true},     {"floor(x/2)=1", true}, {"ceil(x/2)=2", true},
              {"pow(x,2)=9", true},   {"b & !(b & x=2)", true}, {"x=n+1", true},        {"1e0=1.0E+0", true}};
  for (const auto& row : rows) {
    const Mdp mdp = parse_prism("mdp const int n = 2; module m b : bool init true; x : [0..3] init 3; [go] " +
                                row.condition + " -> (x'=0) & (b'=false); endmodule");
    EXPECT_EQ(mdp.states() == 2, row.holds) << row.condition;
  }
}

TEST(PrismLanguage, StaysWhereNoCommandIsEnabled) {
  const Mdp mdp = parse_prism(
      "mdp // two states\nmodule m x : [0..1]; [go] x=0 -> 0.5:(x'=1) + 0.5:true; endmodule\n"
      "rewards \"fuel\" true : 7; endrewards rewards \"steps\" [go] x=0 : 2; x=1 : 3; endrewards\n"
      "label \"one\" = x=1;");
  ASSERT_EQ(mdp.states(), 2U);
  EXPECT_EQ(mdp.action(1, 0), "stay");
  EXPECT_EQ(mdp.cost(0, 0), 2);
  EXPECT_EQ(mdp.cost(1, 0), 3);
  EXPECT_EQ(mdp.name(1), "1");
  EXPECT_TRUE(mdp.letters()[mdp.outcomes(1, 0)[0].letter].contains(ltl::Proposition{0}));
}

std::string complaint(const PrismFiles& files) {
  try {
    parse_prism_explicit(files, "m");
  } catch (const ltl::FormatError& error) {
    const std::string what = error.what();  // the message, then the place on a line of its own
    const std::size_t end = what.find("\n  ");
    return what.substr(end + 3) + ": " + what.substr(0, end);
  }
  return "";
}

TEST(PrismExplicit, SaysWhatIsWrongAndWhere) {
  const std::string transitions = "2 2 3\n0 0 0 0.5 go\n0 0 1 0.5 go\n1 0 1 1 go\n",
                    labels = "0=\"init\" 1=\"a\"\n0: 0\n1: 1\n";
  const struct {
    PrismFiles files;
    std::string message;
  } rows[] = {
      {{"", labels}, "m.tra:1:1: expected the numbers of states, choices and transitions"},
      {{"1 1\n0 0 1\n", labels},
       "m.tra:1:4: two numbers: a Markov chain; what is read is an mdp (states, choices, transitions)"},
      {{"2 1 1\n0 0 2 1\n", labels}, "m.tra:2:5: there is no state 2"},
      {{"2 1 1\n0 0 1 half\n", labels}, "m.tra:2:7: expected a number"},
      {{"2 1 2\n0 0 1 1\n", labels}, "m.tra:1:1: the first line promises 2 transitions, there are 1"},
      {{"2 1 1\n0 0 1 0.5\n", labels}, "m.tra: state 0: the probabilities of a choice do not add up to 1"},
      {{transitions, "0=\"a\"\n"}, "m.lab:1:6: there is no label \"init\""},
      {{transitions, "0=\"init\"\n0: 0\n1: 0\n"}, "m.lab:3:5: a second initial state"},
      {{transitions, "0=\"init\"\n1: 3\n"}, "m.lab:2:5: there is no label 3"},
      {{transitions, "0=\"init\"\n"}, "m.lab:1:1: no state has the label \"init\""},
      {{transitions, labels, {}, "3 1\n0 1\n"},
       "m.srew:1:2: this file and m.tra do not belong together: 3 states here, and 2 there"},
      {{transitions, labels, {}, "2 2\n0 1\n"}, "m.srew:2:1: the first line promises 2 rewards, there are 1"},
      {{transitions, labels, {}, {}, "2 3 1\n0 0 0 1\n"},
       "m.trew:1:4: this file and m.tra do not belong together: 3 choices here, and 2 there"},
      {{transitions, labels, {}, {}, "2 2 1\n0 1 0 1\n"},
       "m.trew:2:8: a reward of a transition that m.tra does not have"},
      {{transitions, labels, "(s)\n0:(0)\n"},
       "m.sta:2:1: this file and m.tra do not belong together: 1 states here, and 2 there"},
  };
  for (const auto& row : rows) EXPECT_EQ(complaint(row.files), row.message);
  EXPECT_EQ(complaint(PrismFiles{transitions, labels}), "");
}

TEST(Prism, ReadingEndsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const char* text = "mdp module m x : [0..9] init 0; [] x < 9 -> (x'=x+1); endmodule";
  EXPECT_EQ(parse_prism(text).states(), 10U);
  EXPECT_THROW(parse_prism(text, "", {.stop = source.get_token()}), ReadingStopped);
}

TEST(PrismExplicit, AddsUpWhatIsToBeExpected) {
  PrismFiles files{"3 2 3\n0 0 1 0.25\n0 0 2 0.75\n1 0 0 1 back\n", "0=\"init\"\n0: 0\n", {}, {}, {}};
  EXPECT_EQ(parse_prism_explicit(files).cost(0, 0), 1);
  EXPECT_EQ(parse_prism_explicit(files).cost(2, 0), 1);
  files.state_rewards = "3 2\n0 1\n2 5\n";
  files.transition_rewards = "3 2 2\n0 0 1 4\n0 0 2 8\n";
  const Mdp mdp = parse_prism_explicit(files);
  EXPECT_EQ(mdp.cost(0, 0), 1 + 0.25 * 4 + 0.75 * 8);
  EXPECT_EQ(mdp.cost(1, 0), 0);
  EXPECT_EQ(mdp.cost(2, 0), 5);
  EXPECT_EQ(mdp.action(1, 0), "back");
  EXPECT_EQ(mdp.action(2, 0), "stay");
}

}  // namespace
}  // namespace waymark::plan
