#include "libplan/model/formats/read_streets.hpp"

#include <string>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libplan/world/street_map.hpp"

namespace waymark::plan {

Mdp parse_streets(std::string_view json, std::string_view source, std::string_view start) {
  const StreetMap map = parse_street_map(json, StreetView::Ground, source);
  std::vector<std::string> names;
  for (const Landmark& landmark : map.landmarks) names.push_back(landmark_name(landmark.name));
  MdpBuilder builder{ltl::Vocabulary(names)};
  const auto letter = [&](LandmarkIndex s) { return builder.letter({ltl::Proposition{s}}); };
  for (LandmarkIndex s = 0; s < names.size(); ++s) {
    builder.add_state(names[s]);
    for (const Way& way : map.ways[s]) {
      builder.add_choice(names[way.to], way.length);
      builder.add_outcome(way.to, letter(way.to));
    }
  }
  LandmarkIndex first = 0;
  while (!start.empty() && first < names.size() && std::to_string(map.landmarks[first].id) != start &&
         names[first] != start)
    ++first;
  if (first == names.size()) throw ltl::FormatError(source, 0, 0, "there is no landmark '" + std::string(start) + "'");
  const LetterId first_letter = letter(first);
  return std::move(builder).build(first, first_letter);
}

}  // namespace waymark::plan
