// A made-up country to plan in: roads with shape points, speeds, areas to avoid and landmarks, in the files of DIMACS.
//
// Junctions and streets are those of road_mesh.hpp. Points between junctions give streets their shape, as in extracts
// of maps of the world, where four nodes of five have two neighbours. Costs are tenths of seconds. Areas x and y are
// unions of discs; landmarks a, b, … and the start are junctions outside of x that two-way streets past no x connect.
#pragma once
#include <cstdint>
#include <iosfwd>

namespace waymark::plan {

struct RoadRecipe {                                    // what is drawn
  static constexpr std::uint32_t most_landmarks = 20;  // a … t
  std::uint32_t nodes = 10'000;                        // junctions and shape points, at least 100
  std::uint32_t landmarks = 6;                         // named a, b, …
  double avoided = 0.03;                               // part of the country that is x, and that is y
  std::uint64_t seed = 1;                              // of all that is drawn
};

// Exactly so many nodes, the same bytes on every machine: arcs, positions (metres) and labels. O(nodes log nodes).
// Throws std::invalid_argument: too few nodes or too many, too many landmarks, a part outside [0, 0.3].
void generate_roads(const RoadRecipe& recipe, std::ostream& gr, std::ostream& co, std::ostream& lab);

}  // namespace waymark::plan
