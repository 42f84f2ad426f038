#include "libparser/programs/postfix_grammar.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

const ltl::Vocabulary small({"a", "b", "c", "moved", "turned_left", "turned_right"});

std::vector<Token> allowed_tokens(const PostfixGrammar& grammar, const PrefixState& state) {
  std::vector<Token> out;
  for (std::size_t t = 0; t < grammar.tokens(); ++t)
    if (grammar.allowed(state, static_cast<Token>(t))) out.push_back(static_cast<Token>(t));
  return out;
}

// visit(tokens, state) for every well-typed prefix of at most `length` tokens.
template <class Visit>
void for_each_prefix(const PostfixGrammar& grammar, std::size_t length, const Visit& visit) {
  std::vector<Token> tokens;
  const auto extend = [&](const auto& self, const PrefixState& state) -> void {
    visit(tokens, state);
    if (tokens.size() == length) return;
    for (Token t : allowed_tokens(grammar, state)) {
      tokens.push_back(t);
      self(self, grammar.after(state, t));
      tokens.pop_back();
    }
  };
  extend(extend, PrefixState{});
}

class PostfixGrammarIn : public ::testing::TestWithParam<PostfixGrammar::Limits> {};

INSTANTIATE_TEST_SUITE_P(Dialects, PostfixGrammarIn,
                         ::testing::Values(PostfixGrammar::limits_of(Dialect::Plain),
                                           PostfixGrammar::Limits{3, 2, Dialect::Temporal}),
                         [](const auto& parameter) {
                           return parameter.param.dialect == Dialect::Plain ? "Plain" : "Temporal";
                         });

TEST_P(PostfixGrammarIn, EveryPrefixCanBeCompletedAndRangesSayWhatIsAllowed) {
  const PostfixGrammar grammar(small, GetParam());
  std::size_t prefixes = 0;
  for_each_prefix(grammar, 5, [&](const std::vector<Token>&, const PrefixState& state) {
    ++prefixes;
    const auto allowed = allowed_tokens(grammar, state);
    EXPECT_EQ(allowed.empty(), state.ended);
    std::vector<Token> ranges;
    grammar.choices(state).each([&](Token t) {
      const bool usable =
          !grammar.is_literal(t) || grammar.usable(static_cast<std::uint16_t>(t - PostfixGrammar::first_literal));
      if (usable) ranges.push_back(t);
    });
    EXPECT_EQ(ranges, allowed);
    if (const auto forced = grammar.forced(state)) {
      EXPECT_EQ(allowed, std::vector<Token>{*forced});
    }
  });
  EXPECT_GT(prefixes, 5'000U);
}

// No sequence is a dead end: whatever is chosen, a program of the language comes out, the one that was spelled.
TEST_P(PostfixGrammarIn, RandomProgramsAreSpelledAndReadBack) {
  const PostfixGrammar grammar(small, GetParam());
  std::mt19937_64 random(5);
  std::set<StepKind> kinds;
  for (int i = 0; i < 2000; ++i) {
    const Program program = random_program(grammar, random);
    for (const Step& step : program) kinds.insert(step.kind);
    ASSERT_TRUE(grammar.contains(program)) << grammar.show(program);
    ASSERT_EQ(grammar.program_of(grammar.tokens_of(program)), program) << grammar.show(program);
  }
  EXPECT_EQ(kinds.size(), GetParam().dialect == Dialect::Plain ? 7U : 12U);
}

TEST(PostfixGrammar, TypesAreRespectedByEveryCompleteSequence) {
  const PostfixGrammar grammar(small, {2, 2});
  std::set<Program> programs;
  for_each_prefix(grammar, 7, [&](const std::vector<Token>& tokens, const PrefixState& state) {
    if (!state.ended) return;
    int bools = 0, steps = 0;
    for (Token t : tokens) {
      if (grammar.is_literal(t)) ++bools;
      if (t == PostfixGrammar::both) --bools;
      if (t == PostfixGrammar::then) --steps;
      if (t >= PostfixGrammar::reach && t <= PostfixGrammar::face) --bools;
      if (t >= PostfixGrammar::stay && t < PostfixGrammar::first_literal) ++steps;
      ASSERT_GE(bools, 0);
    }
    EXPECT_EQ(bools, 0);
    EXPECT_EQ(steps, 1);
    const Program program = grammar.program_of(tokens);
    EXPECT_EQ(grammar.tokens_of(program), tokens) << grammar.show(program);
    EXPECT_TRUE(programs.insert(program).second) << "two sequences of " << grammar.show(program);
  });
  EXPECT_GT(programs.size(), 1'000U);
}

TEST(PostfixGrammar, ShowsPostfix) {
  const PostfixGrammar grammar(small);
  const Program program{{StepKind::Next, 0, 1, {4}}, {StepKind::Reach, 0, 2, {0, 2}}};
  EXPECT_EQ(grammar.show(program), "turned_left next a c & reach then");
  EXPECT_EQ(grammar.show({{StepKind::Orient, 0, 0, {}}, {StepKind::Forward, 2, 0, {}}}), "orient forward_2 then");
  const PostfixGrammar temporal(small, Dialect::Temporal);
  const Step to_a{StepKind::Reach, 0, 1, {0}}, left{StepKind::Next, 0, 1, {4}};
  EXPECT_EQ(temporal.show({left, {StepKind::Without, 0, 1, {2}}, to_a}),
            "turned_left next c without a reach apply then");
  EXPECT_EQ(temporal.show({{StepKind::Whether, 0, 1, {1}}, left, to_a, {StepKind::Advance, 2, 1, {2}}}),
            "b whether turned_left next apply a reach apply c advance_2 then");
}

TEST(PostfixGrammar, TheTemporalDialectAddsOperatorsBehindAndMovesNoToken) {
  const PostfixGrammar plain(small), temporal(small, Dialect::Temporal);
  EXPECT_EQ(plain.tokens(), plain.end_of_literals());
  EXPECT_EQ(temporal.tokens(), plain.tokens() + 8);
  for (std::size_t t = 0; t < plain.tokens(); ++t)
    EXPECT_EQ(plain.name(static_cast<Token>(t)), temporal.name(static_cast<Token>(t)));
}

TEST(PostfixGrammar, FunctionsTakePlainStepsAndAreNotNested) {
  const PostfixGrammar plain(small), temporal(small, Dialect::Temporal);
  const Step without{StepKind::Without, 0, 1, {2}}, when{StepKind::When, 0, 1, {1}}, to_a{StepKind::Reach, 0, 1, {0}};
  EXPECT_FALSE(plain.contains({without, to_a}));
  EXPECT_TRUE(temporal.contains({without, to_a}));
  EXPECT_FALSE(temporal.contains({when, without, to_a}));
  EXPECT_FALSE(temporal.contains({{StepKind::Without, 0, 2, {1, 2}}, to_a}));  // a condition is one literal
  EXPECT_FALSE(temporal.contains({{StepKind::When, 0, 1, {4}}, to_a}));        // and no turn
  EXPECT_FALSE(temporal.contains({{StepKind::Advance, 4, 1, {0}}}));
  EXPECT_FALSE(temporal.contains({to_a, when}));  // without the step it applies to
  EXPECT_FALSE(temporal.contains({{StepKind::Whether, 0, 1, {1}}, to_a}));
  EXPECT_THROW(temporal.tokens_of({to_a, when}), std::invalid_argument);
}

TEST(PostfixGrammar, ProgramsOutsideTheLanguageAreRefused) {
  const PostfixGrammar grammar(small);
  const Program table[] = {
      {},
      {{StepKind::Reach, 0, 0, {}}},      // no goal
      {{StepKind::Reach, 0, 2, {2, 0}}},  // literals must ascend
      {{StepKind::Next, 0, 1, {3}}},      // `moved` is no goal
      {{StepKind::Forward, 9, 0, {}}},    // more than forward_8
      {{StepKind::Forward, 0, 0, {}}},
      {{StepKind::Orient, 0, 0, {}}},                               // nothing after it
      {{StepKind::Stay, 0, 0, {}}, {StepKind::Forward, 1, 0, {}}},  // `stay` stands alone
      Program(4, Step{StepKind::Forward, 1, 0, {}}),                // four steps
  };
  for (const Program& program : table) EXPECT_THROW(grammar.tokens_of(program), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::parser
