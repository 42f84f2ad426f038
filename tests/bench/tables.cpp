// The tables of docs/performance.md: the open benchmark sets in ../shared/ltl (or $WAYMARK_SHARED/ltl) beside what the
// peers answered, as Markdown. Ours come from the executable itself, one thread, in batch mode; theirs from facts/.
// bench_tables [TARGET…]: tgba, buchi, parity, ldba, dfa; all unless told otherwise.
#include <sys/resource.h>
#include <sys/wait.h>
#include <algorithm>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/benchmark_sets.hpp"

namespace waymark::testing {
namespace {

namespace fs = std::filesystem;
using Numbers = std::map<std::size_t, double>;  // by line of the set, where there is one

// A table of one row a line of the set, its columns by name.
class Rows {
 public:
  Rows() = default;
  Rows(const fs::path& path, std::string_view headings) {
    std::ifstream in(path);
    std::string line;
    if (headings.empty() && std::getline(in, line)) headings_ = cells(line);
    if (!headings.empty()) headings_ = cells(std::string(headings));
    for (std::size_t number = 1; std::getline(in, line); ++number) rows_[number] = cells(line);
  }
  Numbers column(const std::string& name) const {
    const auto at = static_cast<std::size_t>(std::find(headings_.begin(), headings_.end(), name) - headings_.begin());
    Numbers out;
    for (const auto& [number, row] : rows_) {
      double value = 0;
      if (at < row.size() && std::sscanf(row[at].c_str(), "%lf", &value) == 1) out[number] = value;
    }
    return out;
  }
  std::size_t size() const { return rows_.size(); }

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '\t');) out.push_back(cell);
    return out;
  }
  std::vector<std::string> headings_;
  std::map<std::size_t, std::vector<std::string>> rows_;
};

double children_seconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto of = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return of(used.ru_utime) + of(used.ru_stime);
}

struct Ours {
  Rows rows;
  double seconds = 0;  // of the processor, the whole process
};
Ours ours(const fs::path& set, const std::string& target) {
  const bool finite = target == "dfa";
  const fs::path out = fs::temp_directory_path() / "waymark_bench_tables.tsv";
  const std::string command =
      std::string(WAYMARK_EXECUTABLE) + " translate -F '" + set.string() + "' --to " + target +
      (finite ? " --semantics finite --dialect spot --limit-seconds 10" : " --limit-seconds 8") +
      " --format stats --threads 1 2>/dev/null >" + out.string();
  const double before = children_seconds();
  const int code = std::system(command.c_str());
  if (code != 0 && WEXITSTATUS(code) != 11) std::cerr << command << ": exit " << WEXITSTATUS(code) << '\n';
  return {Rows(out, ""), children_seconds() - before};
}

// The sum of `of` over the lines that `where` has too.
double sum(const Numbers& of, const Numbers& where) {
  double out = 0;
  for (const auto& [line, value] : of)
    if (where.contains(line)) out += value;
  return out;
}
double sum(const Numbers& of) { return sum(of, of); }
Numbers common(const Numbers& a, const Numbers& b) {
  Numbers out;
  for (const auto& [line, value] : a)
    if (b.contains(line)) out[line] = value;
  return out;
}
Numbers least(const Numbers& a, const Numbers& b) {
  Numbers out = a;
  for (const auto& [line, value] : b)
    if (const auto [at, fresh] = out.try_emplace(line, value); !fresh) at->second = std::min(at->second, value);
  return out;
}
template <class Test>
std::size_t count(const Numbers& a, const Numbers& b, const Test& test) {
  std::size_t out = 0;
  for (const auto& [line, value] : a)
    if (const auto other = b.find(line); other != b.end() && test(value, other->second)) ++out;
  return out;
}

std::string whole(double n) { return std::to_string(std::llround(n)); }
std::string seconds(double s) {
  char text[32];
  std::snprintf(text, sizeof text, s < 10 ? "%.2f" : "%.1f", s);
  return text;
}
void row(const std::vector<std::string>& cells) {
  std::string out = "|";
  for (const std::string& cell : cells) out += ' ' + cell + " |";
  std::cout << out << '\n';
}
void heading(const std::string& title, const std::vector<std::string>& cells) {
  std::cout << "\n" << title << "\n\n";
  row(cells);
  std::vector<std::string> rule(cells.size(), "---:");
  rule.front() = "---";
  row(rule);
}

constexpr auto more = [](double a, double b) { return a > b; };
constexpr auto fewer = [](double a, double b) { return a < b; };
constexpr auto much_more = [](double a, double b) { return a > 1.1 * b; };

const std::vector<std::string> infinite_sets{
    "dwyer", "etessami_holzmann", "somenzi_bloem", "pelanek_beem", "liberouter",
    "lily",  "families",          "random4",       "random6",      "pattern_conj"};
const std::vector<std::string> finite_sets{
    "dwyer", "declare", "declare_models", "families",    "patterns_u_gf",    "counters",
    "nim",   "random4", "random6",        "syft_random", "syft_random_lydia"};

fs::path set_path(const std::string& name, bool finite) {
  return benchmark_sets() / ((finite ? "ltlf_" : "ltl_") + name + (finite ? ".ltlf" : ".ltl"));
}
Rows facts(const std::string& name, bool finite, const std::string& suffix = ".tsv") {
  return Rows(benchmark_sets() / "facts" / ((finite ? "ltlf_" : "ltl_") + name + suffix), "");
}
std::string of_lines(const std::string& name, const Numbers& compared, const Rows& all) {
  return name + " (" + std::to_string(compared.size()) + " of " + std::to_string(all.size()) + ")";
}

// Spot's and LTL3BA's; `theirs` is the beginning of the columns' names.
void nondeterministic(const std::string& target, const std::string& theirs) {
  heading("LTL to " + target + "; our seconds are the processor's, of all lines; Spot's of those that it answers",
          {"set (lines)", "states", "Spot", "edges", "Spot", "> 1.1 ×", "fewer", "s", "Spot s", "LTL3BA answers",
           "states", "LTL3BA", "no answer"});
  for (const std::string& name : infinite_sets) {
    const auto [made, took] = ours(set_path(name, false), target);
    const Rows peer = facts(name, false);
    const Numbers states = made.column("states"), edges = made.column("edges"), time = made.column("seconds");
    const Numbers spot = peer.column(theirs + "_states"), spot_edges = peer.column(theirs + "_edges"),
                  spot_time = peer.column(theirs + "_s"), ltl3ba = peer.column("ltl3ba_" + theirs + "_states");
    const Numbers compared = common(states, spot), both = common(states, ltl3ba);
    row({of_lines(name, compared, made), whole(sum(compared)), whole(sum(spot, compared)), whole(sum(edges, compared)),
         whole(sum(spot_edges, compared)), std::to_string(count(states, spot, much_more)),
         std::to_string(count(states, spot, fewer)), seconds(took), seconds(sum(spot_time, compared)),
         std::to_string(ltl3ba.size()), whole(sum(both)), whole(sum(ltl3ba, both)),
         std::to_string(made.size() - states.size())});
  }
}

void parity() {
  heading("LTL to deterministic parity, line by line beside the smaller one of Spot's and Owl's",
          {"set (lines)", "states", "smaller of both", "Spot", "Owl", "more", "fewer", "s", "Spot s", "no answer"});
  for (const std::string& name : infinite_sets) {
    const auto [made, took] = ours(set_path(name, false), "parity");
    const Rows peer = facts(name, false), owl = facts(name, false, ".owl.tsv");
    const Numbers states = made.column("states"), spot = peer.column("dpa_states"),
                  by_owl = owl.column("owl_dpa_states");
    const Numbers best = least(spot, by_owl), compared = common(states, best);
    const auto whole_or_none = [&](const Numbers& n) {
      const Numbers both = common(n, compared);
      return both.empty()
                 ? std::string("–")
                 : whole(sum(both)) + (both.size() == compared.size() ? "" : " of " + std::to_string(both.size()));
    };
    row({of_lines(name, compared, made), whole(sum(compared)), whole(sum(best, compared)), whole_or_none(spot),
         whole_or_none(by_owl), std::to_string(count(states, best, more)), std::to_string(count(states, best, fewer)),
         seconds(took), seconds(sum(peer.column("dpa_s"), common(compared, spot))),
         std::to_string(made.size() - states.size())});
  }
}

void limit_deterministic() {
  heading("LTL to limit-deterministic Büchi",
          {"set (lines)", "states", "Owl", "edges", "Owl", "more", "fewer", "s", "no answer"});
  for (const std::string& name : infinite_sets) {
    const Rows owl = facts(name, false, ".owl.tsv");
    const Numbers theirs = owl.column("owl_ldba_states");
    if (theirs.empty()) continue;
    const auto [made, took] = ours(set_path(name, false), "ldba");
    const Numbers states = made.column("states"), compared = common(states, theirs);
    row({of_lines(name, compared, made), whole(sum(compared)), whole(sum(theirs, compared)),
         whole(sum(made.column("edges"), compared)), whole(sum(owl.column("owl_ldba_edges"), compared)),
         std::to_string(count(states, theirs, more)), std::to_string(count(states, theirs, fewer)), seconds(took),
         std::to_string(made.size() - states.size())});
  }
}

void finite() {
  heading(
      "LTLf to minimal DFA; the ratio is the geometric mean of our seconds over Lydia's on the lines that "
      "both answer",
      {"set", "lines", "answered", "as many states as the reference", "Lydia answers", "ratio", "slower", "s"});
  double logarithms = 0, compared = 0;
  for (const std::string& name : finite_sets) {
    const auto [made, took] = ours(set_path(name, true), "dfa");
    const Rows peer = facts(name, true);
    const Numbers states = made.column("states"), reference = peer.column("min_complete_dfa_states"),
                  time = common(made.column("seconds"), states), lydia = peer.column("lydia_ms");
    double here = 0, lines = 0;
    for (const auto& [line, s] : time)
      if (const auto other = lydia.find(line); other != lydia.end() && other->second > 0) {
        here += std::log(std::max(s, 1e-6) / (other->second / 1000));
        ++lines;
      }
    logarithms += here;
    compared += lines;
    char ratio[32];
    std::snprintf(ratio, sizeof ratio, "%.3f", std::exp(here / lines));
    const auto slower = [](double s, double ms) { return ms > 0 && s > ms / 1000; };
    row({name, std::to_string(made.size()), std::to_string(states.size()),
         std::to_string(count(states, reference, [](double a, double b) { return a == b; })) + " of " +
             std::to_string(common(reference, states).size()),
         whole(lines), lines > 0 ? ratio : "–", std::to_string(count(time, lydia, slower)), seconds(took)});
  }
  std::printf("\nGeometric mean over %.0f lines: %.3f\n", compared, std::exp(logarithms / compared));
}

}  // namespace
}  // namespace waymark::testing

int main(int argc, char** argv) {
  using namespace waymark::testing;
  if (!std::filesystem::is_directory(benchmark_sets())) {
    std::cerr << benchmark_sets().string() << " is not there: no tables\n";
    return 0;
  }
  const std::vector<std::string> asked(argv + 1, argv + argc);
  const auto wanted = [&](const char* target) {
    return asked.empty() || std::find(asked.begin(), asked.end(), target) != asked.end();
  };
  if (wanted("tgba")) nondeterministic("tgba", "tgba");
  if (wanted("buchi")) nondeterministic("buchi", "ba");
  if (wanted("parity")) parity();
  if (wanted("ldba")) limit_deterministic();
  if (wanted("dfa")) finite();
  return 0;
}
