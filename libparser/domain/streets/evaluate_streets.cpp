#include "libparser/domain/streets/evaluate_streets.hpp"

#include <stdexcept>

#include "libparser/training/parallel.hpp"

namespace waymark::streets {
namespace {

constexpr std::size_t readings_kept = 3;

struct Fold {
  std::size_t map;  // of the test corpus
  StreetScores scores;
  std::vector<StreetPrediction> predictions;
};

void test(Fold& fold, const StreetModel& model, const StreetCorpus& corpus) {
  Streets streets(corpus.maps, model.common, model.limits);
  for (const StreetInstruction& text : corpus.instructions) {
    if (text.map != fold.map) continue;
    StreetCandidates found = streets.candidates(&text);
    StreetPrediction prediction{&text, {}, rank_routes(streets, model.weights, &text, found)};
    StreetScores one{{0, 1}, {0, 1}, {0, 1}, {0, 1}};
    for (const CandidateRoute& route : found.routes)
      one.supply.hits |= route.landmarks == text.path ? 1U : 0U;
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
  if (part.empty())
    throw std::invalid_argument("nothing is left to train on when " + left_out + " is left out");
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
  std::vector<Fold> folds;
  for (std::size_t m = 0; m < test_corpus.maps.size(); ++m)
    for (const StreetInstruction& instruction : test_corpus.instructions)
      if (instruction.map == m) {
        folds.push_back({m, {}, {}});
        break;
      }
  std::optional<StreetModel> one;  // for all folds
  if (train_all) one = learn_streets(training_part(train, "", true), train.maps, options);
  parser::run_jobs(folds.size(), threads, {}, "cities", [&](std::size_t i, const parser::JobProgress&) {
    const std::string& name = test_corpus.maps[folds[i].map].name;
    test(folds[i], one ? *one : learn_streets(training_part(train, name, false), train.maps, options),
         test_corpus);
  });
  StreetEvaluation evaluation;
  for (Fold& fold : folds) {
    evaluation.by_map[test_corpus.maps[fold.map].name] = fold.scores;
    evaluation.all += fold.scores;
    evaluation.mean_exact_path += fold.scores.exact_path.value() / static_cast<double>(folds.size());
    evaluation.mean_goal += fold.scores.goal.value() / static_cast<double>(folds.size());
    for (StreetPrediction& prediction : fold.predictions)
      evaluation.predictions.push_back(std::move(prediction));
  }
  return evaluation;
}

}  // namespace waymark::streets
