// The routes among which a text is read, and where each of its mentions falls on them.
//
// Supply: the shortest simple routes from the start to every landmark (street_routes.hpp), and for longer texts the
// route through all landmarks that are named, in their order. A rough count (named landmarks on the route, others on
// it, order, rank) keeps the likeliest, which the log-linear reranker then weighs.
#pragma once
#include <vector>

#include "libparser/domain/streets/mentions.hpp"
#include "libparser/domain/streets/street_routes.hpp"

namespace waymark::streets {

constexpr std::uint32_t off_route = ~std::uint32_t{0};  // of a mention that is no landmark of the route

struct CandidateRoute {
  StreetRoute landmarks;   // from start to goal
  std::uint32_t rank = 0;  // 0: the shortest way to its goal
  double length = 0;       // of the route
  double shortest = 0;     // length of the shortest way to its goal
  // What the map says one would mistake it for: the next longer route to the same goal; empty when there is none.
  StreetRoute rival;
};

struct PlacedMention {                 // where a mention falls
  LandmarkIndex landmark = 0;          // as this candidate has it read
  std::uint32_t position = off_route;  // on the route
  float letters = 0, complete = 0;     // of the name that was fitted
};

// Each mention as the landmark that fits best, the route's own landmarks preferred.
std::vector<PlacedMention> place(const std::vector<Mention>& mentions, const StreetRoute& route);

struct CandidateLimits {        // how many routes are candidates
  std::size_t ranks = 40;       // routes to each goal
  std::size_t candidates = 80;  // kept for a text
};

// Best first by the rough count.
std::vector<CandidateRoute> candidate_routes(const StreetMap& map, RouteTable& routes, LandmarkIndex start,
                                             const std::vector<Mention>& mentions, const CandidateLimits& limits = {});

}  // namespace waymark::streets
