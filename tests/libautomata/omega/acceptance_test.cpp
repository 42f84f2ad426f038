#include "libautomata/omega/acceptance.hpp"

#include <gtest/gtest.h>

namespace waymark::automata {
namespace {

TEST(Acceptance, PrintsAndNamesConditionsAsHoaSpellsThem) {
  using Extreme = Acceptance::Extreme;
  using Parity = Acceptance::Parity;
  const struct {
    Acceptance acceptance;
    const char *printed, *name;
  } table[] = {
      {Acceptance::all(), "t", "all"},
      {Acceptance::none(), "f", "none"},
      {Acceptance::buchi(), "Inf(0)", "Buchi"},
      {Acceptance::co_buchi(), "Fin(0)", "co-Buchi"},
      {Acceptance::generalized_buchi(2), "Inf(0) & Inf(1)", "generalized-Buchi 2"},
      {Acceptance::rabin(2), "Fin(0) & Inf(1) | Fin(2) & Inf(3)", "Rabin 2"},
      {Acceptance::streett(2), "(Fin(0) | Inf(1)) & (Fin(2) | Inf(3))", "Streett 2"},
      {Acceptance::parity(Extreme::Max, Parity::Odd, 3), "Fin(2) & (Inf(1) | Fin(0))", "parity max odd 3"},
      {Acceptance::parity(Extreme::Min, Parity::Even, 3), "Inf(0) | Fin(1) & Inf(2)", "parity min even 3"},
  };
  for (const auto& row : table) {
    EXPECT_EQ(print(row.acceptance.condition), row.printed);
    EXPECT_EQ(row.acceptance.name(), row.name);
  }
}

TEST(Acceptance, IsPrintedWithNoMoreParenthesesThanNeeded) {
  const Condition a = Condition::inf(0), b = Condition::fin(1), c = Condition::inf(2), d = Condition::fin(3);
  const Condition either = Condition::any_of({a, Condition::all_of({b, Condition::any_of({c, d})})});
  EXPECT_EQ(print(either), "Inf(0) | Fin(1) & (Inf(2) | Fin(3))");
  EXPECT_EQ(print(Condition::all_of({either, d})), "(Inf(0) | Fin(1) & (Inf(2) | Fin(3))) & Fin(3)");
  EXPECT_EQ(print(Condition::any_of({Condition::all_of({a, b}), Condition::all_of({c, d})})),
            "Inf(0) & Fin(1) | Inf(2) & Fin(3)");
}

TEST(Acceptance, ParityIsDecidedByTheExtremeColour) {
  using Extreme = Acceptance::Extreme;
  using Parity = Acceptance::Parity;
  for (std::uint32_t n = 1; n <= 5; ++n)
    for (std::uint64_t bits = 1; bits < (std::uint64_t{1} << n); ++bits)
      for (const Extreme extreme : {Extreme::Min, Extreme::Max})
        for (const Parity parity : {Parity::Even, Parity::Odd}) {
          const auto seen = Marks::from_bits(bits).members();
          const std::uint32_t colour = extreme == Extreme::Min ? seen.front() : seen.back();
          EXPECT_EQ(Acceptance::parity(extreme, parity, n).condition.holds(Marks::from_bits(bits)),
                    (colour % 2 == 0) == (parity == Parity::Even))
              << n << " colours, seen " << bits;
        }
}

TEST(Acceptance, NegationIsTheComplementOnEverySet) {
  const Condition conditions[] = {Acceptance::rabin(2).condition, Acceptance::streett(2).condition,
                                  Condition::constant(true), Acceptance::generalized_buchi(4).condition};
  for (const Condition& condition : conditions)
    for (std::uint64_t bits = 0; bits < 16; ++bits)
      EXPECT_NE(condition.holds(Marks::from_bits(bits)), condition.negated().holds(Marks::from_bits(bits)))
          << print(condition) << " on " << bits;
}

}  // namespace
}  // namespace waymark::automata
