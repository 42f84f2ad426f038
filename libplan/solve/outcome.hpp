// The outcome of a solver. "No route satisfies φ" and "the limit was reached" are different facts; both are values.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/product/compose.hpp"

namespace waymark::plan {

struct Policy {  // on the product: what to do in each vertex
  std::vector<std::optional<Action>>
      action;          // by index of the vertex; nullopt: stop (accepting), nothing leads on, or not known
  ProductState start;  // the start vertex that the value belongs to
};

struct Solved {                 // a policy and its value
  Policy policy;                // what to do in each state of the product
  double value = 0;             // least cost from policy.start to acceptance
  double lower = 0, upper = 0;  // proved bounds on it; equal for a search
  std::size_t expanded = 0;     // vertices expanded: the count that benchmarks report
};
struct Infeasible {    // proved: no run of the product is accepting
  std::string reason;  // in words
};
using ltl::Exhausted;                                         // nothing proved; its states are pairs that were met
using Outcome = std::variant<Solved, Infeasible, Exhausted>;  // of a solver

}  // namespace waymark::plan
