// Schedulers of PRISM and Storm in the place of our strategies, on models whose states have numbers.
#pragma once
#include <string>

#include "libplan/solve/case_task.hpp"

namespace waymark::tools {

// Before the work: throws UsageError where no strategy of the model can be written in the format: that of a grid in
// PRISM's or Storm's.
void require_scheduler_of(const plan::PlanningCase& planning_case, const std::string& format);

// The strategy as a scheduler on the states of the model, which needs no memory where every state has one decision.
// Throws UsageError for a strategy that needs memory, and as above.
std::string scheduler_text(const plan::PlanningCase& planning_case, const plan::CaseAnswer& answer,
                           const std::string& format);

// The Markov chain that the scheduler in the file makes of the model; without a file, the model. Throws
// ltl::FormatError, and UsageError for a grid.
plan::PlanningCase scheduled(plan::PlanningCase planning_case, const std::string& file);

}  // namespace waymark::tools
