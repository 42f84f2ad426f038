// A log-linear reranker among the routes of a text: p(route | text) ∝ exp(w · f(text, route)).
#pragma once
#include <span>
#include <string>
#include <vector>

#include "libparser/domain/streets/street_features.hpp"

namespace waymark::streets {

struct StreetModel {
  CommonWords common;
  std::vector<float> weights = std::vector<float>(std::size_t{1} << feature_bits, 0.0F);
  CandidateLimits limits;
  // Learned from readings that knew the naming habits of each city: readers are to observe the texts before they read.
  bool observes = false;
  std::vector<double> second_look;  // weights of a second look (second_look.hpp); empty: there is none

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

  // Learns the naming habits of the city from words and starts of all its texts; what is read later is read with them.
  void observe(std::span<const StreetInstruction* const> texts);

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
  NamingHabits habits_;
};

// All candidates of each text, all about this map; observed first if the model asks for it.
std::vector<std::vector<StreetReading>> read_texts(const StreetModel& model, const StreetMap& map,
                                                   std::span<const StreetInstruction* const> texts);

}  // namespace waymark::streets
