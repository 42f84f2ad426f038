// waymark plan --model FILE.gr: tasks on roads of a whole country, by a hierarchy.
#pragma once
#include <iosfwd>
#include <optional>
#include <stop_token>
#include <string>

#include "libplan/roads/contract.hpp"
#include "tools/case_options.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

bool is_road_file(const CaseChoice& choice);  // is the model FILE.gr?
// Is the query one that legs answer? Else roads are a model as any other.
bool is_on_roads(const CaseChoice& choice);

// Throws Interrupted; UsageError for roads whose costs are too large.
plan::RoadHierarchy hierarchy_of(const plan::RoadGraph& graph, const plan::ContractionOptions& options);

ExitCode plan_roads(const CaseChoice& choice, const std::string& start, const TextOptions& formulas,
                    const Session& session);

}  // namespace waymark::tools
