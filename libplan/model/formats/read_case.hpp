// Planning cases: a labelled map with tasks, in the JSON formats ltlgrid/1 and ltlmap/1
// (docs/formats/planning-cases.md).
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan {

struct CaseTask {                    // a question about a model
  enum class Query : std::uint8_t {  // what is asked
    MaxProbability,                  // pmax
    MinProbability,                  // pmin
    MinCost,                         // rmin: least expected cost until the prefix is good
    MaxCost,                         // rmax: greatest expected cost until the prefix is good
    MinSteps,                        // steps: least cost of a finite trace that satisfies the formula
    MinCycle,                        // cycle: least cost of a closed walk
    LeastLasso,  // lasso: a walk without end that satisfies the formula, of least cost in some order
    Discounted   // discounted: greatest expected γ^(T−1), T the actions until the prefix is good
  };
  enum class Logic : std::uint8_t { Ltl, Ltlf, Pctl, Derived };  // how the formula is read
  std::string id, formula;                                       // as the file has them
  Logic logic = Logic::Ltl;                                      // of the formula
  Query query = Query::MaxProbability;                           // of the task
  std::string fault = {};  // why it has no answer, though others have: an unknown logic or query; else empty
};
std::string_view name(CaseTask::Query query);  // "pmax", "pmin", "rmin", "steps", "cycle", …

struct PlanningCase {                  // what a file holds
  std::string name;                    // of the case
  std::variant<Mdp, GridWorld> model;  // explicit, or a grid
  std::vector<CaseTask> tasks;         // in the order of the file
};

// Throws ltl::FormatError with line and column, naming the value: "rows[3]: expected 50 characters".
PlanningCase parse_case(std::string_view json, std::string_view source = "");
PlanningCase read_case(const std::filesystem::path& file);

}  // namespace waymark::plan
