// How long does MONA (Debian package mona) take to the minimal automata of the planning families that
// translate_bench.cpp times for us? A process for each, its start included: some milliseconds. Without MONA there is
// nothing to run.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string number(std::size_t i) { return std::to_string(i); }

// F p1 & … & F pn, in the logic of strings
std::string visit_all(std::size_t n) {
  std::string names = "p1", goals;
  for (std::size_t i = 2; i <= n; ++i) names += ", p" + number(i);
  for (std::size_t i = 1; i <= n; ++i) goals += "ex1 x: x in p" + number(i) + ";\n";
  return "m2l-str;\nvar2 " + names + ";\n" + goals;
}

// G (a1 -> F b1) & … & G (an -> F bn)
std::string responses(std::size_t n) {
  std::string names = "a1, b1", parts;
  for (std::size_t i = 2; i <= n; ++i) names += ", a" + number(i) + ", b" + number(i);
  for (std::size_t i = 1; i <= n; ++i)
    parts += "all1 x: x in a" + number(i) + " => ex1 y: x <= y & y in b" + number(i) + ";\n";
  return "m2l-str;\nvar2 " + names + ";\n" + parts;
}

// F (p1 & X F (p2 & …))
std::string delivery(std::size_t legs) {
  std::string names = "p1", chain;
  for (std::size_t i = 2; i <= 2 * legs; ++i) names += ", p" + number(i);
  for (std::size_t i = 1; i <= 2 * legs; ++i)
    chain += (i > 1 ? " & " : "") + ("ex1 x" + number(i)) + ": " +
             (i > 1 ? "x" + number(i - 1) + " < x" + number(i) + " & " : "") + "x" + number(i) + " in p" + number(i);
  return "m2l-str;\nvar2 " + names + ";\n" + chain + ";\n";
}

void mona(benchmark::State& state, std::string (*make)(std::size_t)) {
  const fs::path file = fs::temp_directory_path() / "waymark_mona_bench.mona";
  std::ofstream(file) << make(static_cast<std::size_t>(state.range(0)));
  const std::string command = "mona -q -n " + file.string() + " > /dev/null 2>&1";
  for (auto _ : state)
    if (std::system(command.c_str()) != 0) state.SkipWithError("mona is not installed, or ran out of nodes");
  fs::remove(file);
}
BENCHMARK_CAPTURE(mona, visit_all, visit_all)->Arg(8)->Arg(12)->Arg(16)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mona, responses, responses)->Arg(8)->Arg(12)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mona, delivery, delivery)->Arg(2)->Arg(4)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
