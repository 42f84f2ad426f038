#include "libautomata/finite/product.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::automata {
namespace {

Dfa translate(std::string_view text, const std::vector<std::string>& names = {}) {
  ltl::Arena arena{ltl::Vocabulary(names)};
  return ltlf_to_dfa(ltl::parse(text, arena));
}

TEST(Difference, IsNulloptForEquivalentAutomata) {
  EXPECT_FALSE(difference(translate("F a"), translate("true U a")).has_value());
  EXPECT_FALSE(difference(translate("!(a U b)"), translate("!a R !b")).has_value());
  EXPECT_FALSE(difference(translate("F a & F b"), translate("F b & F a", {"b", "a"})).has_value())
      << "vocabularies in different order";
}

TEST(Difference, IsAShortestWordWithTheRightVerdict) {
  const std::optional<Difference> found = difference(translate("F a"), translate("a | X a"));
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->first_accepts);
  EXPECT_EQ(ltl::show(found->word, found->vocabulary), "{}; {}; {a}");
  const std::optional<Difference> weak = difference(translate("X a"), translate("N a"));
  ASSERT_TRUE(weak.has_value());
  EXPECT_FALSE(weak->first_accepts);
  EXPECT_EQ(weak->word.size(), 1U) << "strong and weak next differ at the end of the word";
}

TEST(Difference, MatchesPropositionsByName) {
  const std::optional<Difference> found = difference(translate("F a"), translate("F b"));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->vocabulary.names(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(found->word.size(), 1U);
}

TEST(Product, RefusesToAcceptTheEmptyWord) {
  EXPECT_THROW(product(translate("a"), translate("b"), [](bool p, bool q) { return p == q; }), std::invalid_argument);
}

TEST(Product, EndsWhenItsEffortIsSpent) {
  const Dfa a = translate("F(a & X F b)"), b = translate("F c & F d");
  Budget few_states(SIZE_MAX, 2, {});
  EXPECT_THROW(product(
                   a, b, [](bool p, bool q) { return p && q; }, few_states),
               Budget::Exceeded);
  Budget few_steps(1, SIZE_MAX, {});
  EXPECT_THROW(difference(a, b, few_steps), Budget::Exceeded);
}

TEST(Product, AcceptsByTheVerdictOfBoth) {
  const Dfa only_first = product(translate("F a"), translate("F b"), [](bool p, bool q) { return p && !q; });
  EXPECT_FALSE(difference(only_first, translate("F a & G !b")).has_value());
}

}  // namespace
}  // namespace waymark::automata
