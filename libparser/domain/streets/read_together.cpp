#include "libparser/domain/streets/read_together.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace waymark::streets {

std::vector<StreetReading> read_together(std::span<const std::vector<StreetReading>> texts, double heedless) {
  assert(heedless > 0 && heedless <= 1);
  std::vector<StreetReading> together;
  std::map<StreetRoute, std::size_t> known;  // where in `together`
  for (const auto& readings : texts)
    for (const StreetReading& reading : readings)
      if (known.try_emplace(reading.route.landmarks, together.size()).second)
        together.push_back({reading.route, 0});
  const double idle = heedless / static_cast<double>(std::max<std::size_t>(together.size(), 1));
  for (const auto& readings : texts) {
    std::vector<double> said(together.size(), 0.0);
    for (const StreetReading& reading : readings)
      said[known.at(reading.route.landmarks)] = reading.probability;
    for (std::size_t i = 0; i < together.size(); ++i)
      together[i].probability += std::log((1 - heedless) * said[i] + idle);
  }
  settle(together);
  return together;
}

}  // namespace waymark::streets
