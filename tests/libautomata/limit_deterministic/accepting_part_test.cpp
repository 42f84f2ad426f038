#include "libautomata/limit_deterministic/accepting_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libltl/structure/random.hpp"

namespace waymark::automata {
namespace {

// States with one successor each.
AcceptingPart accepting_part(const std::vector<std::uint32_t>& successors) {
  AcceptingPart out;
  for (std::uint32_t target : successors)
    out.automaton.roots.push_back(Mtbdd::terminal(out.automaton.choices.intern({{target, {}}})));
  return out;
}

std::size_t reached(const std::vector<std::uint32_t>& successors, const std::vector<std::uint32_t>& from) {
  std::vector<bool> met(successors.size(), false);
  for (std::uint32_t q : from)
    for (; !met[q]; q = successors[q]) met[q] = true;
  return static_cast<std::size_t>(std::count(met.begin(), met.end(), true));
}

TEST(Choosing, OneStateServesManyRequests) {
  EXPECT_EQ(Choosing(accepting_part({0, 1, 2})).choose({{0, 2}, {1, 2}}), (std::vector<std::uint32_t>{2, 2}));
}

TEST(Choosing, WhatIsReachedAnywayCostsNothing) {
  EXPECT_EQ(Choosing(accepting_part({1, 1, 2})).choose({{0}, {2, 1}}), (std::vector<std::uint32_t>{0, 1}));
}

// Four requests by one state that leads through five others, or each by a state of its own.
TEST(Choosing, ManyAnswersMayCostTooMuch) {
  const std::vector<std::uint32_t> successors{1, 2, 3, 4, 5, 5, 6, 7, 8, 9};
  const auto chosen = Choosing(accepting_part(successors)).choose({{6, 0}, {7, 0}, {8, 0}, {9, 0}});
  EXPECT_EQ(reached(successors, chosen), 4U);
}

TEST(Choosing, AnswersAreOptionsAndNoMoreThanTheFirstOnes) {
  constexpr std::uint64_t seed = 4;
  ltl::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::uint32_t> successors;
    const std::size_t size = 1 + random.below(12);
    for (std::size_t q = 0; q < size; ++q) successors.push_back(static_cast<std::uint32_t>(random.below(size)));
    Choosing::Requests requests(random.below(6));
    for (auto& options : requests)
      for (std::size_t k = random.below(4) + 1; k > 0; --k)
        options.push_back(static_cast<std::uint32_t>(random.below(size)));
    const auto chosen = Choosing(accepting_part(successors)).choose(requests);
    ASSERT_EQ(chosen.size(), requests.size());
    std::size_t most = 0;  // the cheapest option of each, as if nothing were shared
    for (std::size_t r = 0; r < requests.size(); ++r) {
      ASSERT_NE(std::find(requests[r].begin(), requests[r].end(), chosen[r]), requests[r].end()) << i;
      std::size_t fewest = size;
      for (std::uint32_t option : requests[r]) fewest = std::min(fewest, reached(successors, {option}));
      most += fewest;
    }
    ASSERT_LE(reached(successors, chosen), most) << "seed " << seed << ", case " << i;
  }
}

}  // namespace
}  // namespace waymark::automata
