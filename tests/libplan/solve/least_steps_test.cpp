// The swiftest of good choices, against all strategies of small models and against value iteration on large ones.
#include "libplan/solve/least_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

// Moves with outcomes, some of them good. A run ends where the order has no state.
struct Moves {
  static constexpr std::uint32_t trap = UINT32_MAX;
  struct State {
    std::uint32_t index;
  };
  struct Move {
    bool good;
    std::vector<std::pair<std::uint32_t, double>> outcomes;
  };
  std::vector<std::vector<Move>> of;  // by state

  std::size_t states() const { return of.size(); }
  State state(std::uint32_t i) const { return {i}; }
  std::uint32_t choices(State s) const { return static_cast<std::uint32_t>(of[s.index].size()); }
  template <class Visit>
  void for_each_outcome(State s, std::uint32_t k, const Visit& visit) const {
    for (const auto& [target, p] : of[s.index][k].outcomes) visit(target, p, false);
  }
  auto good() const {
    return [this](State s, std::uint32_t k) { return of[s.index][k].good; };
  }
};

// By state, the expected steps of good choices: of the given ones, or the least. Infinite: above `most`.
std::vector<double> expected_steps(const Moves& moves, const std::vector<std::uint32_t>& order, const Choices* given,
                                   double most = 1e5) {
  std::vector<double> steps(moves.states(), 0);  // none where a run ends
  for (double change = 1; change > 1e-12;) {
    change = 0;
    for (const std::uint32_t i : order) {
      double least = INFINITY;
      for (std::uint32_t k = 0; k < moves.of[i].size(); ++k) {
        if (given != nullptr ? (*given)[i] != k : !moves.of[i][k].good) continue;
        double sum = 1;
        for (const auto& [target, p] : moves.of[i][k].outcomes)
          if (target != Moves::trap) sum += p * steps[target];
        least = std::min(least, sum);
      }
      if (least > most) least = INFINITY;
      if (least != steps[i]) change = std::max(change, std::isinf(least) ? 1.0 : std::abs(least - steps[i]) / least);
      steps[i] = least;
    }
  }
  return steps;
}

struct Hurried {
  bool done;
  Strategy strategy;
};
Hurried hurried(const Moves& moves, const std::vector<std::uint32_t>& order, const IterationOptions& limits = {},
                std::size_t layers = 1) {
  Hurried out{false, {Choices(moves.states()), 0}};
  out.done = hurry(moves, {order, layers}, moves.good(), limits, out.strategy);
  return out;
}

Moves small_model(std::mt19937& random, std::uint32_t states) {
  Moves out;
  out.of.resize(states);
  for (auto& moves : out.of)
    for (std::size_t k = 0, many = 1 + random() % 3; k < many; ++k) {
      const auto target = [&] {
        const auto t = static_cast<std::uint32_t>(random() % (states + 1));
        return t == states ? Moves::trap : t;
      };
      const std::uint32_t one = target(), other = target();
      const double p = one == other ? 1 : static_cast<double>(2 + random() % 5) / 8;
      Moves::Move& move = moves.emplace_back(Moves::Move{k == 0 || random() % 3 > 0, {{one, p}}});
      if (p < 1) move.outcomes.emplace_back(other, 1 - p);
    }
  return out;
}

TEST(LeastSteps, AreThoseOfTheSwiftestOfAllGoodChoices) {
  std::mt19937 random(91);
  int ended = 0, endless = 0, not_first = 0;
  for (int i = 0; i < waymark::testing::scaled(2'000); ++i) {
    const auto states = static_cast<std::uint32_t>(2 + random() % 5);
    const Moves moves = small_model(random, states);
    std::vector<std::uint32_t> order(states);
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    order.resize(1 + random() % states);
    const std::vector<double> least = expected_steps(moves, order, nullptr);
    const auto [done, strategy] = hurried(moves, order);
    const bool ends = std::none_of(least.begin(), least.end(), [](double n) { return std::isinf(n); });
    ASSERT_EQ(done, ends) << i;
    const std::vector<double> found = expected_steps(moves, order, &strategy.choice);
    for (std::uint32_t s = 0; s < states; ++s) {
      const bool is_asked = std::find(order.begin(), order.end(), s) != order.end();
      ASSERT_EQ(strategy.choice[s] != Choices::none, is_asked) << i << ", state " << s;
      if (!is_asked) continue;
      ASSERT_TRUE(moves.of[s][strategy.choice[s]].good) << i << ", state " << s;
      ASSERT_TRUE(!ends || found[s] <= least[s] * 1.01) << i << ", state " << s;
      not_first += strategy.choice[s] > 0 ? 1 : 0;
    }
    ++(ends ? ended : endless);
  }
  EXPECT_GT(ended, waymark::testing::scaled(200));
  EXPECT_GT(endless, waymark::testing::scaled(50));
  EXPECT_GT(not_first, waymark::testing::scaled(200));
}

// Layers of states: forward by a choice that may slip back, or out at once after a wait. Several chunks.
Moves layered(std::mt19937& random, std::uint32_t width, std::uint32_t layers) {
  Moves out;
  out.of.resize(std::size_t{width} * layers);
  for (std::uint32_t i = 0; i < out.of.size(); ++i) {
    const std::uint32_t layer = i / width;
    const auto beside = [&](std::uint32_t of) { return of * width + static_cast<std::uint32_t>(random() % width); };
    const std::uint32_t nearer = layer == 0 ? Moves::trap : beside(layer - 1);
    const std::uint32_t farther = beside(std::min(layer + 1, layers - 1));
    const double wait = static_cast<double>(2 + random() % (3 * std::size_t{layers}));
    out.of[i] = {{true, {{nearer, 0.7}, {farther, 0.3}}},
                 {false, {{Moves::trap, 1}}},
                 {true, {{i, 1 - 1 / wait}, {Moves::trap, 1 / wait}}}};
  }
  return out;
}

TEST(LeastSteps, AreFoundChunkByChunkWithTheSameChoicesForAnyThreads) {
  std::mt19937 random(92);
  for (const std::uint32_t layers : {3U, 20U, 60U, 140U}) {
    const Moves moves = layered(random, 30, layers);  // 4,200 states are in two parts
    std::vector<std::uint32_t> order(moves.states());
    std::iota(order.begin(), order.end(), 0U);
    const auto [done, strategy] = hurried(moves, order, {}, layers);
    EXPECT_TRUE(done);
    const std::vector<double> least = expected_steps(moves, order, nullptr),
                              found = expected_steps(moves, order, &strategy.choice);
    std::set<std::uint32_t> chosen;
    for (std::uint32_t s = 0; s < moves.states(); ++s) {
      EXPECT_LE(found[s], least[s] * 1.005) << layers << " layers, state " << s;
      chosen.insert(strategy.choice[s]);
    }
    EXPECT_EQ(chosen, (std::set<std::uint32_t>{0, 2}));
    for (const std::size_t threads : {2U, 3U}) {
      const Hurried other = hurried(moves, order, {.sweepers = {.threads = threads}}, layers);
      EXPECT_TRUE(other.done);
      for (std::uint32_t s = 0; s < moves.states(); ++s) EXPECT_EQ(other.strategy.choice[s], strategy.choice[s]);
    }
  }
}

TEST(LeastSteps, AreNotFoundWhenARunMayNotEndOrAStopIsAskedFor) {
  const Moves endless{{{{true, {{0, 1}}}}}};
  EXPECT_FALSE(hurried(endless, {0}).done);
  const Moves slow{{{{true, {{0, 0.5}, {Moves::trap, 0.5}}}}}};
  EXPECT_TRUE(hurried(slow, {0}).done);
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(hurried(slow, {0}, {.stop = source.get_token()}).done);
}

// States 0 and 2 are asked, in the order 2, 0; state 1 is where a run ends.
const Moves three{{{{true, {{2, 0.25}, {1, 0.75}}}, {false, {{0, 1}}}, {true, {{0, 0.5}, {2, 0.5}}}},
                   {{true, {{0, 1}}}},
                   {{false, {{1, 1}}}, {true, {{Moves::trap, 0.5}, {0, 0.5}}}}}};

TEST(GoodChoices, AreWrittenInTheOrderThatIsGiven) {
  GoodChoices written;
  ASSERT_TRUE(written.write(three, {2, 0}, three.good(), 100));
  EXPECT_EQ(written.states(), 2U);
  EXPECT_EQ(written.first_choice, (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_EQ(written.choice, (std::vector<std::uint32_t>{1, 0, 2}));
  EXPECT_EQ(written.first_outcome, (std::vector<std::uint32_t>{0, 1, 2, 4}));
  EXPECT_EQ(written.target, (std::vector<std::uint32_t>{1, 0, 1, 0}));
  EXPECT_EQ(written.probability, (std::vector<float>{0.5F, 0.25F, 0.5F, 0.5F}));
  EXPECT_TRUE(GoodChoices().write(three, {2, 0}, three.good(), 4));
  EXPECT_FALSE(GoodChoices().write(three, {2, 0}, three.good(), 3));
}

TEST(GoodChoices, ASweepFindsTheLeastStepsAndHowMuchTheyChange) {
  GoodChoices written;
  ASSERT_TRUE(written.write(three, {2, 0}, three.good(), 100));
  std::vector<float> steps{4, 8};
  std::uint32_t swiftest = UINT32_MAX;
  EXPECT_FLOAT_EQ(written.sweep(1, steps, swiftest), 3);  // from 8 to 1 + 4/4, by the first of its choices
  EXPECT_EQ(swiftest, 1U);
  EXPECT_EQ(steps, (std::vector<float>{4, 2}));
  EXPECT_FLOAT_EQ(written.sweep(0, steps, swiftest), 1);  // from 4 to 1 + 2/2
  EXPECT_EQ(swiftest, 0U);
  EXPECT_EQ(steps, (std::vector<float>{2, 2}));
  steps = {8, 0};
  EXPECT_FLOAT_EQ(written.sweep(1, steps, swiftest), 1);  // of 3 and 5 the first
  EXPECT_EQ(swiftest, 1U);
  steps = {20, 1};
  written.sweep(1, steps, swiftest);  // of 6 and 11.5 the first
  EXPECT_EQ(swiftest, 1U);
  steps = {20, -40};
  written.sweep(1, steps, swiftest);  // of 6 and -9 the second
  EXPECT_EQ(swiftest, 2U);
}

// Part after part, each in the order; chunks are those of the order.
TEST(OrderedParts, HoldTheStatesInTheirOrder) {
  std::mt19937 random(93);
  Moves moves;
  moves.of.resize(9'000);
  SweepOrder<std::uint32_t> order{std::vector<std::uint32_t>(9'000), 50};
  std::iota(order.states.begin(), order.states.end(), 0U);
  std::shuffle(order.states.begin(), order.states.end(), random);
  order.states.resize(8'500);
  const OrderedParts parts = OrderedParts::of(moves, order);
  ASSERT_EQ(parts.count(), 2U);
  ASSERT_EQ(parts.chunks, (8'500 + order.chunk_size() - 1) / order.chunk_size());
  std::vector<std::uint32_t> next = {parts.begin[0], parts.begin[1]};
  EXPECT_EQ(next[0], 0U);
  for (std::size_t i = 0; i < order.states.size(); ++i) {
    const std::uint32_t part = order.states[i] < 4'500 ? 0 : 1, at = next[part]++;
    ASSERT_EQ(parts.states[at], order.states[i]) << i;
    ASSERT_EQ(parts.part(at), part) << i;
    ASSERT_EQ(parts.chunk(part, at), i / order.chunk_size()) << i;
  }
  EXPECT_EQ(next[0], parts.begin[1]);
  EXPECT_EQ(next[1], parts.begin[2]);
  EXPECT_EQ(parts.begin[2], 8'500U);
}

// An outcome into another part leads to a copy, the same for all states of a part.
TEST(OrderedParts, OutcomesIntoOtherPartsLeadToCopies) {
  Moves moves;
  for (std::uint32_t i = 0; i < 4'000; ++i)
    moves.of.push_back({{true, {{(i + 1) % 4'000, 0.5}, {i < 2'000 ? 3'000U : i, 0.5}}}});
  SweepOrder<std::uint32_t> order{std::vector<std::uint32_t>(4'000), 10};
  std::iota(order.states.begin(), order.states.end(), 0U);
  const OrderedParts parts = OrderedParts::of(moves, order);
  ASSERT_EQ(parts.begin, (std::vector<std::uint32_t>{0, 2'000, 4'000}));
  GoodChoices written;
  ASSERT_TRUE(written.write(moves, parts.states, moves.good(), 100'000));
  const std::vector<PlaceOfCopy> copies = written.copy_between(parts);
  ASSERT_EQ(copies.size(), 3U);  // of 3000 and 2000 for the first part, of 0 for the second
  const std::array<std::uint32_t, 3> from{3'000, 2'000, 0}, owner{1, 1, 0}, chunk{1, 1, 0};
  for (std::uint32_t c = 0; c < 3; ++c) {
    EXPECT_EQ(copies[c].from, from[c]);
    EXPECT_EQ(copies[c].to, 4'000 + c);
    EXPECT_EQ(copies[c].owner, owner[c]);
    EXPECT_EQ(copies[c].reader, 1 - owner[c]);
    EXPECT_EQ(copies[c].chunk, chunk[c]);
  }
  EXPECT_EQ(written.target[0], 1U);
  EXPECT_EQ(written.target[1], 4'000U);
  EXPECT_EQ(written.target[3], 4'000U);
  EXPECT_EQ(written.target[3'998], 4'001U);  // of 1999
  EXPECT_EQ(written.target[7'998], 4'002U);  // of 3999
  EXPECT_EQ(written.target[7'999], 3'999U);
}

// Of three parts two may have copies of one state of the third.
TEST(OrderedParts, EachPartHasCopiesOfItsOwn) {
  constexpr std::uint32_t states = 96'000;
  std::mt19937 random(94);
  Moves moves;
  for (std::uint32_t i = 0; i < states; ++i) {
    const auto some = static_cast<std::uint32_t>(random() % 40 * (states / 40));
    moves.of.push_back({{true, {{(i + 1) % states, 0.5}, {some, 0.5}}}});
  }
  SweepOrder<std::uint32_t> order{std::vector<std::uint32_t>(states), 10};
  std::iota(order.states.begin(), order.states.end(), 0U);
  const OrderedParts parts = OrderedParts::of(moves, order);
  ASSERT_EQ(parts.count(), 3U);
  GoodChoices written;
  ASSERT_TRUE(written.write(moves, parts.states, moves.good(), 1'000'000));
  const std::vector<std::uint32_t> targets = written.target;
  const std::vector<PlaceOfCopy> copies = written.copy_between(parts);
  std::set<std::pair<std::uint32_t, std::uint32_t>> read;
  for (std::uint32_t c = 0; c < copies.size(); ++c) {
    EXPECT_EQ(copies[c].to, states + c);
    EXPECT_EQ(copies[c].owner, parts.part(copies[c].from));
    EXPECT_EQ(copies[c].chunk, parts.chunk(copies[c].owner, copies[c].from));
    EXPECT_TRUE(read.emplace(copies[c].reader, copies[c].from).second) << "one copy is enough";
  }
  for (std::uint32_t i = 0; i < states; ++i)
    for (std::uint32_t o = written.first_outcome[i]; o < written.first_outcome[i + 1]; ++o) {
      const bool is_copy = written.target[o] >= states;
      ASSERT_EQ(is_copy, parts.part(targets[o]) != parts.part(i)) << i;
      ASSERT_EQ(is_copy ? copies[written.target[o] - states].from : written.target[o], targets[o]) << i;
      ASSERT_TRUE(!is_copy || copies[written.target[o] - states].reader == parts.part(i)) << i;
    }
}

TEST(SweepOrder, AChunkHoldsFourLayers) {
  SweepOrder<std::uint32_t> order{std::vector<std::uint32_t>(1'000), 10};
  EXPECT_EQ(order.chunk_size(), 400U);
  order.layers = 1'000;  // a chunk has 64 states at least
  EXPECT_EQ(order.chunk_size(), 64U);
  order.layers = 0;
  EXPECT_EQ(order.chunk_size(), 4'000U);
}

}  // namespace
}  // namespace waymark::plan
