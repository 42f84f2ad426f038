// Words of direction, as people use them of a picture: compass, up and left, the hands of a clock.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace waymark::streets {

enum class DirectionKind : unsigned char { Compass, Side, Vertical, Clock };

struct Direction {                              // a word of direction
  DirectionKind kind = DirectionKind::Compass;  // how the word is meant
  double angle = 0;                             // degrees counterclockwise from the right of the picture
};

// The last direction said in tokens[begin, end): "north east", "2 o'clock", "up and to the left".
std::optional<Direction> last_direction(const std::vector<std::string>& tokens, std::size_t begin, std::size_t end);

// Least angle between two directions, in degrees, [0, 180].
double angle_between(double a, double b);

}  // namespace waymark::streets
