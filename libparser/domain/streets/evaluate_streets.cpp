#include "libparser/domain/streets/evaluate_streets.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace waymark::streets {
namespace {

constexpr std::size_t readings_kept = 3;

struct CityFold : parser::Fold<StreetScores, StreetPrediction> {
  std::size_t city;  // of the test corpus
};

void test(CityFold& fold, const StreetModel& model, const StreetCorpus& corpus) {
  Streets streets(corpus.maps, model.common, model.limits);
  for (const StreetInstruction& text : corpus.instructions) {
    if (text.map != fold.city) continue;
    StreetCandidates found = streets.candidates(&text);
    StreetPrediction prediction{&text, {}, rank_routes(streets, model.weights, &text, found)};
    StreetScores one{{0, 1}, {0, 1}, {0, 1}, {0, 1}};
    for (const CandidateRoute& route : found.routes) one.supply.hits |= route.landmarks == text.path ? 1U : 0U;
    if (!prediction.readings.empty()) {
      const StreetRoute& route = prediction.readings.front().route.landmarks;
      one.exact_path.hits = Streets::right(&text, route) ? 1 : 0;
      one.goal.hits = route.back() == text.path.back() ? 1 : 0;
      one.floor.hits = Streets::right(&text, Streets::execute(found[0])) ? 1 : 0;
    }
    prediction.mentions = std::move(found.mentions);
    if (prediction.readings.size() > readings_kept) prediction.readings.resize(readings_kept);
    fold.scores += one;
    fold.predictions.push_back(std::move(prediction));
  }
}

std::vector<const StreetInstruction*> training_part(const StreetCorpus& train, const std::string& left_out,
                                                    bool train_all) {
  std::vector<const StreetInstruction*> part;
  for (const StreetInstruction& instruction : train.instructions)
    if (train_all || train.maps[instruction.map].name != left_out) part.push_back(&instruction);
  if (part.empty()) throw std::invalid_argument("nothing is left to train on when " + left_out + " is left out");
  return part;
}

}  // namespace

StreetScores& StreetScores::operator+=(const StreetScores& other) {
  exact_path += other.exact_path;
  goal += other.goal;
  floor += other.floor;
  supply += other.supply;
  return *this;
}

StreetEvaluation evaluate_streets(const StreetCorpus& train, const StreetCorpus& test_corpus, bool train_all,
                                  int threads, const StreetOptions& options) {
  std::vector<CityFold> folds;
  for (std::size_t m = 0; m < test_corpus.maps.size(); ++m)
    if (std::any_of(test_corpus.instructions.begin(), test_corpus.instructions.end(),
                    [m](const StreetInstruction& instruction) { return instruction.map == m; }))
      folds.push_back({{test_corpus.maps[m].name}, m});
  std::optional<StreetModel> one;  // for all folds
  if (train_all) one = learn_streets(training_part(train, "", true), train.maps, options);
  const auto finish = [&](CityFold& fold, const parser::JobProgress&) {
    test(fold, one ? *one : learn_streets(training_part(train, fold.map, false), train.maps, options), test_corpus);
  };
  StreetEvaluation evaluation{parser::run_folds<StreetScores, StreetPrediction>(folds, threads, {}, "cities", finish)};
  for (const auto& [map, scores] : evaluation.folds) {
    evaluation.mean_exact_path += scores.exact_path.value() / static_cast<double>(folds.size());
    evaluation.mean_goal += scores.goal.value() / static_cast<double>(folds.size());
  }
  return evaluation;
}

}  // namespace waymark::streets
