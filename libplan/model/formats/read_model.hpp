// The reader of models of every kind: the name of a file tells the kind; for JSON, the contents do.
#pragma once
#include <filesystem>
#include <string_view>

#include "libltl/limits.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/model/prism/read_prism.hpp"

namespace waymark::plan {

// FILE.tra: PRISM's explicit files with that prefix. FILE.json: a planning case (its tasks come with it), or a street
// graph. FILE.gr: roads of DIMACS. FILE.osm, FILE.geojson, FILE.graphml: roads with landmarks. FILE.yaml: a transition
// system. FILE.jani: JANI. Anything else: the language of PRISM; both are read as `prism` says. The name is that of the
// case, else that of the file without its end.
// `start`: of street graphs and roads only. Throws ltl::FormatError and ltl::SyntaxError; of the language of PRISM and
// of JANI, ReadingStopped.
PlanningCase read_model(const std::filesystem::path& file, std::string_view start = "",
                        const ltl::Limits& limits = {.states = most_model_states}, const PrismOptions& prism = {});

}  // namespace waymark::plan
