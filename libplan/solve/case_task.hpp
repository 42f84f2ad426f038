// One task of a planning case: formula → automaton → product → value between proved bounds, or why there is none.
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "libplan/model/read_case.hpp"
#include "libplan/solve/decide.hpp"

namespace waymark::plan {

enum class CaseMethod : std::uint8_t {
  Best,  // search where the model is deterministic and a cost is asked for, else value iteration
  Search,
  ValueIteration,
  PolicyIteration
};
std::string_view name(CaseMethod method);  // "search", "vi", "pi"

struct CaseOptions {
  CaseMethod method = CaseMethod::Best;
  double tolerance = 1e-6;
  std::size_t states = 1'000'000'000;  // of the product; of the automaton a thousandth
  bool explain = true;                 // find the reason of what is infeasible
  std::stop_token stop = {};
};

struct CaseAnswer {
  enum class Status : std::uint8_t { Solved, Infeasible, Exhausted };
  Status status = Status::Exhausted;
  Bounds value;
  CaseMethod method = CaseMethod::Search;
  std::size_t automaton_states = 0, product_states = 0, product_edges = 0;
  struct Seconds {
    double automaton = 0, product = 0, solve = 0;
  } seconds;
  std::string reason;  // of Infeasible and Exhausted
  std::vector<std::string>
      dropped;  // infeasible conjunctions: the fewest conjuncts without which the rest can be met
};

// Throws ltl::SyntaxError for a formula that cannot be read, std::invalid_argument for a query that its logic does not
// have (a cycle of anything but patrol:a,b,…) or a method that does not answer it.
CaseAnswer answer(const PlanningCase& planning_case, const CaseTask& task, const CaseOptions& options = {});

}  // namespace waymark::plan
