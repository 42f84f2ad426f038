// Roads of DIMACS: what is read, what is refused and where, and roads that were generated.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/generate_roads.hpp"
#include "libplan/model/formats/read_dimacs.hpp"
#include "libplan/roads/contract.hpp"
#include "libplan/roads/road_task.hpp"
#include "tests/libplan/roads/random_roads.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using testing::show;

RoadGraph parsed(const std::string& gr, const std::string& lab, std::string_view start = "") {
  std::istringstream roads(gr), labels(lab);
  return parse_dimacs(roads, labels, "town.gr", start);
}

TEST(Dimacs, ReadsArcsLabelsAndStart) {
  const std::string gr = "c a town\np sp 3 4\na 2 1 7\na 1 2 5\r\na 3 1 0\na 1 3 9\n";
  const std::string lab = "0=\"init\" 1=\"park\" 4=\"old town\"\n2: 1\n3: 0 4 1\n";
  const RoadGraph graph = parsed(gr, lab);
  EXPECT_EQ(testing::show(graph), "start 3\n1 {} 2:5 3:9\n2 {park} 1:7\n3 {park, \"old town\"} 1:0\n");
  EXPECT_EQ(parsed(gr, lab, "2").start(), 1U);
  EXPECT_EQ(parsed(gr, lab, "park").start(), 1U);
  EXPECT_EQ(parsed("p sp 1 0\n", "1=\"a\"\n1: 1\n").start(), 0U);
}

TEST(Dimacs, RefusesWithTheLine) {
  const std::string lab = "0=\"init\" 1=\"a\"\n1: 0 1\n";
  const auto message = [&](const std::string& gr, const std::string& labels, const std::string& start = "") {
    try {
      parsed(gr, labels, start);
    } catch (const ltl::FormatError& error) {
      return std::to_string(error.line()) + ": " + error.what();
    }
    return std::string("read");
  };
  const std::map<std::string, std::string> wrong{
      {"", "1: "},
      {"a 1 2 3\n", "1: "},
      {"p sp 2 1\na 1 3 1\n", "2: "},
      {"p sp 2 1\na 0 1 1\n", "2: "},
      {"p sp 2 1\na 1 2 -1\n", "2: "},
      {"p sp 2 1\na 1 2 2147483648\n", "2: "},
      {"p sp 2 1\na 1 2 1 1\n", "2: "},
      {"p sp 2 2\na 1 2 1\n", "3: "},
      {"p sp 2 0\na 1 2 1\n", "2: "},
      {"p sp 0 0\n", "1: "},
      {"p sp 2000000000 0\n", "1: "},
      {"p sp 1000000000 0\n", "2: "},
      {"p max 2 0\n", "1: "},
      {"p sp 2 0\np sp 2 0\n", "2: "},
      {"p sp 2 0\nx\n", "2: "},
  };
  for (const auto& [gr, line] : wrong) EXPECT_EQ(message(gr, lab).substr(0, line.size()), line) << gr;
  const std::string gr = "p sp 2 1\na 1 2 1\n";
  EXPECT_EQ(message(gr, lab), "read");
  for (const char* labels : {"", "0=\"init\"\n1: 0\n", "1=\"a\"\n3: 1\n", "1=\"a\"\n0: 1\n", "1=\"a\"\n1: 2\n",
                             "1=\"a\"\n", "1=\"a\" 1=\"b\"\n1: 1\n"})
    EXPECT_NE(message(gr, labels), "read") << labels;
  EXPECT_NE(message(gr, lab, "b").find("did you mean 'a'?"), std::string::npos);
  EXPECT_NE(message(gr, lab, "3").find("no node or label"), std::string::npos);
}

// The address space that this process may take, until the end of the scope: what it has and so many bytes more.
class MoreMemoryAtMost {
 public:
  explicit MoreMemoryAtMost(std::size_t bytes) {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = pages * 4'096 + bytes;
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MoreMemoryAtMost() { setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};

TEST(Dimacs, TakesMemoryForTheArcsThatAreThere) {
  if (waymark::testing::sanitized) GTEST_SKIP() << "a sanitizer takes more address space than there is memory";
  const MoreMemoryAtMost limit(std::size_t{128} << 20U);
  EXPECT_THROW(parsed("p sp 41 555555551\na 1 2 1\n", "0=\"a\"\n1: 0\n"), ltl::FormatError);
}

TEST(Dimacs, ReadsMoreArcsThanItBelievesAtFirst) {
  constexpr std::size_t arcs = 1'100'000;
  std::string gr = "p sp 2 " + std::to_string(arcs) + "\n";
  for (std::size_t i = 0; i < arcs; ++i) gr += "a 1 2 1\n";
  const RoadGraph graph = parsed(gr, "0=\"a\"\n1: 0\n");
  EXPECT_EQ(graph.arcs(), arcs);
}

TEST(Dimacs, WritesWhatItReads) {
  ltl::Random random(11);
  for (int i = 0; i < 50; ++i) {
    const RoadGraph graph = testing::random_roads(random, {.nodes = 12, .arcs = 30});
    const StateLabelled labelled = with_labels_on_states(model_of(graph));
    std::ostringstream gr, lab;
    write_dimacs(gr, lab, labelled);
    const RoadGraph again = parsed(gr.str(), lab.str());
    ASSERT_EQ(again.nodes(), labelled.mdp.states());
    for (const char* formula : {"F a", "!x U (a & F b)", "F x & F b"}) {
      const CaseTask task{"", formula, CaseTask::Logic::Ltlf, CaseTask::Query::MinSteps};
      EXPECT_EQ(answer(again, *contract(again), task).value.upper, answer(graph, *contract(graph), task).value.upper)
          << formula << '\n'
          << show(graph);
    }
  }
}

TEST(RoadGraph, KnowsWhereTheNodesOfALetterAreEntered) {
  ltl::Random random(12);
  for (int i = 0; i < 500; ++i) {
    const RoadGraph graph = testing::random_roads(random, {.nodes = 12, .arcs = 20, .labelled = 0.4});
    for (std::uint32_t l = 1; l < graph.letters().size(); ++l) {
      std::vector<std::uint32_t> expected;
      for (const std::uint32_t v : graph.nodes_of(LetterId{l})) {
        bool entered = false;
        for (std::uint32_t u = 0; u < graph.nodes(); ++u)
          for (const RoadGraph::Arc& arc : graph.arcs(u)) entered |= arc.to == v && graph.letter(u) != graph.letter(v);
        if (entered) expected.push_back(v);
      }
      const auto found = graph.entrances_of(LetterId{l});
      ASSERT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()), expected) << show(graph);
    }
  }
}

struct Files {
  std::string gr, co, lab;
};
Files generated(const RoadRecipe& recipe) {
  std::ostringstream gr, co, lab;
  generate_roads(recipe, gr, co, lab);
  return {gr.str(), co.str(), lab.str()};
}

TEST(GenerateRoads, HasSoManyNodesAndTasksThatCanBeDone) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const RoadRecipe recipe{.nodes = 3000, .landmarks = 4, .seed = seed};
    const Files files = generated(recipe);
    const RoadGraph graph = parsed(files.gr, files.lab);
    ASSERT_EQ(graph.nodes(), 3000U);
    EXPECT_EQ(std::count(files.co.begin(), files.co.end(), '\n'), 3001);
    const auto hierarchy = contract(graph);
    const CaseTask task{"", "!x U (a & (!x U (b & (!x U (c & (!x U d))))))", CaseTask::Logic::Ltlf,
                        CaseTask::Query::MinSteps};
    EXPECT_EQ(answer(graph, *hierarchy, task).status, CaseAnswer::Status::Solved) << "seed " << seed;
    EXPECT_EQ(files.gr, generated(recipe).gr);
  }
}

// Four nodes of five have two neighbours, and junctions mostly three.
TEST(GenerateRoads, HasTheDegreesOfStreets) {
  const Files files = generated({.nodes = 50'000});
  const RoadGraph graph = parsed(files.gr, files.lab);
  std::vector<std::vector<std::uint32_t>> neighbours(graph.nodes());
  for (std::uint32_t v = 0; v < graph.nodes(); ++v)
    for (const RoadGraph::Arc& arc : graph.arcs(v)) {
      neighbours[v].push_back(arc.to);
      neighbours[arc.to].push_back(v);
    }
  std::map<std::size_t, double> part;
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    part[list.size()] += 1.0 / static_cast<double>(graph.nodes());
  }
  EXPECT_GT(part[2], 0.75);
  EXPECT_LT(part[2], 0.9);
  EXPECT_GT(part[3], part[4]);
  EXPECT_GT(part[3], 0.05);
  EXPECT_EQ(part[0], 0);
}

TEST(GenerateRoads, RefusesWhatItCannotDraw) {
  EXPECT_THROW(generated({.nodes = 99}), std::invalid_argument);
  EXPECT_THROW(generated({.landmarks = 21}), std::invalid_argument);
  EXPECT_THROW(generated({.avoided = 0.5}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
