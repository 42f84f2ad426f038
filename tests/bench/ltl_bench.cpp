// How large are the Büchi automata of LTL formulas, beside the peers' best, and how long do they take? Every line of
// the benchmark sets in ../shared/ltl (or $WAYMARK_SHARED/ltl) once, under a limit of CPU time, WAYMARK_LIMIT_SECONDS
// (8). Counters: lines; states and edges, ours and those in facts/, summed over the lines where both are known; lines
// where ours has more than 1.1 × their states; timeouts; CPU seconds of all answers and of the slowest.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/limits.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/places.hpp"

namespace waymark::automata {
namespace {

namespace fs = std::filesystem;

double cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Outcome {
  std::optional<Automaton> automaton;  // none when the limit was met
  double seconds;
};
using Translate = std::variant<Translated, Exhausted> (*)(ltl::Formula, const ltl::Limits&);

Outcome translate(Translate run, const std::string& line, double limit) {
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(line, arena);
  std::stop_source source;
  const double begin = cpu_seconds();
  const std::jthread timer([&](const std::stop_token& done) {
    while (!done.stop_requested() && cpu_seconds() < begin + limit)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (!done.stop_requested()) source.request_stop();
  });
  auto found = run(f, {.stop = source.get_token()});
  const double seconds = cpu_seconds() - begin;
  if (auto* made = std::get_if<Translated>(&found)) return {std::move(made->automaton), seconds};
  return {std::nullopt, seconds};
}

struct Fact {
  double states = 0, edges = 0;
  bool known = false;
};
// Columns <kind>_states and <kind>_edges.
std::vector<Fact> facts(const fs::path& path, const std::string& kind) {
  std::ifstream in(path);
  std::vector<Fact> out;
  std::vector<std::string> header;
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    if (header.empty()) {
      header = row;
      continue;
    }
    const auto number = [&](const std::string& name) {
      const auto at = static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
      const std::string text = at < row.size() ? row[at] : "";
      const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
      return digits ? std::stod(text) : -1.0;
    };
    const double states = number(kind + "_states"), edges = number(kind + "_edges");
    out.push_back({states, edges, states >= 0 && edges >= 0});
  }
  return out;
}

void set(benchmark::State& state, Translate run, const std::string& kind, const fs::path& path,
         const fs::path& facts_path, double limit) {
  const std::vector<Fact> expected = facts(facts_path, kind);
  for (auto _ : state) {
    auto& out = state.counters;
    for (const char* name :
         {"lines", "states", "peer_states", "edges", "peer_edges", "above_1.1", "timeouts", "answered_s", "slowest_s"})
      out[name] = 0;
    std::ifstream in(path);
    std::size_t i = 0;
    for (std::string line; std::getline(in, line); ++i) {
      const Outcome outcome = translate(run, line, limit);
      ++out["lines"];
      out["timeouts"] += outcome.automaton ? 0 : 1;
      out["answered_s"] += outcome.automaton ? outcome.seconds : 0;
      out["slowest_s"] = std::max<double>(out["slowest_s"], outcome.seconds);
      if (!outcome.automaton || i >= expected.size() || !expected[i].known) continue;
      const auto states = static_cast<double>(outcome.automaton->states());
      out["states"] += states;
      out["peer_states"] += expected[i].states;
      out["edges"] += static_cast<double>(count_edges(outcome.automaton->transitions()));
      out["peer_edges"] += expected[i].edges;
      out["above_1.1"] += states > 1.1 * expected[i].states ? 1 : 0;
    }
  }
}

const bool registered = [] {
  const char* seconds = std::getenv("WAYMARK_LIMIT_SECONDS");
  const double limit = seconds != nullptr ? std::atof(seconds) : 8;
  const fs::path folder = testing::shared() / "ltl";
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".ltl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  const std::pair<const char*, Translate> kinds[] = {{"tgba", ltl_to_tgba}, {"ba", ltl_to_buchi}};
  for (const auto& [kind, run] : kinds)
    for (const fs::path& path : files)
      benchmark::RegisterBenchmark((std::string(kind) + "/" + path.stem().string()).c_str(), set, run,
                                   std::string(kind), path, folder / "facts" / (path.stem().string() + ".tsv"), limit)
          ->Iterations(1)
          ->Unit(benchmark::kSecond);
  return true;
}();

}  // namespace
}  // namespace waymark::automata
