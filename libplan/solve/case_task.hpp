// The solution of one task on any model: formula or automaton → product → value between proved bounds, or a reason.
#pragma once
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "libplan/model/formats/read_case.hpp"
#include "libplan/solve/decide.hpp"
#include "libplan/solve/least_lasso.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "libplan/solve/written_strategy.hpp"

namespace waymark::plan {

enum class CaseMethod : std::uint8_t {  // how a task is solved
  Best,  // search where the model is deterministic and a cost is asked for, else value iteration
  Search,
  ValueIteration,
  PolicyIteration
};
std::string_view name(CaseMethod method);  // "search", "vi", "pi"

struct CaseOptions {                      // how a task is solved
  CaseMethod method = CaseMethod::Best;   // of solving
  double tolerance = 1e-6;                // of the bounds
  std::size_t states = 4'000'000'000;     // of the product; of the automaton a thousandth
  bool explain = true;                    // find the reason of what is infeasible
  double discount = 0.9;                  // of query discounted
  LassoOrder order = LassoOrder::Prefix;  // of query lasso
  std::size_t top = 1;                    // routes of a search
  bool route = false;                     // of a search: tell the cheapest, also when it is the only one asked for
  bool strategy = false;                  // write it down
  Sweepers sweepers = {};                 // of value iteration; of no influence on any number
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();  // as in IterationOptions
  std::stop_token stop = {};                                             // ends with Exhausted when it is asked for
};

// Bounds that meet may cross by the rounding of doubles. Of an answer they are in order.
inline Bounds uncrossed(const Bounds& b) { return b.lower <= b.upper ? b : Bounds{b.upper, b.lower}; }

struct CaseAnswer {                                                    // what solving comes to
  enum class Status : std::uint8_t { Solved, Infeasible, Exhausted };  // of a task
  Status status = Status::Exhausted;                                   // of this task
  Bounds value;                                                        // between proved bounds
  CaseMethod method = CaseMethod::Search;                              // that was used
  // Sizes, as `waymark plan --case` prints them.
  std::size_t automaton_states = 0, product_states = 0, product_edges = 0;
  struct Seconds {                                 // by stage
    double automaton = 0, product = 0, solve = 0;  // stages
  };
  Seconds seconds;                   // wall clock
  std::string reason;                // of Infeasible and Exhausted
  std::vector<std::string> dropped;  // infeasible conjunctions: the fewest conjuncts without which the rest can be met
  std::vector<NamedRoute> routes;    // of a search when they were asked for, cheapest first
  std::size_t asked = 1;             // so many routes
  struct Lasso {                     // of a deterministic model
    NamedRoute prefix, cycle;        // the cycle begins and ends where the prefix ends
    std::uint64_t rounds = 1;        // that a walk of the cycle completes
    LassoOrder order = LassoOrder::Prefix;  // in which it comes first
  };
  std::optional<Lasso> lasso;         // certified
  struct Written {                    // a strategy for files
    TaskAutomaton automaton;          // whose states decisions name
    std::vector<Decision> decisions;  // by pair
    Bounds re_evaluated;  // as a Markov chain; for pmin of an infinite task of the negation's probability, taken from 1
  };
  std::optional<Written> strategy;  // when it was asked for
};

// The value of a lasso is what its order puts first. Throws ltl::SyntaxError for a formula that cannot be read,
// std::invalid_argument for a query that its logic does not have (a cycle of anything but patrol:a,b,…), a method
// that does not answer it, or an option that goes with other queries.
CaseAnswer answer(const PlanningCase& planning_case, const CaseTask& task, const CaseOptions& options = {});
// The same of an automaton in the place of the formula; the logic is that of its words.
CaseAnswer answer(const PlanningCase& planning_case, const CaseTask& task, const GivenAutomaton& given,
                  const CaseOptions& options = {});

}  // namespace waymark::plan
