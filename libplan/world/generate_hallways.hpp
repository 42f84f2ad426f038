// Random hallway maps in our map format (docs/formats/maps-and-routes.md): a spanning tree of a grid of places, drawn
// depth first, and every third of the remaining segments, so that some places have several routes. The observables are
// those of the maps that come with waymark.
#pragma once
#include <cstdint>
#include <string>

namespace waymark::plan {

struct HallwayRecipe {                  // what is drawn
  std::uint32_t width = 8, height = 6;  // places
  std::uint32_t objects = 6;            // pieces of furniture, each in a place of its own
  std::uint64_t seed = 1;               // of all that is drawn
};

// The JSON text. Throws std::invalid_argument: fewer than two or more than 10,000 places, more objects than places.
std::string generate_hallways(const HallwayRecipe& recipe);

}  // namespace waymark::plan
