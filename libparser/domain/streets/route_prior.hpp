// How the pictures were made, as the data show it: start and goal at random, between them the k-th shortest simple route with k
// geometric (p = 0.2), and the (k+1)-th beside it as the one not to take. So where routes are few the last of them is never
// described, and the last but one stands for all further ranks.
#pragma once
#include <cmath>
#include <cstddef>

namespace waymark::streets {

// Of the route with that rank, from 0, among `routes` that were counted; counting stopped at `most`.
inline double rank_probability(std::size_t rank, std::size_t routes, std::size_t most) {
  constexpr double stop = 0.2;
  const double reached = std::pow(1 - stop, static_cast<double>(rank));
  if (routes >= most) return stop * reached;
  if (routes == 1) return 1;
  if (rank + 1 >= routes) return 0;
  return rank + 2 == routes ? reached : stop * reached;
}

}  // namespace waymark::streets
