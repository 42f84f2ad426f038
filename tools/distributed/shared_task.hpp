// One task of a grid case, solved by all ranks: formula → automaton → product of every band → value between proved
// bounds.
#pragma once
#include "libplan/solve/case_task.hpp"
#include "tools/distributed/band_values.hpp"

namespace waymark::tools {

// Collective; every rank has the whole answer, but for its own statistics. Sizes are those of all bands together.
// Throws as plan::answer on every rank, std::invalid_argument for a query that is not shared among ranks. `kept` may be
// absent.
plan::CaseAnswer answer(const Ranks& ranks, const GridBand& band, const plan::CaseTask& task,
                        const SharedOptions& options, const KeptBands* kept, SharedStatistics& statistics);

}  // namespace waymark::tools
