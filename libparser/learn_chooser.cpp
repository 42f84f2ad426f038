#include "libparser/learn_chooser.hpp"

#include <algorithm>
#include <random>

#include "libparser/adagrad.hpp"
#include "libparser/token.hpp"

namespace waymark::parser {
namespace {

class ChooserLearner {
 public:
  ChooserLearner(LinearModel& model, std::span<const Executor> executors, const TrainOptions& options)
      : model_(model),
        executors_(executors),
        optimizer_(model.chooser, options.chooser_rate, options.chooser_decay) {
    *model_.chooser.row(model_.chooser.add(log_mass_feature())) = 1.0F;
  }

  // One step up the log-probability of the gold end.
  void learn(const Dilemma& dilemma, const ChooserSentence& sentence) {
    const std::size_t n = dilemma.options.size();
    features_.resize(n);
    std::vector<double> probability(n);
    for (std::size_t i = 0; i < n; ++i) {
      sentence.features(executors_[dilemma.example->map], dilemma.example->gold.start,
                        dilemma.options[i].plan, dilemma.options[i].mass, features_[i]);
      for (auto& [feature, value] : features_[i])
        probability[i] += static_cast<double>(value * *model_.chooser.row(model_.chooser.add(feature)));
    }
    const double highest = *std::max_element(probability.begin(), probability.end());
    double total = 0;
    for (double& p : probability) total += p = std::exp(p - highest);
    gradient_.resize(model_.chooser.rows(), 0.0F);
    touched_.clear();
    for (std::size_t i = 0; i < n; ++i) {
      const auto error = static_cast<float>((i == dilemma.gold ? 1.0 : 0.0) - probability[i] / total);
      for (const auto& [feature, value] : features_[i]) {
        const std::uint32_t row = model_.chooser.find(feature);
        touched_.push_back(row);
        gradient_[row] += error * value;
      }
    }
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (std::uint32_t row : touched_) {
      optimizer_.update(row, &gradient_[row]);
      gradient_[row] = 0;
    }
  }

 private:
  LinearModel& model_;
  std::span<const Executor> executors_;
  AdaGrad optimizer_;
  std::vector<std::vector<std::pair<std::uint64_t, float>>> features_;
  std::vector<float> gradient_;
  std::vector<std::uint32_t> touched_;
};

}  // namespace

void add_dilemmas(const LinearModel& reader, std::span<const Example* const> examples,
                  std::span<const Executor> executors, const TrainOptions& options,
                  std::vector<Dilemma>& dilemmas) {
  for (const Example* example : examples) {
    if (options.stop.stop_requested()) throw Stopped{};
    Decision decision = decide(reader, executors[example->map], example->input, {&example->gold.start, 1},
                               options.beam, options.then);
    Dilemma dilemma{example, {}, decision.ends.size()};
    for (std::size_t i = 0; i < decision.ends.size(); ++i) {
      if (decision.ends[i].pose == example->gold.end) dilemma.gold = i;
      dilemma.options.push_back(
          {std::move(*decision.plans[decision.ends[i].candidate]), decision.ends[i].mass});
    }
    if (dilemma.gold < decision.ends.size() && decision.ends.size() > 1)
      dilemmas.push_back(std::move(dilemma));
  }
}

void learn_chooser(LinearModel& model, std::span<const Dilemma> dilemmas, std::span<const Executor> executors,
                   const TrainOptions& options) {
  ChooserLearner learner(model, executors, options);
  std::vector<std::pair<std::size_t, ChooserSentence>> lessons;
  for (std::size_t i = 0; i < dilemmas.size(); ++i) {
    SentenceInput input = dilemmas[i].example->input;
    lessons.emplace_back(i, ChooserSentence(model, input));
    if (!options.mirrored) continue;
    input.tokens = mirror(input.tokens);
    lessons.emplace_back(i, ChooserSentence(model, input, true));
  }
  std::mt19937_64 random(options.seed);
  for (int epoch = 0; epoch < options.chooser_epochs; ++epoch) {
    for (std::size_t i = lessons.size(); i > 1; --i) std::swap(lessons[i - 1], lessons[random() % i]);
    for (const auto& [i, sentence] : lessons) {
      if (options.stop.stop_requested()) throw Stopped{};
      learner.learn(dilemmas[i], sentence);
    }
    if (options.progress)
      options.progress(0.9 + 0.1 * (epoch + 1) / options.chooser_epochs, "learning to choose");
  }
}

}  // namespace waymark::parser
