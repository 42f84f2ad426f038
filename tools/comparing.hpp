// The comparison of one formula, or of a suite of them, as text for people and as JSON (docs/cli.md documents every
// key).
#pragma once
#include <iosfwd>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "libltl/text/print.hpp"
#include "libplan/learn/comparison.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {

struct Searched {  // the exact search for a route, where nothing slips
  double cost = 0, seconds = 0;
  bool is_reference = false;  // the optimum costs the same: all actions do, and there is one start
};

struct MethodRuns {
  std::string name;
  plan::Summary summary;
  std::vector<plan::CurvePoint> curve;  // empty for a suite
};

struct ComparedTask {
  std::optional<ltl::Formula> formula = {};  // or
  std::string automaton = {};                // the name of its file
  std::string map = {};
  std::vector<plan::Pose> starts = {};  // on a map
  std::string task = {}, start = {};    // of a planning case: the name of the task, and of the state it begins in
  std::size_t automaton_states = 0, product_states = 0;
  plan::PolicyValue optimum = {};
  double seconds_of_optimum = 0;
  std::size_t sweeps = 0;
  std::optional<Searched> search = {};
  bool is_over = false;  // at every start
  std::vector<MethodRuns> methods = {};
};

struct Protocol {  // what all runs of a comparison share
  std::size_t seeds = 20, steps = 20'000, interval = 100, horizon = 200;
  double discount = 0.9;
};

// The training of a run, counted from 0: its seed, and how it explores.
plan::Training training_of(const plan::Method& method, const Protocol& protocol, std::size_t run,
                           const std::stop_token& stop);

JsonObject json_of(const ComparedTask& task, const Protocol& protocol);
void print(std::ostream& out, const Terminal& terminal, const ComparedTask& task, const Protocol& protocol);

// The formula, or which automaton it is.
std::string title_of(const ComparedTask& task, ltl::Style style = ltl::Style::Ascii);
std::string shown_cost(double cost);  // "7", "7.2500"

// Of a suite: the runs of all its tasks together.
JsonObject json_of_suite(const std::vector<MethodRuns>& methods, std::size_t tasks, const Protocol& protocol);
void print_suite(std::ostream& out, const std::vector<MethodRuns>& methods, std::size_t tasks,
                 const Protocol& protocol);

}  // namespace waymark::tools
