// One task on a road graph: formula or automaton → legs in the hierarchy → a certified route of least cost, or none.
#pragma once
#include "libplan/model/road_graph.hpp"
#include "libplan/roads/road_hierarchy.hpp"
#include "libplan/roads/road_search.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/solve/task_automaton.hpp"

namespace waymark::plan {

// Can the task be answered on roads, without a product? Queries rmin and steps, by search, for one route and without a
// strategy; anything else asks for an Mdp (model_of).
bool is_road_task(const CaseTask& task, const CaseOptions& options);

// As `answer` of case_task.hpp, for such tasks. The word of the route is checked by the definition on the map, and so
// is every step; reasons of infeasible tasks name conjuncts. Throws as there.
CaseAnswer answer(const RoadGraph& graph, const RoadHierarchy& hierarchy, const CaseTask& task,
                  const CaseOptions& options = {}, const GivenAutomaton* given = nullptr);

}  // namespace waymark::plan
