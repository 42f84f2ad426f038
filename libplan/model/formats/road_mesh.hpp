// Junctions and streets of a made-up country: a planar mesh that is fine in towns and coarse between them.
//
// A square is divided into quarters again and again, deeper near towns, until there are as many squares as junctions
// are asked for. A junction lies somewhere in each square; a street joins squares that share a side. Of these streets a
// random spanning tree is kept, a part of the others, and those that a straight line between two towns crosses, which
// become main roads and motorways. So the streets are planar, all junctions are connected both ways, and most have
// three streets, as in street networks [Boe17].
#pragma once
#include <cstdint>
#include <vector>

#include "libltl/structure/random.hpp"

namespace waymark::plan {

struct RoadMesh {
  enum class Kind : std::uint8_t { Motorway, Main, Country, Town };  // of a street
  struct Junction {                                                  // where streets meet
    double x = 0, y = 0;                                             // metres, eastwards and northwards
  };
  struct Street {                // between two junctions
    std::uint32_t a = 0, b = 0;  // junctions, a < b
    Kind kind = Kind::Country;   // decides the speed
    bool one_way = false;        // from a to b
  };
  double side = 0;                  // of the country, metres
  std::vector<Junction> junctions;  // in the order of a space-filling curve
  std::vector<Street> streets;      // by a, then b
};

// About as many junctions as asked for, up to a tenth more or less; at least 16. O(junctions log junctions).
RoadMesh draw_mesh(std::uint32_t junctions, ltl::Random& random);

}  // namespace waymark::plan
