// What a HOA file says of its automaton, found to be untrue, or left alone.
#include "libautomata/hoa/claims.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"

namespace waymark::automata {
namespace {

// "deterministic: state 0 has two edges for one letter; …", or "" when nothing is wrong.
std::string found(const std::string& headers, const std::string& body) {
  const std::string text = "HOA: v1\n" + headers + "\n--BODY--\n" + body + "\n--END--\n";
  HoaAutomaton automaton = parse_hoa(text, "test");
  std::string out;
  for (const HoaContradiction& c : contradictions(automaton))
    out += (out.empty() ? "" : "; ") + std::string(c.claim.text) + ": " + c.reason;
  return out;
}

const std::string two = "States: 2 Start: 0 AP: 1 \"a\" ";

TEST(HoaClaims, AboutLabelsAndMarks) {
  const std::string on_edges = "State: 0 {0} [0] 1 [!0] 0 State: 1 [t] 1";
  const std::string buchi = "Acceptance: 1 Inf(0) ";
  EXPECT_EQ(
      found(two + buchi + "properties: trans-labels explicit-labels state-acc no-univ-branch", on_edges), "");
  EXPECT_EQ(found(two + buchi + "properties: state-labels", on_edges),
            "state-labels: state 0 has labels on its edges, or none");
  EXPECT_EQ(found(two + buchi + "properties: implicit-labels", on_edges),
            "implicit-labels: state 0 has labels");
  EXPECT_EQ(found(two + buchi + "properties: trans-acc", on_edges), "trans-acc: state 0 has marks itself");
  EXPECT_EQ(found(two + buchi + "properties: univ-branch", on_edges),
            "univ-branch: there is no universal branch");
  EXPECT_EQ(found(two + buchi + "properties: state-acc", "State: 0 [t] 0 {0}"),
            "state-acc: state 0 has marks on an edge");
  EXPECT_EQ(found(two + buchi + "properties: explicit-labels", "State: 0 0 1"),
            "explicit-labels: state 0 has edges without labels");
  EXPECT_EQ(found(two + buchi + "properties: trans-labels", "State: [0] 0 0"),
            "trans-labels: state 0 has a label itself");
  EXPECT_EQ(found(two + buchi + "properties: no-univ-branch", "State: 0 [t] 0&1"),
            "no-univ-branch: state 0 has a universal branch");
  EXPECT_EQ(found("Start: 0&1 " + buchi + "properties: no-univ-branch", ""),
            "no-univ-branch: the initial states are a conjunction");
  EXPECT_EQ(found(two + buchi + "properties: univ-branch", "State: 0 [t] 0&1"), "");
}

TEST(HoaClaims, AboutDeterminismAndCompleteness) {
  const std::string all = two + "Acceptance: 0 t properties: deterministic complete";
  EXPECT_EQ(found(all, "State: 0 [0] 1 [!0] 0 State: 1 [t] 1"), "");
  EXPECT_EQ(found(all, "State: 0 [0] 1 [t] 0 State: 1 [t] 1"),
            "deterministic: state 0 has two edges for one letter");
  EXPECT_EQ(found(all, "State: 0 [0] 1 [!0] 0 State: 1 [0] 1"),
            "complete: state 1 has no edge for some letter");
  EXPECT_EQ(found(all, "State: 0 [t] 1"), "complete: state 1 has no edges");
  EXPECT_EQ(found(all + " Start: 1", "State: 0 [t] 0 State: 1 [t] 1"),
            "deterministic: there are several initial states");
  EXPECT_EQ(found("AP: 0 Acceptance: 0 t properties: complete", ""), "complete: there is no initial state");
}

TEST(HoaClaims, AboutWeakness) {
  const std::string weak = two + "Acceptance: 1 Inf(0) properties: weak very-weak terminal";
  EXPECT_EQ(found(weak, "State: 0 [!0] 0 [0] 1 State: 1 {0} [t] 1"), "");
  EXPECT_EQ(found(weak, "State: 0 [!0] 1 State: 1 [t] 0"), "very-weak: states 0 and 1 reach each other");
  EXPECT_EQ(found(weak, "State: 0 [!0] 0 [0] 0 {0}"),
            "weak: edges among state 0 and its component have different marks; "
            "very-weak: edges among state 0 and its component have different marks");
  EXPECT_EQ(found(weak, "State: 0 {0} [!0] 0 [0] 1 State: 1 [t] 1"),
            "terminal: the cycle of state 1 rejects and lies behind one that accepts");
  EXPECT_EQ(found(two + "Acceptance: 2 Inf(0) properties: colored", "State: 0 {0} [t] 0 {1}"),
            "colored: state 0 has an edge with no mark or several");
  EXPECT_EQ(found(two + "Acceptance: 2 Inf(0) properties: colored", "State: 0 {0} [t] 0 {0}"), "");
  EXPECT_EQ(found(two + "Acceptance: 1 Inf(0) properties: weak", "State: 0 [f] 0 {0} [t] 0"), "")
      << "an edge with the label f is no edge";
}

TEST(HoaClaims, AboutTheNameOfTheAcceptance) {
  const auto named = [](const std::string& name, const std::string& acceptance) {
    return found("acc-name: " + name + " Acceptance: " + acceptance, "");
  };
  const std::pair<const char*, const char*> right[] = {
      {"all", "0 t"},
      {"none", "0 f"},
      {"Buchi", "1 Inf(0)"},
      {"co-Buchi", "1 Fin(0)"},
      {"generalized-Buchi 3", "3 Inf(0)&Inf(1)&Inf(2)"},
      {"generalized-co-Buchi 2", "2 Fin(0)|Fin(1)"},
      {"Rabin 2", "4 (Fin(0)&Inf(1))|(Fin(2)&Inf(3))"},
      {"Streett 2", "4 (Fin(0)|Inf(1))&(Fin(2)|Inf(3))"},
      {"generalized-Rabin 2 1 2", "5 (Fin(0)&Inf(1))|(Fin(2)&Inf(3)&Inf(4))"},
      {"parity min odd 5", "5 Fin(0)&(Inf(1)|(Fin(2)&(Inf(3)|Fin(4))))"},
      {"parity min even 3", "3 Inf(0) | Fin(1) & Inf(2)"},
      {"parity max odd 3", "3 Fin(2) & (Inf(1) | Fin(0))"},
      {"parity max even 4", "4 Fin(3) & (Inf(2) | Fin(1) & Inf(0))"},
      {"someone-elses-name 3", "2 Inf(0)"},
  };
  for (const auto& [name, acceptance] : right) EXPECT_EQ(named(name, acceptance), "") << name;
  EXPECT_EQ(named("Buchi", "2 Inf(0)"), "Buchi: it has 1 sets, not 2");
  EXPECT_EQ(named("Buchi", "1 Fin(0)"), "Buchi: its condition is not the one of 'Acceptance:'");
  EXPECT_EQ(named("Buchi", "1 Inf(!0)"), "Buchi: it has no complemented sets");
  EXPECT_EQ(named("Buchi 1", "1 Inf(0)"), "Buchi: this name does not take these parameters");
  EXPECT_EQ(named("parity min odd", "1 Fin(0)"), "parity: this name does not take these parameters");
  EXPECT_EQ(named("Rabin 1", "2 (Inf(0)&Fin(1))"), "Rabin: its condition is not the one of 'Acceptance:'");
  EXPECT_EQ(named("parity min odd 3", "3 Fin(0)&(Inf(1)|Inf(2))"),
            "parity: its condition is not the one of 'Acceptance:'");
}

TEST(HoaClaims, PointAtTheClaim) {
  const std::string text =
      "HOA: v1 Start: 0 AP: 0 Acceptance: 0 t\nproperties: complete\n  deterministic --BODY--\n"
      "State: 0 [t] 0 [t] 1 State: 1 [t] 1 --END--";
  HoaAutomaton automaton = parse_hoa(text, "test");
  const std::vector<HoaContradiction> all = contradictions(automaton);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].claim.line, 3U);
  EXPECT_EQ(all[0].claim.column, 3U);
}

}  // namespace
}  // namespace waymark::automata
