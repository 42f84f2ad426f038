// How long does a formula take to its minimal DFA, and how large is that? Planning families at growing sizes, and the
// benchmark sets in ../shared/ltl (or $WAYMARK_SHARED/ltl) where they are there: each line once under a limit of CPU
// time, WAYMARK_LIMIT_SECONDS (10). Counters: states and nodes of the result; of a set: lines, equal and different to
// the counts in facts/, timeouts, and the slowest line in seconds.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "libautomata/finite/guard.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/places.hpp"

namespace waymark::automata {
namespace {

namespace fs = std::filesystem;

std::string p(std::size_t i) { return "p" + std::to_string(i); }

std::string visit_all(std::size_t n) {
  std::string out = "F p1";
  for (std::size_t i = 2; i <= n; ++i) out += " & F " + p(i);
  return out;
}
std::string visit_in_order(std::size_t n) {
  std::string out = "F " + p(n);
  for (std::size_t i = 1; i < n; ++i) out += " & (!" + p(i + 1) + " U " + p(i) + ")";
  return out;
}
std::string delivery(std::size_t legs) {  // F (pick1 & X F (drop1 & X F (pick2 & …
  std::string out = "F " + p(2 * legs);
  for (std::size_t i = 2 * legs - 1; i >= 1; --i) out = "F (" + p(i) + " & X " + out + ")";
  return out;
}
std::string responses(std::size_t n) {
  std::string out = "true";
  for (std::size_t i = 1; i <= n; ++i) out += " & G (a" + std::to_string(i) + " -> F b" + std::to_string(i) + ")";
  return out;
}
std::string visit_and_avoid(std::size_t n) { return visit_all(n) + " & G !z"; }

void family(benchmark::State& state, std::string (*make)(std::size_t)) {
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(make(static_cast<std::size_t>(state.range(0))), arena);
  std::size_t states = 0, nodes = 0;
  for (auto _ : state) {
    const Dfa dfa = ltlf_to_dfa(f);
    states = dfa.states();
    nodes = count_nodes(dfa);
  }
  state.counters["states"] = static_cast<double>(states);
  state.counters["nodes"] = static_cast<double>(nodes);
}
BENCHMARK_CAPTURE(family, visit_all, visit_all)->Arg(1)->Arg(2)->Arg(4)->Arg(8)->Arg(12)->Arg(16)->Arg(18);
BENCHMARK_CAPTURE(family, visit_in_order, visit_in_order)->Arg(2)->Arg(8)->Arg(32)->Arg(128);
BENCHMARK_CAPTURE(family, delivery, delivery)->Arg(2)->Arg(12)->Arg(48);
BENCHMARK_CAPTURE(family, responses, responses)->Arg(2)->Arg(8)->Arg(12)->Arg(16);
BENCHMARK_CAPTURE(family, visit_and_avoid, visit_and_avoid)->Arg(8)->Arg(16);

double cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Outcome {
  std::string states;  // "TO" when the limit was met
  double seconds;
};
Outcome translate(const std::string& line, double limit) {
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(line, arena, {.dialect = ltl::Dialect::Spot});
  std::stop_source source;
  const double begin = cpu_seconds();
  const std::jthread timer([&](const std::stop_token& done) {
    while (!done.stop_requested() && cpu_seconds() < begin + limit)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (!done.stop_requested()) source.request_stop();
  });
  const auto found = ltlf_to_dfa(f, {.states = SIZE_MAX, .stop = source.get_token()});
  const double seconds = cpu_seconds() - begin;
  if (const Dfa* dfa = std::get_if<Dfa>(&found)) return {std::to_string(dfa->states()), seconds};
  return {"TO", seconds};
}

// Column min_complete_dfa_states of the facts, "?" where there is none.
std::vector<std::string> facts(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::string> out;
  std::size_t column = SIZE_MAX;
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    if (column == SIZE_MAX) {
      column = static_cast<std::size_t>(std::find(row.begin(), row.end(), "min_complete_dfa_states") - row.begin());
    } else {
      out.push_back(column < row.size() ? row[column] : "?");
    }
  }
  return out;
}

void set(benchmark::State& state, const fs::path& path, const fs::path& facts_path, double limit) {
  const std::vector<std::string> expected = facts(facts_path);
  for (auto _ : state) {
    std::ifstream in(path);
    double lines = 0, equal = 0, different = 0, timeouts = 0, slowest = 0, answered = 0;
    std::size_t i = 0;
    for (std::string line; std::getline(in, line); ++i) {
      const Outcome outcome = translate(line, limit);
      const std::string fact = i < expected.size() ? expected[i] : "?";
      const bool known = fact.find_first_not_of("0123456789") == std::string::npos;
      ++lines;
      timeouts += outcome.states == "TO" ? 1 : 0;
      equal += known && outcome.states == fact ? 1 : 0;
      different += known && outcome.states != "TO" && outcome.states != fact ? 1 : 0;
      if (outcome.states != "TO") answered += outcome.seconds;
      slowest = std::max(slowest, outcome.seconds);
    }
    state.counters["lines"] = lines;
    state.counters["equal"] = equal;
    state.counters["different"] = different;
    state.counters["timeouts"] = timeouts;
    state.counters["slowest_s"] = slowest;
    state.counters["answered_s"] = answered;
  }
}

fs::path shared_formulas() { return testing::shared() / "ltl"; }

const bool registered = [] {
  const char* seconds = std::getenv("WAYMARK_LIMIT_SECONDS");
  const double limit = seconds != nullptr ? std::atof(seconds) : 10;
  std::vector<fs::path> files;
  if (fs::is_directory(shared_formulas()))
    for (const auto& entry : fs::directory_iterator(shared_formulas()))
      if (entry.path().extension() == ".ltlf") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& path : files) {
    const fs::path facts_path = path.parent_path() / "facts" / (path.stem().string() + ".tsv");
    benchmark::RegisterBenchmark(("set/" + path.stem().string()).c_str(), set, path, facts_path, limit)
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
  }
  return true;
}();

}  // namespace
}  // namespace waymark::automata
