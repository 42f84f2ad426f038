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

struct HallwayRoute {  // a start with a plan from there
  plan::PoseId start;  // where it begins
  Plan plan;           // from the start
};

// A sentence with two candidates or more, some right and some not.
struct RankingInstance {
  enum class Question : std::uint8_t { End, Start };  // what the candidates answer
  struct Candidate {                                  // an answer
    HallwayRoute route;                               // that leads to the answer
    double mass;                                      // weight of the programs that lead there
  };
  const Example* example;             // the sentence
  Question asks;                      // which question
  std::vector<Candidate> candidates;  // the answers
};

class Hallways {
 public:
  // What the concept of a domain (domain/domain.hpp) asks.
  using Map = plan::Map;
  struct Text {                       // a sentence, or its mirror image
    const RankingInstance* instance;  // that is decided
    bool mirrored;                    // left and right are exchanged in words and routes
  };
  // What the concept of a domain asks of candidates and routes.
  using Candidates = std::vector<RankingInstance::Candidate>;
  using Route = HallwayRoute;

  // `model` numbers the words and the features. There is one executor for each map. Both must outlive this object.
  Hallways(const RankingModel& model, std::span<const Executor> executors) : model_(&model), executors_(executors) {}

  // What the concept of a domain asks of functions.
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
