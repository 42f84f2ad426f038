// What is written for other tools is read back here, by code of its own, and is the same automaton.
#include "libautomata/hoa/exchange.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "libautomata/hoa/dot_omega.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

const ltl::Vocabulary ab({"a", "b"});

std::string label(ltl::Formula f) {
  std::string out;
  switch (f.op()) {
    case ltl::Op::True: return "t";
    case ltl::Op::False: return "f";
    case ltl::Op::Atom: return std::to_string(f.proposition().index);
    case ltl::Op::Not: return "!(" + label(f[0]) + ")";
    case ltl::Op::And:
    case ltl::Op::Or:
      for (ltl::Formula g : f.operands()) out += (out.empty() ? "(" : f.op() == ltl::Op::And ? "&" : "|") + label(g);
      return out + ")";
    default: ADD_FAILURE() << "no guard"; return "f";
  }
}

struct Line {
  std::string source, target, guard, marks;
};

// The lines as an automaton over a and b; states are numbered as they occur, the initial one first.
Automaton rebuilt(const std::string& initial, const std::vector<Line>& lines, const std::string& acceptance,
                  ltl::Notation notation = ltl::Notation::Infix) {
  std::vector<std::string> states{initial};
  const auto number = [&](const std::string& name) {
    const auto at = std::find(states.begin(), states.end(), name);
    const auto index = static_cast<std::size_t>(at - states.begin());
    if (at == states.end()) states.push_back(name);
    return index;
  };
  std::map<std::size_t, std::string> bodies;
  for (const Line& line : lines) {
    ltl::Arena arena{ab};
    const ltl::Formula guard = ltl::parse(line.guard, arena, {.notation = notation, .unknown = ltl::Unknown::Reject});
    const std::size_t source = number(line.source), target = number(line.target);
    bodies[source] += " [" + label(guard) + "] " + std::to_string(target) + " {" + line.marks + "}";
  }
  std::string text = "HOA: v1 Start: 0 AP: 2 \"a\" \"b\" Acceptance: " + acceptance + " --BODY--";
  for (const auto& [state, body] : bodies) text += " State: " + std::to_string(state) + body;
  return read_omega_hoa(text + " --END--");
}

std::string acceptance_of(const Automaton& a) {
  return std::to_string(a.acceptance().sets) + " " + print(a.acceptance().condition);
}

// HOA of an automaton, the propositions of ab it reads not being all of them: by language on small lassos.
void expect_same(const Automaton& a, const Automaton& b, const std::string& text) {
  EXPECT_EQ(a.states(), b.states()) << text;
  testing::for_each_lasso({.length = 3, .atoms = 2}, [&](const ltl::Lasso& word) {
    ASSERT_EQ(referee::accepts(a, word), referee::accepts(b, word)) << ltl::show(word, ab) << '\n' << text;
  });
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

Automaton from_table(const std::string& text, const std::string& acceptance) {
  std::vector<Line> out;
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::istringstream in(lines[i]);
    Line line;
    std::getline(in, line.source, '\t');
    std::getline(in, line.target, '\t');
    std::getline(in, line.marks, '\t');
    std::getline(in, line.guard);
    for (char& c : line.marks) c = c == ',' || c == '-' ? ' ' : c;
    out.push_back(line);
  }
  return rebuilt("0", out, acceptance);
}

Automaton from_lbtt(const std::string& text, const std::string& acceptance) {
  std::istringstream in(text);
  std::size_t states = 0;
  std::string sets, initial;
  in >> states >> sets;
  std::vector<Line> out;
  for (std::size_t i = 0; i < states; ++i) {
    std::string source, is_initial;
    in >> source >> is_initial;
    if (is_initial == "1") initial = source;
    for (Line line{source, {}, {}, {}}; in >> line.target && line.target != "-1"; line.marks.clear()) {
      for (std::string mark; in >> mark && mark != "-1";) line.marks += mark + ' ';
      std::getline(in, line.guard);
      out.push_back(line);
    }
  }
  return rebuilt(initial, out, acceptance, ltl::Notation::Lbt);
}

Automaton from_never(const std::string& text) {
  std::vector<Line> out;
  std::string source, initial;
  for (const std::string& line : lines_of(text)) {
    if (line.back() == ':') source = line.substr(0, line.size() - 1);
    if (initial.empty()) initial = source;
    const std::size_t arrow = line.find(" -> goto ");
    if (arrow == std::string::npos) continue;
    out.push_back(
        {source, line.substr(arrow + 9), line.substr(5, arrow - 5), source.starts_with("accept_") ? "0" : ""});
  }
  return rebuilt(initial, out, "1 Inf(0)");
}

Automaton from_ba(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  std::set<std::string> accepting;
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (lines[i].find("->") == std::string::npos) accepting.insert(lines[i]);
  std::vector<Line> out;
  for (const std::string& line : lines) {
    const std::size_t arrow = line.find("->"), comma = line.find(',');
    if (arrow == std::string::npos) continue;
    const std::string source = line.substr(comma + 1, arrow - comma - 1);
    out.push_back({source, line.substr(arrow + 2), line.substr(0, comma), accepting.contains(source) ? "0" : ""});
  }
  return rebuilt(lines[0], out, "1 Inf(0)");
}

TEST(Exchange, WhatIsWrittenIsTheSameAutomaton) {
  ltl::Random random(31);
  for (int i = 0; i < 24; ++i) {
    const Automaton a = random_automaton(
        random, ab,
        {.states = static_cast<std::uint32_t>(1 + i % 4), .sets = static_cast<std::uint32_t>(i % 3), .generic = false});
    const std::string table = *write_table(a, 1'000), lbtt = *write_lbtt(a, 1'000);
    expect_same(a, from_table(table, acceptance_of(a)), table);
    expect_same(a, from_lbtt(lbtt, acceptance_of(a)), lbtt);
    Budget budget;
    const Automaton states = *make_state_based(a, budget);
    testing::for_each_lasso({.length = 3, .atoms = 2}, [&](const ltl::Lasso& word) {
      ASSERT_EQ(referee::accepts(a, word), referee::accepts(states, word)) << write_hoa(a);
    });
    const std::string never = *write_never_claim(states, 1'000), ba = *write_ba(states, 1'000);
    expect_same(states, from_never(never), never);
    expect_same(states, from_ba(ba), ba);
  }
}

const char* const response =
    "HOA: v1 Start: 0 AP: 2 \"a\" \"b\" Acceptance: 1 Inf(0) --BODY-- "
    "State: 0 {0} [!0 | 1] 0 [0&!1] 1 State: 1 [1] 0 [!1] 1 --END--";

TEST(Exchange, NamesOfNeverClaimsAreExpressionsOrQuoted) {
  const Automaton odd = read_omega_hoa(
      "HOA: v1 Start: 0 AP: 4 \"guest login\" \"x[1] >= 3\" \"a) || (b\" \"c\" Acceptance: 1 Inf(0) --BODY-- "
      "State: 0 {0} [0 & 1 & !2 & 3] 0 --END--");
  const std::string claim = *write_never_claim(odd, 100);
  EXPECT_NE(claim.find("(\"guest login\" && (x[1] >= 3) && !\"a) || (b\" && c)"), std::string::npos) << claim;
}

TEST(Exchange, NeverClaimsAreWhatSpinReads) {
  EXPECT_EQ(*write_never_claim(read_omega_hoa(response), 100, "G(a -> F b) */ x"),
            "never { /* G(a -> F b)  / x */\n"
            "accept_init:\n"
            "  if\n"
            "  :: ((!a) || (b)) -> goto accept_init\n"
            "  :: ((a && !b)) -> goto T0_S1\n"
            "  fi;\n"
            "T0_S1:\n"
            "  if\n"
            "  :: ((b)) -> goto accept_init\n"
            "  :: ((!b)) -> goto T0_S1\n"
            "  fi;\n"
            "}\n");
}

TEST(Exchange, LbttAndTheTableAreStable) {
  EXPECT_EQ(*write_lbtt(read_omega_hoa(response), 100),
            "2 1t\n0 1\n0 0 -1 i a b\n1 0 -1 & a ! b\n-1\n1 0\n0 -1 b\n1 -1 ! b\n-1\n");
  EXPECT_EQ(*write_table(read_omega_hoa(response), 100),
            "source\ttarget\tmarks\tguard\n0\t0\t0\ta -> b\n0\t1\t0\ta & !b\n1\t0\t-\tb\n1\t1\t-\t!b\n");
}

TEST(Exchange, EdgesAreCountedFirst) {
  const Automaton a = read_omega_hoa(response);
  EXPECT_FALSE(write_table(a, 3) || write_lbtt(a, 3) || write_never_claim(a, 3) || write_ba(a, 7));
  EXPECT_FALSE(write_dot_within(a, 3).has_value());
  EXPECT_TRUE(write_table(a, 4) && write_ba(a, 8));
}

TEST(Exchange, OtherConditionsAreRefused) {
  const Automaton a = read_omega_hoa("HOA: v1 Start: 0 AP: 0 Acceptance: 1 Fin(0) --BODY-- State: 0 [t] 0 --END--");
  Budget budget;
  EXPECT_FALSE(make_state_based(a, budget).has_value());
  EXPECT_THROW(write_never_claim(a, 9), std::invalid_argument);
  EXPECT_THROW(write_lbtt(a, 9), std::invalid_argument);
}

TEST(OmegaDot, GroupsEdgesAndShowsMarksAsDots) {
  const std::string dot = *write_dot_within(read_omega_hoa(response), 100, {.name = "□(a → ◇b)"});
  EXPECT_NE(dot.find("label=<□(a → ◇b)   ·   Inf(0)>"), std::string::npos) << dot;
  EXPECT_NE(dot.find("0 -> 1 [label=<a ∧ ¬b <font color=\"#0072B2\">●<sub>0</sub></font>>];"), std::string::npos)
      << dot;
  const std::string two = *write_dot_within(
      read_omega_hoa("HOA: v1 Start: 0 AP: 1 \"a\" Acceptance: 1 Inf(0) --BODY-- State: 0 [0] 0 {0} [!0] 0 --END--"),
      100);
  EXPECT_NE(two.find("0 -> 0 [label=<¬a<br/>a <font"), std::string::npos) << two;
}

}  // namespace
}  // namespace waymark::automata
