// Maximal end components, against every subset of the states of small products.
#include "libplan/solve/end_components.hpp"

#include <gtest/gtest.h>

#include "tests/libplan/solve/small_products.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using testing::SmallProduct;
using Bits = std::uint32_t;  // a set of states

bool has(Bits set, std::uint32_t i) { return ((set >> i) & 1U) != 0; }

// Does a usable choice keep every state of the set inside, and lead from each to each?
template <class Usable>
bool is_end_component(const SmallProduct& product, Bits set, const Usable& usable) {
  std::vector<Bits> leads(product.states(), 0);
  for (std::uint32_t i = 0; i < product.states(); ++i) {
    if (!has(set, i)) continue;
    for (std::uint32_t k = 0; k < product.of[i].size(); ++k) {
      Bits targets = 0;
      bool inside = usable(SmallProduct::State{i}, k);
      for (const SmallProduct::Outcome& o : product.of[i][k].outcomes) {
        inside = inside && o.target != SmallProduct::trap && has(set, o.target);
        if (inside) targets |= 1U << o.target;
      }
      if (inside) leads[i] |= targets;
    }
  }
  for (std::uint32_t round = 0; round < product.states(); ++round)
    for (std::uint32_t i = 0; i < product.states(); ++i)
      for (std::uint32_t j = 0; j < product.states(); ++j)
        if (has(leads[i], j)) leads[i] |= leads[j];
  bool all = set != 0;
  for (std::uint32_t i = 0; i < product.states(); ++i) all = all && (!has(set, i) || leads[i] == set);
  return all;
}

TEST(EndComponents, AreTheGreatestOfAllSubsets) {
  ltl::Random random(103);
  int large = 0, several = 0;
  for (int trial = 0; trial < waymark::testing::scaled(3'000); ++trial) {
    const SmallProduct product = testing::small_product(random, static_cast<std::uint32_t>(1 + random.below(6)));
    const StateSet within =
        random.below(2) == 0 ? StateSet(product.states(), true) : testing::random_states(random, product.states(), 2);
    const bool any = random.below(2) == 0;  // any choice, or those that are free
    const auto usable = [&](SmallProduct::State s, std::uint32_t k) { return any || product.cost(s, k) == 0; };
    Bits allowed = 0;
    for (std::uint32_t i = 0; i < product.states(); ++i) allowed |= within[i] ? 1U << i : 0U;
    std::vector<Bits> greatest(product.states(), 0);  // by state
    for (Bits set = 1; set < 1U << product.states(); ++set) {
      if ((set & ~allowed) != 0 || !is_end_component(product, set, usable)) continue;
      for (std::uint32_t i = 0; i < product.states(); ++i)
        if (has(set, i)) greatest[i] |= set;
    }
    const EndComponents found = end_components(product, within, usable);
    ASSERT_EQ(found.of.size(), product.states());
    std::vector<Bits> members(found.count, 0);
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      ASSERT_EQ(found.of[i] == EndComponents::none, greatest[i] == 0) << "trial " << trial << ", state " << i << "\n"
                                                                      << testing::show(product);
      if (greatest[i] == 0) continue;
      ASSERT_LT(found.of[i], found.count);
      members[found.of[i]] |= 1U << i;
    }
    several += found.count > 1 ? 1 : 0;
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      if (greatest[i] == 0) continue;
      ASSERT_EQ(members[found.of[i]], greatest[i]) << "trial " << trial << ", state " << i << "\n"
                                                   << testing::show(product);
      large += (greatest[i] & (greatest[i] - 1)) != 0 ? 1 : 0;
      for (std::uint32_t k = 0; k < product.of[i].size(); ++k) {
        bool inside = true;
        for (const SmallProduct::Outcome& o : product.of[i][k].outcomes)
          inside = inside && o.target != SmallProduct::trap && has(greatest[i], o.target);
        ASSERT_EQ(stays(product, SmallProduct::State{i}, k, found), inside)
            << "trial " << trial << ", state " << i << ", choice " << k << "\n"
            << testing::show(product);
      }
    }
  }
  EXPECT_GT(large, waymark::testing::scaled(500));
  EXPECT_GT(several, waymark::testing::scaled(100));
}

}  // namespace
}  // namespace waymark::plan
