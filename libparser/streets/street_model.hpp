// A log-linear chooser among the routes of a text: p(route | text) ∝ exp(w · f(text, route)).
#pragma once
#include <string>
#include <vector>

#include "libparser/streets/street_features.hpp"

namespace waymark::streets {

struct StreetModel {
  CommonWords common;
  std::vector<float> weights = std::vector<float>(std::size_t{1} << feature_bits, 0.0F);
  CandidateLimits limits;

  float score(const RouteFeatures& features) const;
};

struct StreetReading {
  CandidateRoute route;
  double probability = 0;  // among the candidates
};

// Where `probability` holds its logarithm up to a constant: probabilities that sum to 1, best first, ties as they stood.
void settle(std::vector<StreetReading>& readings);

// Reads texts on one map. Map and common words must outlive it; not for two threads at once, for it remembers.
class StreetReader {
 public:
  StreetReader(const StreetMap& map, const CommonWords& common, const CandidateLimits& limits);

  struct Candidates {
    std::vector<Mention> mentions;
    std::vector<CandidateRoute> routes;  // best first by the rough count
    std::vector<RouteFeatures> features;
  };
  Candidates candidates(const std::vector<std::string>& tokens, LandmarkIndex start);

  // Best first; empty where no way leaves the start.
  std::vector<StreetReading> read(const StreetModel& model, const std::vector<std::string>& tokens,
                                  LandmarkIndex start);

 private:
  const StreetMap& map_;
  double unit_;
  CandidateLimits limits_;
  MentionFinder finder_;
  RouteTable routes_;
};

}  // namespace waymark::streets
