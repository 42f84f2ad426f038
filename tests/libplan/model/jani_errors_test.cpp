// What the reader of JANI says of documents that it cannot take, and where.
#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"
#include "libplan/model/jani/read_jani.hpp"

namespace waymark::plan {
namespace {

struct Parts {  // of a document that is read, one of them replaced
  std::string type = R"("mdp")", constants = "[]", variables = R"([{"name":"x","type":"int","initial-value":0}])",
              functions = "[]", edge = R"({"location":"l","destinations":[{"location":"m"}]})",
              locations = R"([{"name":"l"},{"name":"m"}])", initial = R"(["l"])",
              system = R"({"elements":[{"automaton":"a"}]})", more = "";
  std::string text() const {
    return R"({"jani-version":1,"name":"m","type":)" + type + R"(,"constants":)" + constants + R"(,"variables":)" +
           variables + R"(,"functions":)" + functions + R"(,"actions":[{"name":"go"}],"automata":[{"name":"a",)" +
           R"("locations":)" + locations + R"(,"initial-locations":)" + initial + R"(,"edges":[)" + edge +
           R"(]}],"system":)" + system + more + "}";
  }
};

std::string complaint_about(const std::string& text) {
  try {
    parse_jani(text);
  } catch (const ltl::FormatError& error) {
    const std::string what = error.what();
    return what.substr(0, what.find('\n'));
  }
  return "";
}

std::string guarded(const std::string& guard) {
  return R"({"location":"l","guard":{"exp":)" + guard + R"(},"destinations":[{"location":"m"}]})";
}
std::string assigned(const std::string& assignments) {
  return R"({"location":"l","destinations":[{"location":"m","assignments":[)" + assignments + "]}]}";
}

TEST(JaniErrors, SayWhatIsWrongAndWhere) {
  const auto with = [](std::string Parts::*part, const std::string& text) {
    Parts parts;
    parts.*part = text;
    return parts.text();
  };
  const std::string edge = "automata[0].edges[0]";
  const std::pair<std::string, std::string> rows[] = {
      {Parts().text(), ""},
      {"[]", "expected an object"},
      {with(&Parts::type, R"("ctmc")"), "type: expected 'mdp' or 'dtmc': models of these kinds are read"},
      {with(&Parts::more, R"(,"clocks":[])"),
       "clocks: the key \"clocks\" is not read here: what is read is docs/formats/prism.md"},
      {with(&Parts::more, R"(,"x-clocks":[],"comment":"none")"), ""},
      {with(&Parts::constants, R"([{"name":"c","type":"int"}])"),
       "constants[0].name: the constant c has no value: give one with --const"},
      {with(&Parts::constants, R"([{"name":"c","type":"int","value":"x"}])"),
       "constants[0].value: there is no variable or constant 'x'"},
      {with(&Parts::constants, R"([{"name":"x","type":"int","value":1}])"),
       "variables[0].name: the name 'x' has a meaning already"},
      {with(&Parts::variables, R"([{"name":"x","type":"real","initial-value":0}])"),
       "variables[0].type: a real variable is read where it is transient: states are to be finitely many"},
      {with(&Parts::variables, R"([{"name":"x","type":"clock","initial-value":0}])"),
       "variables[0].type: the type 'clock' is not read: bool, int, bounded int and real are"},
      {with(&Parts::variables, R"([{"name":"x","type":{"kind":"array","base":"int"}}])"),
       "variables[0].type.kind: the kind 'array' is not read: bounded is"},
      {with(&Parts::variables, R"([{"name":"x","type":{"kind":"bounded","base":"int","upper-bound":-2e9}}])"),
       "variables[0].type.upper-bound: expected a whole number"},
      {with(&Parts::variables,
            R"([{"name":"x","type":{"kind":"bounded","base":"int","lower-bound":3,"upper-bound":2}}])"),
       "variables[0].type: the range is empty"},
      {with(&Parts::variables, R"([{"name":"x","type":"int"}])"), "several initial states: models with one are read"},
      {with(&Parts::variables, R"([{"name":"x","type":"bool"}])"), "several initial states: models with one are read"},
      {with(&Parts::initial, R"(["l","m"])"),
       "automata[0].initial-locations[1]: several initial states: models with one are read"},
      {with(&Parts::initial, R"([])"), "automata[0].initial-locations: expected an initial location"},
      {with(&Parts::initial, R"(["n"])"), "automata[0].initial-locations[0]: there is no location of this name"},
      {with(&Parts::more, R"(,"restrict-initial":{"exp":false})"), "restrict-initial.exp: no state satisfies this"},
      {with(&Parts::locations, R"([{"name":"l","time-progress":{"exp":true}},{"name":"m"}])"),
       "automata[0].locations[0].time-progress: the key \"time-progress\" is not read here: what is read is "
       "docs/formats/prism.md"},
      {with(&Parts::locations, R"([{"name":"l","transient-values":[{"ref":"x","value":1}]},{"name":"m"}])"),
       "automata[0].locations[0].transient-values[0].ref: this variable is not transient"},
      {with(&Parts::edge, R"({"location":"l","rate":{"exp":1},"destinations":[{"location":"m"}]})"),
       edge + ".rate: the key \"rate\" is not read here: what is read is docs/formats/prism.md"},
      {with(&Parts::edge, R"({"location":"l","destinations":[]})"), edge + ": an edge that leads nowhere"},
      {with(&Parts::edge, R"({"location":"l","action":"stop","destinations":[{"location":"m"}]})"),
       edge + ".action: there is no action 'stop'"},
      {with(&Parts::edge, R"({"location":"l","destinations":[{"location":"m","probability":{"exp":0.5}}]})"),
       edge + ": the probabilities do not add up to 1 in state 0,0"},
      {with(&Parts::edge, guarded("1")), edge + ".guard.exp: expected a condition"},
      {with(&Parts::edge, guarded(R"({"op":"<","left":"x"})")), edge + ".guard.exp: the key \"right\" is missing"},
      {with(&Parts::edge, guarded(R"({"op":"<","left":"x","right":true})")),
       edge + ".guard.exp.right: expected a number"},
      {with(&Parts::edge, guarded(R"({"op":"sin","exp":"x"})")),
       edge + ".guard.exp.op: the operator 'sin' is not read here: what is read is docs/formats/prism.md"},
      {with(&Parts::edge, guarded(R"({"op":"call","function":"f","args":[]})")),
       edge + ".guard.exp.function: there is no function 'f'"},
      {with(&Parts::edge, guarded(R"({"distribution":"Uniform","args":[0,1]})")),
       edge + ".guard.exp: the key \"op\" is missing"},
      {with(&Parts::edge, assigned(R"({"ref":"y","value":1})")),
       edge + ".destinations[0].assignments[0].ref: there is no variable of this name"},
      {with(&Parts::edge, assigned(R"({"ref":{"op":"aa","exp":"x","index":0},"value":1})")),
       edge + ".destinations[0].assignments[0].ref: expected the name of a variable"},
      {with(&Parts::edge, assigned(R"({"ref":"x","value":0.5})")),
       edge + ".destinations[0].assignments[0].value: expected a whole number"},
      {with(&Parts::edge, assigned(R"({"ref":"x","value":2000000000})")),
       edge + ".destinations[0].assignments[0].value: the variable leaves its range in state 0,0"},
      {with(&Parts::edge, assigned(R"({"ref":"x","value":1},{"ref":"x","value":2})")),
       edge + ".destinations[0].assignments[1].ref: the variable is assigned twice at once"},
      {with(&Parts::edge, assigned(R"({"ref":"x","value":1,"index":-1})")),
       edge + ".destinations[0].assignments[0].index: expected a whole number from 0 to 1,000,000"},
      {with(&Parts::system, R"({"elements":[]})"), "system: expected an automaton"},
      {with(&Parts::system, R"({"elements":[{"automaton":"b"}]})"),
       "system.elements[0].automaton: there is no automaton of this name"},
      {with(&Parts::system, R"({"elements":[{"automaton":"a","input-enable":["go"]}]})"),
       "system.elements[0].input-enable[0]: input-enabled actions are not read"},
      {with(&Parts::system, R"({"elements":[{"automaton":"a"}],"syncs":[{"synchronise":["go","go"]}]})"),
       "system.syncs[0]: expected an action, or null, for each element"},
      {with(&Parts::system, R"({"elements":[{"automaton":"a"}],"syncs":[{"synchronise":[null]}]})"),
       "system.syncs[0]: no automaton takes part"},
  };
  for (const auto& [text, message] : rows) EXPECT_EQ(complaint_about(text), message) << text;
}

// Of composed automata: a variable of both is assigned by one of them.
TEST(JaniErrors, AreFoundInSteps) {
  Parts parts;
  parts.edge =
      R"({"location":"l","action":"go","destinations":[{"location":"m","assignments":[{"ref":"x","value":1}]}]})";
  parts.system = R"({"elements":[{"automaton":"a"},{"automaton":"a"}],"syncs":[{"synchronise":["go","go"]}]})";
  EXPECT_EQ(complaint_about(parts.text()),
            "automata[0].edges[0].destinations[0].assignments[0].ref: two automata assign this variable at once");
  parts.system = R"({"elements":[{"automaton":"a"},{"automaton":"a"}]})";
  EXPECT_EQ(complaint_about(parts.text()),
            "system: the key \"syncs\" is missing: edges of several automata have actions");
}

// Depth, and what functions amount to, are bounded.
TEST(JaniErrors, BoundWhatIsWrittenOut) {
  Parts parts;
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += R"({"op":"¬","exp":)";
  parts.edge = guarded(deep + "true" + std::string(100'000, '}'));
  EXPECT_NE(complaint_about(parts.text()).find("this is nested too deeply"), std::string::npos);
  const auto doubling = [](int functions, const std::string& first, const std::string& body) {
    Parts made;
    made.functions = R"([{"name":"f0","type":"int","parameters":[{"name":"n","type":"int"}],"body":)" + first + "}";
    for (int i = 1; i <= functions; ++i) {
      const std::string call = R"({"op":"call","function":"f)" + std::to_string(i - 1) + R"(","args":[)";
      made.functions +=
          R"(,{"name":"f)" + std::to_string(i) + R"(","type":"int","parameters":[{"name":"n","type":"int"}],)";
      made.functions += R"("body":)" + call + (body.empty() ? call + R"("n"]})" : body) + "]}}";
    }
    made.functions += "]";
    made.edge = guarded(R"({"op":"=","left":{"op":"call","function":"f)" + std::to_string(functions) +
                        R"(","args":["x"]},"right":0})");
    return complaint_about(made.text());
  };
  const std::string sum = R"({"op":"+","left":"n","right":"n"})";
  EXPECT_EQ(doubling(3, sum, ""), "");
  EXPECT_NE(doubling(40, R"("n")", "").find("more than 100,000 operators"), std::string::npos);
  EXPECT_NE(doubling(40, sum, sum).find("more than 100,000 operators"), std::string::npos);
  parts = {};
  parts.functions = R"([{"name":"f","type":"int","body":{"op":"call","function":"f"}}])";
  parts.edge = guarded(R"({"op":"=","left":{"op":"call","function":"f"},"right":0})");
  EXPECT_EQ(complaint_about(parts.text()), "functions[0].body: a function that calls itself");
}

}  // namespace
}  // namespace waymark::plan
