// Parts of an array that are swept side by side, against a loop over them: the same numbers, passes and decisions, to
// the last bit, on any number of threads. What a part reads of others is what these had after the pass before.
#include "libplan/solve/side_by_side.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "libplan/solve/exchange.hpp"
#include "tests/libplan/solve/fronts.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t chunk_of_net = 4;

// Numbers each of which is made of some others. A number belongs to a part, and to a chunk by its place.
struct PartedNet {
  std::size_t parts;
  std::vector<std::uint32_t> part_of;
  std::vector<std::vector<std::uint32_t>> neighbours;
  std::vector<double> numbers;

  std::size_t size() const { return part_of.size(); }
  std::size_t chunks() const { return (size() + chunk_of_net - 1) / chunk_of_net; }

  // value(i): of a number that is read.
  template <class Value>
  double step(std::size_t i, const Value& value) {
    double sum = 1;
    for (const std::uint32_t n : neighbours[i]) sum += value(n) / (1.1 * static_cast<double>(neighbours[i].size()));
    const double change = std::abs(sum - numbers[i]);
    numbers[i] = sum;
    return change;
  }

  // Of a part, in a pass: the first chunk that has not settled.
  template <class Value>
  std::size_t sweep(std::uint32_t part, const Pass& pass, double least, const Value& value) {
    std::size_t unsettled = pass.end;
    for (std::size_t chunk = pass.begin; chunk < pass.end; ++chunk)
      for (std::size_t i = chunk * chunk_of_net; i < std::min(size(), (chunk + 1) * chunk_of_net); ++i)
        if (part_of[i] == part && step(i, value) > least) unsettled = std::min(unsettled, chunk);
    return unsettled;
  }
};

PartedNet random_parted_net(std::mt19937_64& random) {
  const std::size_t size = 1 + random() % 120, parts = 1 + random() % 5;
  const bool only_last_reads = random() % 4 == 0;  // of the others
  PartedNet net{parts, std::vector<std::uint32_t>(size), std::vector<std::vector<std::uint32_t>>(size),
                std::vector<double>(size)};
  for (std::size_t i = 0; i < size; ++i) {
    net.part_of[i] = static_cast<std::uint32_t>(random() % parts);
    net.numbers[i] = static_cast<double>(random() % 100);
    if (only_last_reads && net.part_of[i] + 1 < parts) continue;
    for (std::size_t k = random() % 4; k > 0; --k)
      net.neighbours[i].push_back(static_cast<std::uint32_t>(random() % size));
  }
  return net;
}

// What others have is what they had when the pass began.
std::string parts_by_a_loop(PartedNet& net, double least) {
  testing::Fronts fronts{net.chunks()};
  for (std::optional<Pass> pass = fronts.first(); pass;) {
    const std::vector<double> before = net.numbers;
    std::size_t unsettled = pass->end;
    for (std::uint32_t part = 0; part < net.parts; ++part)
      unsettled = std::min(unsettled, net.sweep(part, *pass, least, [&](std::uint32_t n) {
        return net.part_of[n] == part ? net.numbers[n] : before[n];
      }));
    pass = fronts(*pass, unsettled);
  }
  return fronts.told;
}

// Copies of what a part reads of others stand behind the numbers.
std::string side_by_side(PartedNet& net, double least, std::size_t threads) {
  const auto size = static_cast<std::uint32_t>(net.size());
  std::vector<std::vector<std::uint32_t>> copy_of(net.parts, std::vector<std::uint32_t>(size, UINT32_MAX));
  std::vector<PlaceOfCopy> copies;
  for (std::uint32_t i = 0; i < size; ++i)
    for (const std::uint32_t n : net.neighbours[i]) {
      std::uint32_t& copy = copy_of[net.part_of[i]][n];
      if (net.part_of[n] == net.part_of[i] || copy != UINT32_MAX) continue;
      copy = size + static_cast<std::uint32_t>(copies.size());
      copies.push_back({net.part_of[n], net.part_of[i], static_cast<std::uint32_t>(n / chunk_of_net), n, copy});
    }
  net.numbers.resize(size + copies.size());
  Exchange<double> exchange(net.parts, net.chunks(), std::move(copies));
  exchange.copy(net.numbers);
  testing::Fronts fronts{net.chunks()};
  const auto work = [&](std::size_t p, const PassInTurn& now) {
    const auto part = static_cast<std::uint32_t>(p);
    exchange.take(part, now, net.numbers);
    const std::size_t unsettled = net.sweep(part, now.pass, least, [&](std::uint32_t n) {
      return net.numbers[net.part_of[n] == part ? n : copy_of[part][n]];
    });
    exchange.tell(part, now, net.numbers);
    return unsettled;
  };
  passes_side_by_side(net.parts, threads, fronts.first(), work,
                      [&](const Pass& pass, std::size_t unsettled) { return fronts(pass, unsettled); });
  net.numbers.resize(size);
  return fronts.told;
}

TEST(SideBySide, PassesAreThoseOfALoop) {
  std::size_t many_passes = 0;
  for (std::uint64_t seed = 1; seed <= 160; ++seed) {
    std::mt19937_64 random(seed);
    const PartedNet net = random_parted_net(random);
    const double least = std::pow(10, -static_cast<double>(random() % 8));
    PartedNet expected = net;
    const std::string told = parts_by_a_loop(expected, least);
    many_passes += told.size() > 200 ? 1 : 0;
    for (const std::size_t threads : {1U, 2U, 3U, 7U}) {
      PartedNet found = net;
      ASSERT_EQ(side_by_side(found, least, threads), told) << "seed " << seed << ", threads " << threads;
      ASSERT_EQ(found.numbers, expected.numbers) << "seed " << seed << ", threads " << threads;
    }
  }
  EXPECT_GT(many_passes, 50U);
}

// Every part once a pass, whoever is late: one that sleeps has its other parts taken from it.
TEST(SideBySide, EveryPartIsWorkedOnOnceAPass) {
  constexpr std::size_t parts = 6, passes = 40;
  std::vector<std::atomic<int>> worked(parts * passes);
  const auto work = [&](std::size_t part, const PassInTurn& now) {
    ++worked[now.number * parts + part];
    EXPECT_EQ(now.pass.end, now.number + 1);
    EXPECT_EQ(now.before.end, now.number);
    if (now.number % 10 == 3 && part == 1) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return part == 2 ? std::size_t{0} : now.pass.end;
  };
  std::size_t decided = 0;
  passes_side_by_side(parts, 3, {0, 1}, work, [&](const Pass& pass, std::size_t unsettled) {
    EXPECT_EQ(pass.end, ++decided);
    EXPECT_EQ(unsettled, 0U);
    return decided == passes ? std::nullopt : std::optional(Pass{0, decided + 1});
  });
  EXPECT_EQ(decided, passes);
  for (const std::atomic<int>& times : worked) EXPECT_EQ(times, 1);
}

TEST(Exchange, APassOfOtherNumbersTakesNothingFromTheOneBefore) {
  Exchange<float> exchange(2, 1, {{0, 1, 0, 0, 1}});
  std::vector<float> numbers{5, 0}, others{7, 8};
  exchange.tell(0, {{0, 1}, {0, 0}, 0}, numbers);
  exchange.take(1, {{0, 1, 1, true}, {0, 1}, 1}, others);
  EXPECT_EQ(others[1], 8);
  exchange.take(0, {{0, 1}, {0, 1}, 1}, others);  // a part that reads nothing
  exchange.take(1, {{0, 1}, {0, 0}, 1}, others);  // no chunk was told
  EXPECT_EQ(others[1], 8);
  exchange.take(1, {{0, 1}, {0, 1}, 1}, others);
  EXPECT_EQ(others[1], 5);
}

}  // namespace
}  // namespace waymark::plan
