// Streets as a domain: a text's candidates are simple routes over landmarks, which are their own execution.
#pragma once
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "libparser/domain/domain.hpp"
#include "libparser/domain/streets/street_features.hpp"
#include "libparser/training/learn_ranker.hpp"

namespace waymark::streets {

struct StreetCandidates {              // what a text may mean
  std::vector<Mention> mentions;       // that were found in it
  std::vector<CandidateRoute> routes;  // best first by the rough count

  std::size_t size() const { return routes.size(); }
  const CandidateRoute& operator[](std::size_t i) const { return routes[i]; }
};

// Not for two threads at once, for it remembers what it has computed of each city.
class Streets {
 public:
  // What the concept of a domain (libparser/domain/domain.hpp) asks.
  using Map = StreetMap;
  using Text = const StreetInstruction*;
  using Candidates = StreetCandidates;
  using Route = StreetRoute;

  // All of it must outlive it.
  Streets(const std::vector<StreetMap>& maps, const CommonWords& common, const CandidateLimits& limits)
      : maps_(maps), common_(common), limits_(limits), cities_(maps.size()) {}

  static ltl::Vocabulary vocabulary(const StreetMap& map);  // names in snake_case
  // What the concept of a domain asks of functions.
  static std::size_t map_of(Text text) { return text->map; }
  StreetCandidates candidates(Text text);
  parser::CandidateFeatures features(Text text, const StreetCandidates& candidates);
  static const StreetRoute& execute(const CandidateRoute& route) { return route.landmarks; }
  static bool right(Text text, const StreetRoute& route) { return route == text->path; }
  // The picture showed the next longer route to the same goal as the one not to describe (`alt_path` of the corpus,
  // which is that route in every line).
  static std::optional<std::size_t> rival(const StreetCandidates& candidates, std::size_t right);

 private:
  struct City {
    City(const StreetMap& map, const CommonWords& common, std::size_t ranks)
        : unit(map.mean_way()), finder(map, common), routes(map, ranks) {}
    double unit;
    MentionFinder finder;
    RouteTable routes;
  };
  City& city(std::size_t map);

  const std::vector<StreetMap>& maps_;
  const CommonWords& common_;
  const CandidateLimits& limits_;
  std::vector<std::optional<City>> cities_;
};
static_assert(parser::DomainWithRivals<Streets>);

struct StreetModel {               // what is learned
  CommonWords common;              // of all cities
  parser::WeightTable weights{1};  // of the ranker
  CandidateLimits limits;          // of reading
};

struct StreetOptions {  // how it is learned
  // Of the ranker; features of fewer maps are left out.
  parser::RankerOptions ranker{.epochs = 8,
                               .rate = 0.05,
                               .decay = 4e-2,
                               .first_squares = std::numeric_limits<float>::min(),
                               .least_error = 1e-5,
                               .against_rival = 0.5,
                               .decay_again = true,
                               .least_maps = 3};
  CandidateLimits limits;  // of reading
};

// Throws Stopped (supervision/examples.hpp) when a stop was requested.
StreetModel learn_streets(std::span<const Streets::Text> texts, const std::vector<StreetMap>& maps,
                          const StreetOptions& options);

struct StreetReading {     // one reading
  CandidateRoute route;    // that the text may describe
  double probability = 0;  // among the candidates
};

// The candidates by probability, best first; empty where no way leaves the start.
std::vector<StreetReading> rank_routes(Streets& streets, const parser::WeightTable& weights, Streets::Text text,
                                       const StreetCandidates& candidates);

}  // namespace waymark::streets
