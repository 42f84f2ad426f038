#include "libautomata/finite/guard.hpp"

#include <gtest/gtest.h>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

namespace waymark::automata {
namespace {

bool satisfies(const Cube& cube, std::size_t bits) {
  for (const Literal& literal : cube)
    if ((((bits >> literal.variable) & 1U) != 0) != literal.positive) return false;
  return true;
}

bool satisfies(const Guard& guard, std::size_t bits) {
  for (const Cube& cube : guard)
    if (satisfies(cube, bits)) return true;
  return false;
}

TEST(Guard, CoverIsExactAndIrredundant) {
  constexpr std::size_t variables = 4, letters = 16;
  ltl::Random random(21);
  for (int round = 0; round < 500; ++round) {
    Mtbdd diagram;
    Boolean logic(diagram);
    std::vector<bool> truth;
    Mtbdd::Node f = Boolean::constant(false);
    for (std::size_t bits = 0; bits < letters; ++bits) {
      truth.push_back(random.chance(0.4));
      Mtbdd::Node letter = Boolean::constant(truth.back());
      for (std::size_t v = 0; v < variables; ++v) {
        const Mtbdd::Node x = logic.variable(static_cast<Mtbdd::Variable>(v));
        letter = logic.conjunction(letter, ((bits >> v) & 1U) != 0 ? x : logic.negate(x));
      }
      f = logic.disjunction(f, letter);
    }
    const Guard cover = irredundant_cover(diagram, logic, f);
    const auto exact = [&](const Guard& guard) {
      for (std::size_t bits = 0; bits < letters; ++bits)
        if (satisfies(guard, bits) != truth[bits]) return false;
      return true;
    };
    ASSERT_TRUE(exact(cover)) << "round " << round;
    for (std::size_t i = 0; i < cover.size(); ++i) {
      Guard fewer = cover;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      ASSERT_FALSE(exact(fewer)) << "a cube can be dropped, round " << round;
      for (std::size_t j = 0; j < cover[i].size(); ++j) {
        Guard wider = cover;
        wider[i].erase(wider[i].begin() + static_cast<std::ptrdiff_t>(j));
        ASSERT_FALSE(exact(wider)) << "a literal can be dropped, round " << round;
      }
    }
  }
}

TEST(Edges, PartitionTheLettersOfEveryState) {
  ltl::Random random(22);
  for (int round = 0; round < 100; ++round) {
    ltl::Arena arena(ltl::Vocabulary({"a", "b", "c"}));
    const Dfa dfa = ltlf_to_dfa(ltl::random_formula(random, arena, {.size = 14, .atoms = 3}));
    Edges edges(dfa);
    std::size_t count = 0;
    for (std::uint32_t q = 0; q < dfa.states(); ++q) {
      const std::vector<Edge> from = edges.from(StateId{q});
      count += from.size();
      for (std::size_t bits = 0; bits < std::size_t{1} << dfa.reads().size(); ++bits) {
        ltl::Letter letter;
        for (std::size_t v = 0; v < dfa.reads().size(); ++v)
          if (((bits >> v) & 1U) != 0) letter.insert(dfa.reads()[v]);
        std::vector<StateId> reached;
        for (const Edge& edge : from)
          if (satisfies(edge.guard, bits)) reached.push_back(edge.target);
        ASSERT_EQ(reached, std::vector<StateId>{dfa.next(StateId{q}, letter)});
      }
    }
    ASSERT_EQ(count, count_edges(dfa));
  }
}

TEST(Edges, AreCountedUpToALimit) {
  ltl::Arena arena;
  const Dfa dfa = ltlf_to_dfa(ltl::parse("F a & F b", arena));
  EXPECT_EQ(count_edges(dfa, 10), 9U);
  EXPECT_EQ(count_edges(dfa, 9), 9U);
  EXPECT_EQ(count_edges(dfa, 8), std::nullopt);
  EXPECT_EQ(count_edges(dfa, 0), std::nullopt);
}

TEST(Edges, LabelsReadWell) {
  const struct {
    const char* formula;
    const char* stay;   // on the loop of the initial state
    const char* leave;  // from the initial state to the other one
  } table[] = {
      {"F a", "!a", "a"},
      {"F (a & b)", "!(a & b)", "a & b"},
      {"F (a | b)", "!(a | b)", "a | b"},
      {"F true", "", "true"},
  };
  for (const auto& row : table) {
    ltl::Arena arena;
    const Dfa dfa = ltlf_to_dfa(ltl::parse(row.formula, arena));
    ASSERT_EQ(dfa.states(), 2U) << row.formula;
    Edges edges(dfa);
    const StateId q = dfa.initial(), other{1 - q.index};
    const ltl::Formula stay = edges.label(q, q, arena), leave = edges.label(q, other, arena);
    EXPECT_EQ(ltl::print(leave), row.leave) << row.formula;
    EXPECT_EQ(stay.op() == ltl::Op::False ? "" : ltl::print(stay), row.stay) << row.formula;
  }
}

}  // namespace
}  // namespace waymark::automata
