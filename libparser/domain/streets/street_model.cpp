#include "libparser/domain/streets/street_model.hpp"

#include <algorithm>

namespace waymark::streets {

StreetReader::StreetReader(const StreetMap& map, const CommonWords& common, const CandidateLimits& limits)
    : map_(map), unit_(map.mean_way()), limits_(limits), finder_(map, common), routes_(map, limits.ranks) {}

StreetReader::Candidates StreetReader::candidates(const std::vector<std::string>& tokens,
                                                  LandmarkIndex start) {
  Candidates out;
  out.mentions = finder_.find(tokens);
  out.routes = candidate_routes(map_, routes_, start, out.mentions, limits_);
  const std::vector<MentionCue> cues = mention_cues(tokens, out.mentions);
  for (const CandidateRoute& route : out.routes) {
    out.features.candidates.push_back({static_cast<std::uint32_t>(out.features.bundles.size())});
    out.features.bundles.push_back(street_features(map_, unit_, tokens, out.mentions, cues, route));
  }
  return out;
}

std::vector<StreetReading> StreetReader::read(const StreetModel& model,
                                              const std::vector<std::string>& tokens, LandmarkIndex start) {
  return readings_of(model, candidates(tokens, start));
}

std::vector<StreetReading> readings_of(const StreetModel& model, StreetReader::Candidates candidates) {
  std::vector<StreetReading> readings;
  if (candidates.routes.empty()) return readings;
  std::vector<double> probabilities = parser::scores(model.weights, candidates.features);
  parser::normalise(probabilities);
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    readings.push_back({std::move(candidates.routes[i]), probabilities[i]});
  std::stable_sort(readings.begin(), readings.end(), [](const StreetReading& a, const StreetReading& b) {
    return a.probability > b.probability;
  });
  return readings;
}

}  // namespace waymark::streets
