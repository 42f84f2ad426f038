// The cost of the feedback of a learner: Table 2 of the paper, measured.
//
// A candidate formula is checked along the trajectory people took, or planned and its end compared. The paper argues
// that the first, O(|S| · |s|), is an order of magnitude cheaper than the second, O(|S|^|s|) for route formulas. Here
// both on random hallway maps that grow, and along random walks that grow, with routes to one to three pieces of
// furniture in order as formulas.
#pragma once
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace waymark::tools {

inline constexpr std::array feedback_engines{"progression",       "trace check",         "DFA run",
                                             "DFA, made and run", "plan of the program", "plan on the product"};

struct FeedbackCost {
  std::size_t places = 0, steps = 0;  // of the map; of the formulas
  double length = 0;                  // of the trajectories, letters, mean
  // Microseconds a formula, by engine. A sentence has `candidates` formulas, which share the trajectory's columns.
  std::array<double, feedback_engines.size()> microseconds{};
};

struct FeedbackCosts {
  std::size_t candidates = 0;
  std::vector<FeedbackCost> by_places, by_length, by_steps;
};

struct FeedbackCostOptions {
  std::uint64_t seed = 1;
  std::size_t candidates = 64, sentences = 10;  // formulas a sentence; sentences a row
  std::stop_token stop = {};
};

// Throws Interrupted (tools/shell/exit_code.hpp) when a stop was requested.
FeedbackCosts measure_feedback(const FeedbackCostOptions& options);

}  // namespace waymark::tools
