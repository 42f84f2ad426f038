#include "libparser/supervision/search.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

GoldRoute gold_route(const plan::Map& map, plan::PoseId start, const std::vector<plan::Action>& actions) {
  GoldRoute gold{start, start, actions, false};
  for (plan::Action action : actions) gold.end = map.successor(gold.end, action).value();
  return gold;
}

// A random walk that never runs into a wall.
GoldRoute random_route(const plan::Map& map, std::size_t length, std::mt19937_64& random) {
  GoldRoute gold{{static_cast<std::uint32_t>(random() % map.poses())}, {}, {}, random() % 2 == 0};
  gold.end = gold.start;
  while (gold.actions.size() < length) {
    const plan::Action action = plan::all_actions[random() % 3];
    const auto next = map.successor(gold.end, action);
    if (!next) continue;
    gold.actions.push_back(action);
    gold.end = *next;
  }
  return gold;
}

TEST(Search, EveryProgramFoundEndsAtTheGoldEnd) {
  std::mt19937_64 random(11);
  const plan::Map& map = shipped_maps()[2];
  const Executor executor(map);
  const PostfixGrammar grammar(map.vocabulary());
  for (std::size_t length = 0; length < 6; ++length) {
    const GoldRoute gold = random_route(map, length, random);
    const auto programs = consistent_programs(executor, grammar, gold);
    std::set<Program> distinct;
    for (const Consistent& found : programs) {
      EXPECT_NO_THROW(grammar.tokens_of(found.program)) << grammar.show(found.program);
      EXPECT_TRUE(distinct.insert(found.program).second) << grammar.show(found.program);
      const auto plan = executor.run(found.program, gold.start);
      ASSERT_TRUE(plan.has_value()) << grammar.show(found.program);
      EXPECT_EQ(plan->end, gold.end) << grammar.show(found.program);
      EXPECT_EQ(plan->actions == gold.actions, found.same_route) << grammar.show(found.program);
    }
  }
}

// All one-step programs with one or two literals, tried one by one.
std::set<Program> minimal_one_step_programs(const Executor& executor, const PostfixGrammar& grammar,
                                            const GoldRoute& gold) {
  const auto ends_right = [&](const Program& program) {
    const auto plan = executor.run(program, gold.start);
    return plan && plan->end == gold.end;
  };
  std::set<Program> found;
  for (StepKind kind : {StepKind::Reach, StepKind::Next, StepKind::Advance, StepKind::Face})
    for (std::uint16_t p = 0; p < executor.propositions(); ++p) {
      if (!grammar.usable(p, kind)) continue;
      const Program one{{kind, 0, 1, {p}}};
      if (ends_right(one)) found.insert(one);
      for (std::uint16_t q = 0; q < p; ++q) {
        const Program two{{kind, 0, 2, {q, p}}};
        if (grammar.usable(q, kind) && ends_right(two) && !ends_right(one) && !ends_right({{kind, 0, 1, {q}}}))
          found.insert(two);
      }
    }
  return found;
}

TEST(Search, FindsAllMinimalOneStepPrograms) {
  const plan::Map& map = shipped_maps().front();
  const Executor executor(map);
  const PostfixGrammar grammar(map.vocabulary());
  const GoldRoute gold = gold_route(map, map.find({1, 9, 0}).value(), {plan::Action::Forward, plan::Action::Left});
  std::set<Program> found;
  for (const Consistent& c : consistent_programs(executor, grammar, gold))
    if (c.program.size() == 1 && c.program[0].goals > 0) found.insert(c.program);
  EXPECT_EQ(found, minimal_one_step_programs(executor, grammar, gold));
  EXPECT_GT(found.size(), 10U);
}

TEST(Search, StayingTurningAndCountingAreFound) {
  const plan::Map& map = shipped_maps().front();
  const Executor executor(map);
  const PostfixGrammar grammar(map.vocabulary());
  const plan::PoseId start = map.find({1, 9, 0}).value();
  const auto contains = [&](const std::vector<plan::Action>& actions, const Program& program) {
    for (const Consistent& c : consistent_programs(executor, grammar, gold_route(map, start, actions)))
      if (c.program == program) return c.same_route;
    return false;
  };
  const auto literal = [&](const char* name) {
    return static_cast<std::uint16_t>(map.vocabulary().find(name).value().index);
  };
  using enum plan::Action;
  const Step left{StepKind::Next, 0, 1, {literal("turned_left")}}, two{StepKind::Forward, 2, 0, {}};
  EXPECT_TRUE(contains({}, {Step{}}));
  EXPECT_TRUE(contains({Left}, {left}));
  EXPECT_TRUE(contains({Forward, Forward}, {two}));
  EXPECT_TRUE(contains({Forward, Forward, Left}, {two, left}));
}

}  // namespace
}  // namespace waymark::parser
