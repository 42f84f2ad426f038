// Parity games of products, solved by Zielonka's algorithm, against definitions and against another solver.
#include "libplan/product/product_game.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/case_task.hpp"
#include "tests/libplan/model/models.hpp"
#include "tests/support/zielonka.hpp"

namespace waymark::plan {
namespace {

bool is_won(const Mdp& model, ltl::Formula f) {
  automata::Budget budget;
  const automata::ParityGame game = ProductGame(model, automata::ltl_to_dpa(f), budget).build();
  waymark::test::Vertices all;
  for (std::uint32_t v = 0; v < game.vertices.size(); ++v) {
    all.insert(v);
    EXPECT_FALSE(game.vertices[v].successors.empty());
  }
  return waymark::test::won_by_system(game, all).contains(0);
}

// The model in which every choice has its first outcome alone.
Mdp first_outcomes(const Mdp& model) {
  MdpBuilder builder{model.letters().vocabulary()};
  for (const ltl::Letter& letter : model.letters().all()) builder.letter(letter);
  for (std::uint32_t s = 0; s < model.states(); ++s) {
    builder.add_state();
    for (std::uint32_t k = 0; k < model.choices(s); ++k) {
      builder.add_choice(std::to_string(k), model.cost(s, k));
      builder.add_outcome(model.outcome(s, k, 0).target, model.outcome(s, k, 0).letter);
    }
  }
  return std::move(builder).build(model.initial(), model.initial_letter());
}

TEST(ProductGame, OnADeterministicModelIsWonWhereThereIsALasso) {
  std::mt19937 random(11);
  ltl::Arena arena(ltl::Vocabulary({"a", "b"}));
  ltl::Random draws(5);
  int won = 0;
  for (int i = 0; i < 300; ++i) {
    const Mdp model = first_outcomes(test::random_mdp(random));
    const ltl::Formula f = ltl::random_formula(draws, arena, {.size = 7, .atoms = 2, .weak_next = false});
    const CaseAnswer lasso =
        answer({"", model, {}}, {.id = "", .formula = ltl::print(f), .query = CaseTask::Query::LeastLasso},
               {.explain = false});
    const bool wins = is_won(model, f);
    ASSERT_EQ(wins, lasso.status == CaseAnswer::Status::Solved) << ltl::print(f) << ", trial " << i;
    won += wins ? 1 : 0;
  }
  EXPECT_GT(won, 30);
  EXPECT_LT(won, 270);
}

// Colours are counted the other way round, and keep their parity however many there are.
TEST(ProductGame, KeepsTheParityOfEveryColour) {
  std::mt19937 random(13);
  std::set<std::size_t> colours;
  int won = 0, games = 0;
  for (const char* formula : {"G F a -> G F b", "G F a & F G b", "(G F a -> G F b) & (G F !b -> G F X a)",
                              "(G F a & F G !b) | (F G a & G F b)", "(G F (a & b) -> G F (a & !b)) & F G (a | b)"}) {
    ltl::Arena arena(ltl::Vocabulary({"a", "b"}));
    const ltl::Formula f = ltl::parse(formula, arena);
    colours.insert(automata::min_even_parity(automata::ltl_to_dpa(f).automaton().transitions()).acceptance.sets);
    for (int i = 0; i < 60; ++i) {
      const Mdp model = first_outcomes(test::random_mdp(random));
      const CaseAnswer lasso = answer(
          {"", model, {}}, {.id = "", .formula = formula, .query = CaseTask::Query::LeastLasso}, {.explain = false});
      const bool wins = is_won(model, f);
      ASSERT_EQ(wins, lasso.status == CaseAnswer::Status::Solved) << formula << ", trial " << i;
      won += wins ? 1 : 0;
      ++games;
    }
  }
  EXPECT_GE(colours.size(), 2U);
  EXPECT_GE(*colours.rbegin(), 3U);
  EXPECT_GT(won, games / 10);
  EXPECT_LT(won, games * 9 / 10);
}

// From where every outcome of some choice reads b or leads to where that is so again, in the end.
bool forces_b(const Mdp& model) {
  const ltl::Proposition b = *model.letters().vocabulary().find("b");
  const auto reads = [&](LetterId letter) { return model.letters()[letter].contains(b); };
  if (reads(model.initial_letter())) return true;
  std::vector<bool> sure(model.states(), false);
  for (bool grew = true; grew;) {
    grew = false;
    for (std::uint32_t s = 0; s < model.states(); ++s)
      for (std::uint32_t k = 0; k < model.choices(s) && !sure[s]; ++k) {
        bool all = true;
        model.for_each_outcome(s, k, [&](std::uint32_t t, LetterId l, double) { all = all && (reads(l) || sure[t]); });
        if (all) sure[s] = grew = true;
      }
  }
  return sure[model.initial()];
}

// A run that ends satisfies nothing over infinite words: every state gets a choice.
Mdp without_ends(const Mdp& model) {
  MdpBuilder builder{model.letters().vocabulary()};
  const LetterId none = builder.letter({});
  std::vector<LetterId> letters;
  for (const ltl::Letter& letter : model.letters().all()) letters.push_back(builder.letter(letter));
  for (std::uint32_t s = 0; s < model.states(); ++s) {
    builder.add_state();
    for (std::uint32_t k = 0; k < model.choices(s); ++k) {
      builder.add_choice(std::to_string(k));
      for (const ModelOutcome& o : model.outcomes(s, k))
        builder.add_outcome(o.target, letters[o.letter.index], o.probability);
    }
    if (model.choices(s) > 0) continue;
    builder.add_choice("stay");
    builder.add_outcome(s, none);
  }
  return std::move(builder).build(model.initial(), letters[model.initial_letter().index]);
}

TEST(ProductGame, EventuallyIsWonWhereItCanBeForced) {
  std::mt19937 random(12);
  int won = 0, drawn = 0;
  for (int i = 0; i < 400; ++i) {
    const Mdp model = without_ends(test::random_mdp(random));
    ltl::Arena arena(model.letters().vocabulary());
    const bool wins = is_won(model, ltl::parse("F b", arena));
    ASSERT_EQ(wins, forces_b(model)) << "trial " << i;
    won += wins ? 1 : 0;
    drawn += model.is_deterministic() ? 0 : 1;
  }
  EXPECT_GT(won, 40);
  EXPECT_LT(won, 360);
  EXPECT_GT(drawn, 100);
}

}  // namespace
}  // namespace waymark::plan
