// Reading a text over streets: the ranker (rerank/ranker.hpp) among its candidate routes.
#pragma once
#include <string>
#include <vector>

#include "libparser/domain/streets/street_features.hpp"

namespace waymark::streets {

struct StreetModel {
  CommonWords common;
  parser::WeightTable weights{1};
  CandidateLimits limits;
};

struct StreetReading {
  CandidateRoute route;
  double probability = 0;  // among the candidates
};

// Reads texts on one map. Map and common words must outlive it; not for two threads at once, for it remembers.
class StreetReader {
 public:
  StreetReader(const StreetMap& map, const CommonWords& common, const CandidateLimits& limits);

  struct Candidates {
    std::vector<Mention> mentions;
    std::vector<CandidateRoute> routes;  // best first by the rough count
    parser::CandidateFeatures features;
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

// The candidates of one text by probability, best first.
std::vector<StreetReading> readings_of(const StreetModel& model, StreetReader::Candidates candidates);

}  // namespace waymark::streets
