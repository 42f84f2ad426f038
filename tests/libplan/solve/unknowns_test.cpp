// The order in which unknowns are swept, what is merged, and whose bounds are kept: by their definitions.
#include "libplan/solve/unknowns.hpp"

#include <gtest/gtest.h>

#include <map>

#include "libplan/solve/kept_bounds.hpp"
#include "tests/libplan/solve/small_products.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using testing::SmallProduct;
using Quotient = EndComponentQuotient<SmallProduct>;

struct Asked {
  SmallProduct product;
  Unknowns unknowns;
};
Asked random_question(ltl::Random& random, bool merges) {
  Asked out{testing::small_product(random, static_cast<std::uint32_t>(2 + random.below(14)), 2), {}};
  Unknowns& unknowns = out.unknowns;
  unknowns.targets = testing::random_states(random, out.product.states(), 4);
  unknowns.unknown = testing::random_states(random, out.product.states(), 6);
  for (std::uint32_t i = 0; i < out.product.states(); ++i)
    unknowns.unknown.set(i, !unknowns.unknown[i] && !unknowns.targets[i]);
  if (merges)
    unknowns.merged = end_components(out.product, unknowns.unknown, [](const auto&, std::uint32_t) { return true; });
  return out;
}

// Of the unknowns of a block, the layer: how many moves it takes at best to what is known or solved before. 0: no way.
std::vector<std::uint32_t> layers_of(const Asked& asked, std::uint32_t first, std::uint32_t last) {
  const Unknowns& unknowns = asked.unknowns;
  std::vector<std::uint32_t> layer(asked.product.states(), 0);
  for (std::uint32_t depth = 1; depth <= asked.product.states(); ++depth)
    for (std::uint32_t i = first; i < last; ++i)
      for (std::uint32_t t = 0; t < asked.product.states() && unknowns.unknown[i] && layer[i] == 0; ++t) {
        const bool known = unknowns.targets[t] || (unknowns.unknown[t] && t < first);
        if (asked.product.leads(i, t) && (depth == 1 ? known : t >= first && layer[t] == depth - 1)) layer[i] = depth;
      }
  return layer;
}

TEST(Unknowns, AreSweptLayerByLayer) {
  ltl::Random random(104);
  int deep = 0, merged = 0;
  for (int trial = 0; trial < waymark::testing::scaled(3'000); ++trial) {
    const Asked asked = random_question(random, trial % 2 == 0);
    const EndComponents& components = asked.unknowns.merged;
    const Quotient quotient(asked.product, asked.unknowns);
    const auto& blocks = asked.product.blocks();
    for (std::size_t b = 0; b + 1 < blocks.size(); ++b) {
      const std::vector<std::uint32_t> layer = layers_of(asked, blocks[b], blocks[b + 1]);
      const auto order = quotient.in_order(blocks[b], blocks[b + 1]);
      const std::string what = "trial " + std::to_string(trial) + "\n" + testing::show(asked.product);
      EXPECT_EQ(order.layers, *std::max_element(layer.begin(), layer.end())) << what;
      std::map<std::uint32_t, int> times;  // a component, or behind all of them a state
      std::uint32_t before = 1;
      const auto own = [&](std::uint32_t i) {
        const std::uint32_t c = components.count == 0 ? EndComponents::none : components.of[i];
        return c == EndComponents::none ? components.count + i : c;
      };
      for (const auto& c : order.states) {
        ASSERT_GE(layer[c.number], before) << what;
        before = layer[c.number];
        ++times[own(c.number)];
        merged += own(c.number) < components.count ? 1 : 0;
        for (std::uint32_t i = 0; i < asked.product.states(); ++i) {
          if (own(i) != own(c.number) || layer[i] == 0) continue;
          ASSERT_GE(layer[i], before) << what << "the nearest of what is merged";
        }
      }
      for (std::uint32_t i = blocks[b]; i < blocks[b + 1]; ++i) {
        if (layer[i] == 0) continue;
        ASSERT_EQ(times[own(i)], 1) << what << "state " << i;
      }
      deep += order.layers > 2 ? 1 : 0;
    }
  }
  EXPECT_GT(deep, waymark::testing::scaled(200));
  EXPECT_GT(merged, waymark::testing::scaled(50));
}

TEST(Unknowns, MergedOnesHaveOneValue) {
  ltl::Random random(105);
  int merged = 0;
  for (int trial = 0; trial < waymark::testing::scaled(500); ++trial) {
    const Asked asked = random_question(random, true);
    const Quotient quotient(asked.product, asked.unknowns);
    for (std::uint32_t i = 0; i < asked.product.states(); ++i) {
      const std::uint32_t own = asked.unknowns.merged.of[i];
      ASSERT_EQ(quotient.component(i), own);
      std::vector<double> values(asked.product.states(), 0), expected = values;
      quotient.set({i}, values, 5);
      for (std::uint32_t j = 0; j < asked.product.states(); ++j)
        if (j == i || (own != EndComponents::none && asked.unknowns.merged.of[j] == own)) expected[j] = 5;
      ASSERT_EQ(values, expected) << "trial " << trial << ", state " << i << "\n" << testing::show(asked.product);
      merged += std::count(values.begin(), values.end(), 5) > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(merged, waymark::testing::scaled(50));
}

TEST(KeptBounds, EntriesAreStartsAndWhatHigherBlocksLeadInto) {
  ltl::Random random(106);
  int entered = 0;
  for (int trial = 0; trial < waymark::testing::scaled(1'000); ++trial) {
    const auto [product, unknowns] = random_question(random, false);
    const std::vector<std::uint32_t> starts{product.states() - 1, product.states() / 2};
    const StateSet found = entries(product, unknowns.unknown, starts);
    for (std::uint32_t t = 0; t < product.states(); ++t) {
      bool expected = std::count(starts.begin(), starts.end(), t) > 0;
      const std::uint32_t last = *std::upper_bound(product.ranges.begin(), product.ranges.end(), t);
      for (std::uint32_t i = last; i < product.states(); ++i)
        expected = expected || (unknowns.unknown[i] && product.leads(i, t));
      if (!unknowns.unknown[t] && !expected) continue;
      ASSERT_EQ(found[t], expected) << "trial " << trial << ", state " << t << "\n" << testing::show(product);
      entered += expected ? 1 : 0;
    }
  }
  EXPECT_GT(entered, waymark::testing::scaled(1'000));
}

TEST(KeptBounds, AreThoseOfTheStatesThatAreKept) {
  ltl::Random random(107);
  for (const std::uint32_t states : {1U, 64U, 65U, 200U}) {
    const StateSet kept = testing::random_states(random, states, 3);
    for (const bool all : {false, true}) {
      KeptBounds bounds = all ? KeptBounds(states) : KeptBounds(kept);
      for (std::uint32_t i = 0; i < states; ++i) {
        ASSERT_EQ(bounds.keeps(i), all || kept[i]) << states << " states, state " << i;
        if (bounds.keeps(i)) {
          EXPECT_EQ(bounds.lower(i), 0);
          EXPECT_EQ(bounds.upper(i), 0);
        }
        bounds.set(i, i, 2.0 * i + 1);
      }
      for (std::uint32_t i = 0; i < states; ++i) {
        if (!bounds.keeps(i)) continue;
        EXPECT_EQ(bounds.lower(i), i);
        EXPECT_EQ(bounds.upper(i), 2.0 * i + 1);
      }
    }
  }
}

}  // namespace
}  // namespace waymark::plan
