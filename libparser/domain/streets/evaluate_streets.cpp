#include "libparser/domain/streets/evaluate_streets.hpp"

#include <stdexcept>

#include "libparser/domain/streets/read_together.hpp"
#include "libparser/domain/streets/second_look.hpp"
#include "libparser/training/parallel.hpp"

namespace waymark::streets {
namespace {

constexpr std::size_t readings_kept = 3;

struct Fold {
  std::size_t map;  // of the test corpus
  StreetScores scores;
  std::vector<StreetPrediction> predictions;
};

// Texts of a figure are read as one; each of them counts, as in exact_path.
parser::Percent read_figures(const std::vector<StreetPrediction>& predictions) {
  std::map<int, std::vector<const StreetPrediction*>> figures;
  std::vector<std::vector<const StreetPrediction*>> groups;
  for (const StreetPrediction& prediction : predictions)
    if (prediction.instruction->figure)
      figures[*prediction.instruction->figure].push_back(&prediction);
    else
      groups.push_back({&prediction});
  for (auto& [figure, texts] : figures) groups.push_back(std::move(texts));
  parser::Percent right;
  for (const auto& group : groups) {
    std::vector<std::vector<StreetReading>> texts;
    for (const StreetPrediction* prediction : group) texts.push_back(prediction->readings);
    const std::vector<StreetReading> readings = read_together(texts);
    right.total += group.size();
    for (const StreetPrediction* prediction : group)
      if (!readings.empty() && readings.front().route.landmarks == prediction->instruction->path)
        ++right.hits;
  }
  return right;
}

void test(Fold& fold, const StreetModel& model, const StreetCorpus& corpus) {
  StreetReader reader(corpus.maps[fold.map], model.common, model.limits);
  std::vector<const StreetInstruction*> texts;
  for (const StreetInstruction& instruction : corpus.instructions)
    if (instruction.map == fold.map) texts.push_back(&instruction);
  auto readings = look_again({model.second_look}, read_texts(model, corpus.maps[fold.map], texts));
  for (std::size_t t = 0; t < texts.size(); ++t) {
    const StreetInstruction& instruction = *texts[t];
    const auto found = reader.candidates(instruction.tokens, instruction.start);
    StreetPrediction prediction{&instruction, found.mentions, std::move(readings[t])};
    StreetScores one{{0, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 0}};
    if (!prediction.readings.empty()) {
      const StreetRoute& route = prediction.readings.front().route.landmarks;
      one.exact_path.hits = route == instruction.path ? 1 : 0;
      one.goal.hits = route.back() == instruction.path.back() ? 1 : 0;
      one.floor.hits = found.routes.front().landmarks == instruction.path ? 1 : 0;
    }
    for (const CandidateRoute& route : found.routes)
      one.supply.hits |= route.landmarks == instruction.path ? 1U : 0U;
    fold.scores += one;
    fold.predictions.push_back(std::move(prediction));
  }
  fold.scores.together = read_figures(fold.predictions);
  for (StreetPrediction& prediction : fold.predictions)
    if (prediction.readings.size() > readings_kept) prediction.readings.resize(readings_kept);
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
  together += other.together;
  return *this;
}

std::optional<StreetEvaluation> evaluate_streets(const StreetCorpus& train, const StreetCorpus& test_corpus,
                                                 bool train_all, int threads, const StreetOptions& options) {
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
    const auto own = train_all ? one : learn_streets(training_part(train, name, false), train.maps, options);
    if (own) test(folds[i], *own, test_corpus);
  });
  if (options.stop.stop_requested()) return std::nullopt;
  StreetEvaluation evaluation;
  for (Fold& fold : folds) {
    evaluation.by_map[test_corpus.maps[fold.map].name] = fold.scores;
    evaluation.all += fold.scores;
    evaluation.mean_exact_path += fold.scores.exact_path.value() / static_cast<double>(folds.size());
    evaluation.mean_goal += fold.scores.goal.value() / static_cast<double>(folds.size());
    evaluation.mean_together += fold.scores.together.value() / static_cast<double>(folds.size());
    for (StreetPrediction& prediction : fold.predictions)
      evaluation.predictions.push_back(std::move(prediction));
  }
  return evaluation;
}

}  // namespace waymark::streets
