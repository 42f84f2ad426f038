// The K cheapest routes of a deterministic model to a goal of a finite task, in order.
//
// Dijkstra over walks: a pair of place and task is settled up to K times, each time by another walk, for no more than K
// walks that end in a pair can begin K cheapest routes. Walks may come by a pair again; none goes on after a goal, so
// every route satisfies its task for the first time at its end. Two routes differ where they pass different pairs: of
// several choices that lead to one pair the cheapest counts, the first such. The automaton is deterministic, so a walk
// has one run.
#pragma once
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/solve/product_search.hpp"

namespace waymark::plan {

struct RoutesAnswer {               // several routes
  std::vector<ChoiceRoute> routes;  // fewer than asked for: proved that there are no more
  SearchStatistics statistics;      // walks settled, edges looked at
};

// By cost; of routes of as many choices, all equally dear, those whose choices come first. 24 bytes a walk. nullopt:
// stopped, or more walks than the limit. Throws std::invalid_argument for a model that is not deterministic.
template <Model M>
std::optional<RoutesAnswer> least_routes(const Product<M, TaskTable>& product, std::size_t most,
                                         const ltl::Limits& limits = {.states = 1'000'000'000});

}  // namespace waymark::plan
