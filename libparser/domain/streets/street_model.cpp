#include "libparser/domain/streets/street_model.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::streets {

float StreetModel::score(const RouteFeatures& features) const {
  float sum = 0;
  for (const WeighedFeature& f : features) sum += weights[f.index] * f.value;
  return sum;
}

StreetReader::StreetReader(const StreetMap& map, const CommonWords& common, const CandidateLimits& limits)
    : map_(map), unit_(map.mean_way()), limits_(limits), finder_(map, common), routes_(map, limits.ranks) {}

StreetReader::Candidates StreetReader::candidates(const std::vector<std::string>& tokens,
                                                  LandmarkIndex start) {
  Candidates out;
  out.mentions = finder_.find(tokens);
  out.routes = candidate_routes(map_, routes_, start, out.mentions, limits_);
  const std::vector<MentionCue> cues = mention_cues(tokens, out.mentions);
  for (const CandidateRoute& route : out.routes)
    out.features.push_back(street_features(map_, unit_, tokens, out.mentions, cues, route, habits_));
  return out;
}

void StreetReader::observe(std::span<const StreetInstruction* const> texts) {
  std::vector<UnreadText> unread;
  for (const StreetInstruction* text : texts) {
    UnreadText& one = unread.emplace_back(UnreadText{text->start, {}});
    for (const Mention& mention : finder_.find(text->tokens))
      one.named.push_back(mention.fits.front().landmark);
  }
  habits_ = naming_habits(map_, routes_, unread);
}

void settle(std::vector<StreetReading>& readings) {
  std::stable_sort(readings.begin(), readings.end(), [](const StreetReading& a, const StreetReading& b) {
    return a.probability > b.probability;
  });
  double sum = 0;
  const double best = readings.empty() ? 0 : readings.front().probability;
  for (StreetReading& reading : readings) sum += reading.probability = std::exp(reading.probability - best);
  for (StreetReading& reading : readings) reading.probability /= sum;
}

std::vector<StreetReading> StreetReader::read(const StreetModel& model,
                                              const std::vector<std::string>& tokens, LandmarkIndex start) {
  Candidates found = candidates(tokens, start);
  std::vector<StreetReading> readings;
  for (std::size_t i = 0; i < found.routes.size(); ++i)
    readings.push_back({std::move(found.routes[i]), static_cast<double>(model.score(found.features[i]))});
  settle(readings);
  return readings;
}

std::vector<std::vector<StreetReading>> read_texts(const StreetModel& model, const StreetMap& map,
                                                   std::span<const StreetInstruction* const> texts) {
  StreetReader reader(map, model.common, model.limits);
  if (model.observes) reader.observe(texts);
  std::vector<std::vector<StreetReading>> out;
  for (const StreetInstruction* text : texts) out.push_back(reader.read(model, text->tokens, text->start));
  return out;
}

}  // namespace waymark::streets
