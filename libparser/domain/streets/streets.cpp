#include "libparser/domain/streets/streets.hpp"

#include <algorithm>

#include "libparser/domain/streets/street_readings.hpp"

namespace waymark::streets {

ltl::Vocabulary Streets::vocabulary(const StreetMap& map) {
  std::vector<std::string> names;
  for (const Landmark& landmark : map.landmarks) names.push_back(plan::landmark_name(landmark.name));
  return ltl::Vocabulary(names);
}

Streets::City& Streets::city(std::size_t map) {
  auto& city = cities_[map];
  if (!city) city.emplace(maps_[map], common_, limits_.ranks);
  return *city;
}

StreetCandidates Streets::candidates(Text text) {
  City& in = city(text->map);
  StreetCandidates out{in.finder.find(text->tokens), {}};
  out.routes = candidate_routes(maps_[text->map], in.routes, text->start, out.mentions, limits_);
  return out;
}

parser::CandidateFeatures Streets::features(Text text, const StreetCandidates& candidates) {
  const double unit = city(text->map).unit;
  const std::vector<MentionCue> cues = mention_cues(text->tokens, candidates.mentions);
  parser::CandidateFeatures out;
  for (const CandidateRoute& route : candidates.routes) {
    out.candidates.push_back({static_cast<std::uint32_t>(out.bundles.size())});
    out.bundles.push_back(street_features(maps_[text->map], unit, text->tokens, candidates.mentions, cues, route));
  }
  return out;
}

std::optional<std::size_t> Streets::rival(const StreetCandidates& candidates, std::size_t right) {
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].landmarks == candidates[right].rival) return i;
  return std::nullopt;
}

StreetModel learn_streets(std::span<const Streets::Text> texts, const std::vector<StreetMap>& maps,
                          const StreetOptions& options) {
  StreetModel model;
  model.limits = options.limits;
  model.common = common_words(texts, maps);
  Streets streets(maps, model.common, model.limits);
  learn_ranker(streets, texts, model.weights, options.ranker, [](double) {});
  return model;
}

std::vector<StreetReading> rank_routes(Streets& streets, const parser::WeightTable& weights, Streets::Text text,
                                       const StreetCandidates& candidates) {
  std::vector<StreetReading> out;
  if (candidates.routes.empty()) return out;
  std::vector<double> probabilities = parser::scores(weights, streets.features(text, candidates));
  parser::normalise(probabilities);
  for (std::size_t i = 0; i < probabilities.size(); ++i) out.push_back({candidates[i], probabilities[i]});
  std::stable_sort(out.begin(), out.end(),
                   [](const StreetReading& a, const StreetReading& b) { return a.probability > b.probability; });
  return out;
}

}  // namespace waymark::streets
