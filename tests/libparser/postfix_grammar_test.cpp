#include "libparser/postfix_grammar.hpp"

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

TEST(PostfixGrammar, EveryPrefixCanBeCompletedAndRangesSayWhatIsAllowed) {
  const PostfixGrammar grammar(small);
  std::size_t prefixes = 0;
  for_each_prefix(grammar, 5, [&](const std::vector<Token>&, const PrefixState& state) {
    ++prefixes;
    const auto allowed = allowed_tokens(grammar, state);
    EXPECT_EQ(allowed.empty(), state.ended);
    std::vector<Token> ranges;
    grammar.choices(state).each([&](Token t) {
      const bool usable = t < PostfixGrammar::first_literal ||
                          grammar.usable(static_cast<std::uint16_t>(t - PostfixGrammar::first_literal));
      if (usable) ranges.push_back(t);
    });
    EXPECT_EQ(ranges, allowed);
    if (const auto forced = grammar.forced(state)) {
      EXPECT_EQ(allowed, std::vector<Token>{*forced});
    }
  });
  EXPECT_GT(prefixes, 5'000U);
}

TEST(PostfixGrammar, TypesAreRespectedByEveryCompleteSequence) {
  const PostfixGrammar grammar(small, {2, 2});
  std::set<Program> programs;
  for_each_prefix(grammar, 7, [&](const std::vector<Token>& tokens, const PrefixState& state) {
    if (!state.ended) return;
    int bools = 0, steps = 0;
    for (Token t : tokens) {
      if (t >= PostfixGrammar::first_literal) ++bools;
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
  EXPECT_EQ(grammar.show({{StepKind::Orient, 0, 0, {}}, {StepKind::Forward, 2, 0, {}}}),
            "orient forward_2 then");
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
