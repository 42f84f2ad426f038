// Sweeps by several threads against a loop: the same numbers, passes and decisions, to the last bit.
#include "libplan/solve/pipelined_passes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/formats/generate_grid.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/solve/decide.hpp"
#include "libplan/solve/mapped_files.hpp"
#include "tests/libplan/solve/fronts.hpp"

namespace waymark::plan {
namespace {

TEST(Sweepers, AreFreeWhereTheyDoNotWork) {
  EXPECT_EQ((Sweepers{.threads = 4}).free(), 4U);
  const std::pair<std::size_t, std::size_t> table[] = {{0, 4}, {1, 4}, {2, 3}, {4, 1}, {5, 1}, {9, 1}};
  for (const auto& [at_work, free] : table) {  // the one that asks is at work
    const std::atomic<std::size_t> working = at_work;
    EXPECT_EQ((Sweepers{.threads = 4, .working = &working}).free(), free) << at_work;
  }
}

constexpr std::size_t chunk_size = 4;

// Numbers each of which is made of some others, near by or anywhere.
struct Net {
  std::vector<std::vector<std::size_t>> neighbours;
  std::vector<double> numbers;

  double step(std::size_t i) {
    double sum = 1;
    for (const std::size_t n : neighbours[i]) sum += numbers[n] / (1.1 * static_cast<double>(neighbours[i].size()));
    const double change = std::abs(sum - numbers[i]);
    numbers[i] = sum;
    return change;
  }
  bool sweep(std::size_t chunk, double least) {
    bool settled = true;
    for (std::size_t i = chunk * chunk_size; i < std::min(numbers.size(), (chunk + 1) * chunk_size); ++i)
      settled = step(i) <= least && settled;
    return settled;
  }
  std::size_t chunks() const { return (numbers.size() + chunk_size - 1) / chunk_size; }
  ChunkReach reach() const {
    ChunkReach out(chunks());
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (const std::size_t n : neighbours[i]) out.relate(i / chunk_size, n / chunk_size);
    return out;
  }
};

Net random_net(std::mt19937_64& random) {
  const std::size_t size = 1 + random() % 200, width = 1 + random() % size;
  Net net{std::vector<std::vector<std::size_t>>(size), std::vector<double>(size)};
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = random() % 4; k > 0; --k)
      net.neighbours[i].push_back((i + size - std::min(i, width / 2) + random() % width) % size);
  for (double& number : net.numbers) number = static_cast<double>(random() % 100);
  return net;
}

std::string by_a_loop(Net& net, double least) {
  testing::Fronts fronts{net.chunks()};
  for (std::optional<Pass> pass = fronts.first(); pass;) {
    std::size_t unsettled = pass->end;
    for (std::size_t c = pass->begin; c < pass->end; ++c)
      if (!net.sweep(c, least) && unsettled == pass->end) unsettled = c;
    pass = fronts(*pass, unsettled);
  }
  return fronts.told;
}

TEST(PipelinedPasses, AreThoseOfALoop) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    std::mt19937_64 random(seed);
    const Net net = random_net(random);
    const double least = std::pow(10, -static_cast<double>(random() % 8));
    Net expected = net;
    const std::string told = by_a_loop(expected, least);
    for (const std::size_t threads : {1U, 2U, 3U, 5U}) {
      Net found = net;
      testing::Fronts fronts{found.chunks()};
      pipelined_passes(
          found.reach(), threads, fronts.first(),
          [&](std::size_t chunk, const Pass&) { return found.sweep(chunk, least); },
          [&](const Pass& pass, std::size_t unsettled) { return fronts(pass, unsettled); });
      ASSERT_EQ(fronts.told, told) << "seed " << seed << ", threads " << threads;
      ASSERT_EQ(found.numbers, expected.numbers) << "seed " << seed << ", threads " << threads;
    }
  }
}

// No pass works on a chunk before an earlier one has left all that goes with it: chunks are slow here, so that a pass
// which does not wait comes too early. The second pass has one chunk and is done long before the first.
TEST(PipelinedPasses, FollowAtADistance) {
  constexpr std::size_t chunks = 5;
  ChunkReach reach(chunks);
  reach.relate(0, 1);
  reach.relate(2, 4);
  const std::vector<std::size_t> ends{chunks, 1, chunks, chunks};
  std::vector<std::vector<std::atomic<bool>>> left(ends.size());
  for (auto& pass : left) pass = std::vector<std::atomic<bool>>(chunks);
  std::atomic<int> early = 0;
  pipelined_passes(
      reach, 3, {.begin = 0, .end = ends[0], .factor = 0},
      [&](std::size_t chunk, const Pass& pass) {
        const auto own = static_cast<std::size_t>(pass.factor);
        for (std::size_t before = 0; before < own; ++before)
          for (std::size_t c = 0; c <= reach[chunk] && c < ends[before]; ++c) early += left[before][c] ? 0 : 1;
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        left[own][chunk] = true;
        return false;
      },
      [&](const Pass& pass, std::size_t) -> std::optional<Pass> {
        const auto next = static_cast<std::size_t>(pass.factor) + 1;
        if (next == ends.size()) return std::nullopt;
        return Pass{.begin = 0, .end = ends[next], .factor = static_cast<double>(next)};
      });
  EXPECT_EQ(early, 0);
  for (std::size_t pass = 0; pass < ends.size(); ++pass)
    for (std::size_t c = 0; c < ends[pass]; ++c) EXPECT_TRUE(left[pass][c]) << pass << ", chunk " << c;
}

TEST(PipelinedPasses, OfOneThreadAreWorkedOnByTheCaller) {
  bool others = false;
  const std::thread::id own = std::this_thread::get_id();
  pipelined_passes(
      ChunkReach(3), 1, {.begin = 0, .end = 3},
      [&](std::size_t, const Pass&) {
        others = others || std::this_thread::get_id() != own;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        return false;
      },
      [&, passes = 0](const Pass& pass, std::size_t) mutable {
        return ++passes < 6 ? std::optional(pass) : std::nullopt;
      });
  EXPECT_FALSE(others);
}

TEST(PipelinedPasses, TakeNothingAtAll) {
  int passes = 0;
  pipelined_passes(
      ChunkReach(0), 3, {0, 0}, [](std::size_t, const Pass&) { return true; },
      [&](const Pass&, std::size_t) {
        ++passes;
        return std::optional<Pass>();
      });
  EXPECT_EQ(passes, 1);
}

std::string told(const std::optional<Decided>& decided, std::uint32_t states) {
  if (!decided) return "none";
  std::ostringstream out;
  out << std::hexfloat << decided->value.lower << ' ' << decided->value.upper << ' ' << decided->re_evaluated.lower
      << ' ' << decided->re_evaluated.upper << ' ' << decided->sweeps;
  for (std::uint32_t i = 0; i < states; ++i) out << ' ' << decided->strategy.choice[i];
  return out.str();
}

// Swept in place and written out, costs and probabilities: every bit, every count and every choice.
TEST(PipelinedPasses, DecideAsOneThreadDoes) {
  for (const GridKind kind : {GridKind::Scatter, GridKind::Bridge}) {
    std::ostringstream text;
    write_case(text, generate_grid({.kind = kind, .width = 90, .height = 70, .noise = 0.1, .seed = 4}));
    const PlanningCase read = parse_case(text.str());
    const auto& grid = std::get<GridWorld>(read.model);
    ltl::Arena arena(grid.letters().vocabulary());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("!x U (a & (!x U b))", arena)), grid.letters());
    const auto product = ProductMdp<GridWorld>::explore(grid, task);
    ASSERT_GT(product->states(), 8'000U) << "too small for equations to be shared";
    for (const std::size_t on_grid : {std::size_t{0}, SIZE_MAX}) {
      const auto solved = [&](std::size_t threads) {
        const IterationOptions options{.on_grid = on_grid, .sweepers = {.threads = threads}};
        return told(greatest_probability(*product, options), product->states()) + '\n' +
               told(least_cost(*product, options), product->states());
      };
      const std::string alone = solved(1);
      EXPECT_EQ(solved(2), alone) << name(kind);
      EXPECT_EQ(solved(3), alone) << name(kind);
    }
  }
}

// Values in files are those in memory.
TEST(MappedFiles, ChangeNoNumber) {
  for (const GridKind kind : {GridKind::Rooms, GridKind::Bridge}) {
    std::ostringstream text;
    write_case(text, generate_grid({.kind = kind, .width = 60, .height = 50, .noise = 0.1, .seed = 2}));
    const PlanningCase read = parse_case(text.str());
    const auto& grid = std::get<GridWorld>(read.model);
    ltl::Arena arena(grid.letters().vocabulary());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("!x U (a & (!x U b))", arena)), grid.letters());
    const auto product = ProductMdp<GridWorld>::explore(grid, task);
    MappedFiles files(::testing::TempDir(), 1'000);
    IterationOptions in_memory{.on_grid = 100}, in_files = in_memory;
    in_files.memory = &files;
    EXPECT_EQ(told(greatest_probability(*product, in_files), product->states()),
              told(greatest_probability(*product, in_memory), product->states()));
    EXPECT_EQ(told(least_cost(*product, in_files), product->states()),
              told(least_cost(*product, in_memory), product->states()));
    EXPECT_GE(files.most(), 16 * product->states()) << "the values were not there";
  }
}

}  // namespace
}  // namespace waymark::plan
