#include "libparser/supervision/judged.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libparser/language/generate.hpp"
#include "libparser/programs/recognise.hpp"
#include "libparser/supervision/examples.hpp"
#include "libparser/supervision/judged_search.hpp"
#include "libparser/supervision/route_positions.hpp"
#include "libplan/world/trajectory.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

plan::Trajectory random_walk(const plan::Map& map, std::size_t actions, std::mt19937_64& random) {
  plan::Trajectory walk;
  walk.poses.push_back({static_cast<std::uint32_t>(random() % map.poses())});
  while (walk.actions.size() < actions) {
    const plan::Action action = plan::all_actions[random() % plan::all_actions.size()];
    const auto next = map.successor(walk.poses.back(), action);
    if (!next) continue;
    walk.actions.push_back(action);
    walk.poses.push_back(*next);
  }
  return walk;
}

GoldRoute route_of(const plan::Trajectory& walk) { return {walk.poses.front(), walk.poses.back(), walk.actions}; }

// visit(executor, grammar, program, walk): random walks, and the plan of the program, whole and without its last
// action.
template <class Visit>
void each_random_pair(std::size_t programs, const Visit& visit) {
  std::mt19937_64 random(11);
  for (const plan::Map& map : shipped_maps()) {
    const Executor executor(map);
    const PostfixGrammar grammar(map.vocabulary(), {.steps = 3, .goals = 1, .dialect = Dialect::Temporal});
    for (std::size_t i = 0; i < programs; ++i) {
      const Program program = random_program(grammar, random);
      for (const std::size_t actions : {4U, 30U}) visit(executor, grammar, program, random_walk(map, actions, random));
      const plan::PoseId start{static_cast<std::uint32_t>(random() % map.poses())};
      const auto plan = executor.run(program, start);
      if (!plan || plan->actions.empty() || plan->actions.size() > RoutePositions::most) continue;
      std::vector<plan::Action> actions = plan->actions;
      visit(executor, grammar, program, *plan::follow(map, start, actions));
      actions.pop_back();
      visit(executor, grammar, program, *plan::follow(map, start, actions));
    }
  }
}

TEST(Executor, AWalkSatisfiesAProgramWhenItsWordSatisfiesTheFormula) {
  std::size_t yes = 0, no = 0;
  each_random_pair(800, [&](const Executor& executor, const PostfixGrammar& grammar, const Program& program,
                            const plan::Trajectory& walk) {
    ltl::Arena arena(executor.map().vocabulary());
    const ltl::Formula formula = formula_of(program, arena);
    const bool satisfied = ltl::holds(plan::word_of(walk, executor.map()), formula);
    ++(satisfied ? yes : no);
    ASSERT_EQ(executor.satisfies(walk, program), satisfied) << grammar.show(program) << "  =  " << ltl::print(formula);
  });
  EXPECT_GT(yes, 300U);
  EXPECT_GT(no, 300U);
}

bool is_followed_by_positions(const Program& program) {
  return std::none_of(program.begin(), program.end(), [](const Step& step) {
    return step.kind == StepKind::Stay || step.kind == StepKind::Orient || step.kind == StepKind::When ||
           step.kind == StepKind::Whether;
  });
}

// The law: a program is done at some position of a walk just when the walk satisfies it.
TEST(RoutePositions, AProgramIsDoneSomewhereOnTheWalksThatSatisfyIt) {
  std::size_t yes = 0, no = 0;
  each_random_pair(4000, [&](const Executor& executor, const PostfixGrammar& grammar, const Program& program,
                             const plan::Trajectory& walk) {
    if (!is_followed_by_positions(program)) return;
    const RoutePositions positions(executor, route_of(walk));
    Positions at = RoutePositions::first();
    for (std::size_t i = 0; i < program.size(); ++i) {
      const bool is_guard = operands(program[i].kind) == 1;
      if (is_guard && program[i + 1].kind != StepKind::Reach) return;  // `without` and `keep` of other steps
      const Step* const guard = is_guard ? &program[i++] : nullptr;
      at = positions.after(at, program[i], guard);
    }
    const bool satisfied = executor.satisfies(walk, program);
    ++(satisfied ? yes : no);
    ASSERT_EQ(at != 0, satisfied) << grammar.show(program);
  });
  EXPECT_GT(yes, 300U);
  EXPECT_GT(no, 300U);
}

TEST(RoutePositions, ALongRouteIsRefused) {
  std::mt19937_64 random(1);
  const Executor executor(shipped_maps().front());
  EXPECT_NO_THROW(RoutePositions(executor, route_of(random_walk(executor.map(), RoutePositions::most, random))));
  EXPECT_THROW(RoutePositions(executor, route_of(random_walk(executor.map(), RoutePositions::most + 1, random))),
               std::length_error);
}

class JudgedTest : public ::testing::Test {
 protected:
  // How many sentences have their meant formula first among the programs found, of how many.
  std::pair<std::size_t, std::size_t> meant_first(std::size_t paragraphs, JudgedLimits limits) const {
    const Corpus corpus = generate_corpus(
        shipped_maps(),
        {.seed = 7, .paragraphs = paragraphs, .dialect = Dialect::Temporal, .most_clauses = 2, .judged = limits});
    Examples examples = make_examples(corpus, executors, Convention::Absolute);
    find_programs(examples.sentences, executors, language.grammar(), 2, [](double) { return true; });
    std::size_t i = 0, first = 0;
    for (const Paragraph& paragraph : corpus.paragraphs)
      for (const Sentence& sentence : paragraph.sentences) {
        ltl::Arena arena(language.vocabulary());
        const Example& example = examples.sentences[i++];
        for (const Consistent& one : *example.programs)
          EXPECT_TRUE(agrees(executors[example.map], one.program, example.judged)) << sentence.text;
        first += !example.programs->empty() &&
                 formula_of(example.programs->front().program, arena) == ltl::parse(sentence.formula, arena);
      }
    return {first, i};
  }

  const std::vector<Executor> executors{shipped_maps().begin(), shipped_maps().end()};
  const ProgramLanguage language{shipped_maps().front().vocabulary(), Dialect::Temporal};
};

TEST_F(JudgedTest, AProgramAgreesWhenItAllowsTheGoodOnesAndNoRefusedOne) {
  const Executor& executor = executors.front();
  ltl::Arena arena(language.vocabulary());
  const Program turn = *program_of(ltl::parse("X turned_left", arena), language.grammar());
  const auto walk = [&](plan::Action action) { return *plan::follow(executor.map(), {0}, {action}); };
  const plan::Trajectory left = walk(plan::Action::Left), right = walk(plan::Action::Right);
  EXPECT_TRUE(agrees(executor, turn, {}));
  EXPECT_TRUE(agrees(executor, turn, {{left}, {right}}));
  EXPECT_FALSE(agrees(executor, turn, {{left, right}, {}}));
  EXPECT_FALSE(agrees(executor, turn, {{left}, {right, left}}));
}

TEST_F(JudgedTest, RefusedTrajectoriesTellWhatWasMeant) {
  const std::size_t paragraphs = testing::sanitized ? 4 : 20;
  const auto [without, n] = meant_first(paragraphs, {});
  const auto [with, m] = meant_first(paragraphs, {.refused = 4, .also_good = 2});
  EXPECT_EQ(n, 4 * paragraphs);
  EXPECT_EQ(m, n);
  EXPECT_GE(with, 3 * paragraphs);
  EXPECT_GT(with, without + 3 * paragraphs / 4);
}

}  // namespace
}  // namespace waymark::parser
