// Hallways as a domain: candidates are the ends of plans of programs, which a reader found before the ranker is
// learned.
//
// Each of two questions about a sentence has a ranker of its own: at which pose its route ends, and at which pose its
// route starts (reranker.hpp).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "libparser/domain/domain.hpp"
#include "libparser/rerank/route_features.hpp"
#include "libparser/supervision/examples.hpp"

namespace waymark::parser {

struct HallwayRoute {
  plan::PoseId start;
  Plan plan;
};

// A sentence with two candidates or more, some right and some not.
struct RankingInstance {
  enum class Question : std::uint8_t { End, Start };
  struct Candidate {
    HallwayRoute route;
    double mass;  // weight of the programs that lead there
  };
  const Example* example;
  Question asks;
  std::vector<Candidate> candidates;
};

class Hallways {
 public:
  using Map = plan::Map;
  struct Text {
    const RankingInstance* instance;
    bool mirrored;  // left and right are exchanged in words and routes
  };
  using Candidates = std::vector<RankingInstance::Candidate>;
  using Route = HallwayRoute;

  // `model` numbers the words and the features. There is one executor for each map. Both must outlive this object.
  Hallways(const RankingModel& model, std::span<const Executor> executors) : model_(&model), executors_(executors) {}

  static const ltl::Vocabulary& vocabulary(const Map& map) { return map.vocabulary(); }
  static std::size_t map_of(const Text& text) { return text.instance->example->map; }
  static const Candidates& candidates(const Text& text) { return text.instance->candidates; }
  CandidateFeatures features(const Text& text, const Candidates& candidates) const;
  static const Route& execute(const Candidates::value_type& candidate) { return candidate.route; }
  static bool right(const Text& text, const Route& route) { return right(*text.instance, route); }
  static bool right(const RankingInstance& instance, const Route& route);

 private:
  const RankingModel* model_;
  std::span<const Executor> executors_;
};
static_assert(Domain<Hallways>);

}  // namespace waymark::parser
