#include "libautomata/finite/ltlf_to_dfa.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "libautomata/finite/guard.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libltl/limits.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

Dfa translate(const std::string& text, ltl::Dialect dialect = ltl::Dialect::Waymark) {
  ltl::Arena arena;
  return ltlf_to_dfa(ltl::parse(text, arena, {.dialect = dialect}));
}

std::string p(std::size_t i) { return "p" + std::to_string(i); }

std::string visit_all(std::size_t n) {
  std::string out = "F p1";
  for (std::size_t i = 2; i <= n; ++i) out += " & F " + p(i);
  return out;
}

std::string chain(std::size_t n) {  // F (p1 & X F (p2 & …))
  std::string out = "F " + p(n);
  for (std::size_t i = n - 1; i >= 1; --i) out = "F (" + p(i) + " & X " + out + ")";
  return out;
}

std::string responses(std::size_t n) {
  std::string out;
  for (std::size_t i = 1; i <= n; ++i)
    out += (i > 1 ? " & " : "") + std::string("G (a") + std::to_string(i) + " -> F b" + std::to_string(i) + ")";
  return out;
}

std::string ordered_visits(std::size_t n) {
  std::string out = "F " + p(n);
  for (std::size_t i = 1; i < n; ++i) out += " & (!" + p(i + 1) + " U " + p(i) + ")";
  return out;
}

TEST(LtlfToDfa, GivesTheMinimalCompleteAutomaton) {
  const struct {
    const char* formula;
    std::size_t states;
  } table[] = {
      {"false", 1},  // the trap
      {"true", 2},   // the initial state rejects the empty word
      {"a", 3},
      {"!a", 3},
      {"X true", 3},   // at least two letters
      {"N false", 3},  // exactly one
      {"X a", 4},
      {"N a", 4},
      {"F a", 2},
      {"G a", 3},
      {"a U b", 3},
      {"a R b", 4},
      {"F a & F b", 4},
      {"F (a & X F b)", 3},
      {"G F a", 2},
      {"F G a", 2},  // over finite words: the last letter has a
      {"G (a -> F b)", 3},
      {"a <-> b", 3},
      {"F (a & !a)", 1},
      {"F a | G !a", 2},
      {"G (a -> X b)", 4},
      {"F<=2 a", 5},
  };
  for (const auto& row : table) EXPECT_EQ(translate(row.formula).states(), row.states) << row.formula;
}

TEST(LtlfToDfa, FamiliesGrowAsTheTheorySays) {
  for (std::size_t n = 1; n <= 8; ++n) {
    EXPECT_EQ(translate(visit_all(n)).states(), std::size_t{1} << n) << visit_all(n);
    EXPECT_EQ(translate(chain(n + 1)).states(), n + 2) << chain(n + 1);
    EXPECT_EQ(translate(ordered_visits(n + 1)).states(), n + 3) << ordered_visits(n + 1);
    EXPECT_EQ(translate(responses(n)).states(), (std::size_t{1} << n) + 1) << responses(n);
  }
}

TEST(LtlfToDfa, BreaksTheWallsOfExplicitEdges) {
  constexpr std::size_t n = testing::sanitized ? 12 : 18;
  EXPECT_EQ(translate(visit_all(n)).states(), std::size_t{1} << n) << "3^18 edges, were they written down";
  EXPECT_EQ(translate(visit_all(n - 2) + " & G !z").states(), (std::size_t{1} << (n - 2)) + 1);
  EXPECT_EQ(translate(responses(n - 2)).states(), (std::size_t{1} << (n - 2)) + 1);
  EXPECT_EQ(translate(chain(128)).states(), 129U);
  EXPECT_EQ(translate(ordered_visits(128)).states(), 130U);
}

TEST(LtlfToDfa, DialectsDifferInThePlainNext) {
  EXPECT_EQ(translate("X a").states(), translate("X[!] a", ltl::Dialect::Spot).states());
  EXPECT_EQ(write_hoa(translate("N a")), write_hoa(translate("X a", ltl::Dialect::Spot)));
  EXPECT_NE(write_hoa(translate("X a")), write_hoa(translate("X a", ltl::Dialect::Spot)));
}

TEST(LtlfToDfa, BytesDoNotDependOnTheArenasPast) {
  ltl::Arena fresh(ltl::Vocabulary({"a", "b", "c"})), used(ltl::Vocabulary({"a", "b", "c"}));
  for (const char* before : {"F c", "G (b -> X c)", "b U a", "F b & G !c"}) ltl::parse(before, used);
  for (const char* text : {"F a & (b U c)", "G (a -> X (b & F c))", "(a U b) U c", "F a <-> G b"})
    EXPECT_EQ(write_hoa(ltlf_to_dfa(ltl::parse(text, fresh))), write_hoa(ltlf_to_dfa(ltl::parse(text, used)))) << text;
}

TEST(LtlfToDfa, StopsAtTheLimitOfStates) {
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(visit_all(12), arena);
  const auto limited = ltlf_to_dfa(f, {.states = 100});
  ASSERT_TRUE(std::holds_alternative<Exhausted>(limited));
  EXPECT_GT(std::get<Exhausted>(limited).states, 100U);
  EXPECT_TRUE(std::holds_alternative<Dfa>(ltlf_to_dfa(f, {.states = 1'000'000})));
}

TEST(LtlfToDfa, StopsSoonAfterItIsAskedTo) {
  using Clock = std::chrono::steady_clock;
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(visit_all(40), arena);  // 2^40 states: never done
  std::stop_source source;
  std::jthread timer([&source] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    source.request_stop();
  });
  const auto begin = Clock::now();
  const auto outcome = ltlf_to_dfa(f, {.states = SIZE_MAX, .stop = source.get_token()});
  EXPECT_TRUE(std::holds_alternative<Exhausted>(outcome));
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(2)) << "0.05 s, and time for a busy machine";
}

TEST(LtlfToDfa, ReadsDeepAndWideFormulas) {
  constexpr std::size_t depth = testing::sanitized ? 500 : 4000;  // sanitizers make frames several times larger
  std::string nested = "a";
  for (std::size_t i = 0; i < depth; ++i) nested = "X " + nested;
  EXPECT_EQ(translate(nested).states(), depth + 3);
  std::string wide = "p0";
  for (std::size_t i = 1; i < depth; ++i) wide += " & " + p(i);
  const Dfa dfa = translate(wide);
  EXPECT_EQ(dfa.states(), 3U);
  EXPECT_EQ(write_hoa(read_hoa(write_hoa(dfa))), write_hoa(dfa));
}

TEST(LtlfToDfa, LongChainsHaveAStateForEveryLink) {
  ltl::Arena arena;
  ltl::Formula f = arena.atom("a");
  for (int i = 0; i < 9'000; ++i) f = ltl::next(f);
  const auto made = ltlf_to_dfa(f, ltl::Limits{});
  ASSERT_TRUE(std::holds_alternative<Dfa>(made));
  EXPECT_EQ(std::get<Dfa>(made).states(), 9'003U);  // before the letter, the good and the bad end
}

TEST(LtlfToDfa, SaysWhenAFormulaIsTooLargeForADiagram) {
  ltl::Arena arena;
  ltl::Formula f = arena.atom("a");
  for (int i = 0; i < 17'000; ++i) f = ltl::next(f);
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltlf_to_dfa(f, ltl::Limits{})));
  EXPECT_THROW(ltlf_to_dfa(f), std::length_error);
}

}  // namespace
}  // namespace waymark::automata
