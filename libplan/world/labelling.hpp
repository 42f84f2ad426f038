// The labelling function of hallway maps: every observable that instructions speak of, one line each.
//
//   here         chair · blue (a floor that meets this place) · intersection corner tee corridor dead_end · place_3
//   seen         ahead_X left_X right_X behind_X   X: object (anywhere along the straight hallway), floor or
//                painting (of the next segment), `wall` (no hallway there), `open` (a hallway)
//   one step on  next_X   X: object or kind of place at the node one step ahead
//   events       moved turned_left turned_right, added by the action
// corridor: two ways in line; corner: two not in line; tee: three; intersection: three or more; dead_end: one.
#pragma once
#include "libplan/world/map.hpp"

namespace waymark::plan {

// The vocabulary of a hallway map with these objects, floors and paintings and places 1 … places. The three SAIL
// maps share one, so that formulas and models carry over.
ltl::Vocabulary hallway_vocabulary(const std::vector<std::string>& objects, const std::vector<std::string>& floors,
                                   const std::vector<std::string>& walls, int places);

// L(pose) over hallway_vocabulary, without events.
ltl::Letter hallway_label(const Map& map, const ltl::Vocabulary& vocabulary, PoseId pose);

}  // namespace waymark::plan
