#include "libparser/choosing/learn_chooser.hpp"

#include <algorithm>
#include <random>

#include "libparser/corpus/token.hpp"
#include "libparser/lesson.hpp"
#include "libparser/linear/adagrad.hpp"

namespace waymark::parser {
namespace {

// A dilemma, or its mirror image, with its features turned into rows of the chooser's table.
struct Lesson {
  std::vector<std::vector<std::uint32_t>> bundles, ends;
  std::vector<float> log_mass;
  std::size_t gold;
};

class ChooserLearner {
 public:
  ChooserLearner(LinearModel& model, std::span<const Executor> executors, const TrainOptions& options)
      : model_(model),
        executors_(executors),
        optimizer_(model.chooser, options.chooser_rate, options.chooser_decay) {
    *model_.chooser.row(model_.chooser.add(log_mass_feature())) = 1.0F;
  }

  Lesson lesson(const Dilemma& dilemma, bool mirrored) {
    SentenceInput input = dilemma.example->input;
    if (mirrored) input.tokens = mirror(input.tokens);
    ChooserSentence sentence(model_, input, mirrored);
    for (const Dilemma::Option& option : dilemma.options)
      sentence.add_end(executors_[dilemma.example->map], dilemma.example->gold.start, option.plan,
                       option.mass);
    EndFeatures features = sentence.take();
    Lesson lesson{{}, std::move(features.ends), std::move(features.log_mass), dilemma.gold};
    for (const auto& bundle : features.bundles) {
      auto& rows = lesson.bundles.emplace_back();
      for (std::uint64_t feature : bundle) rows.push_back(model_.chooser.add(feature));
    }
    return lesson;
  }

  // One step up the log-probability of the gold end.
  void learn(const Lesson& lesson) {
    const std::size_t n = lesson.ends.size();
    std::vector<float> bundles(lesson.bundles.size(), 0.0F), errors(lesson.bundles.size(), 0.0F), p(n);
    for (std::size_t b = 0; b < bundles.size(); ++b)
      for (std::uint32_t row : lesson.bundles[b]) bundles[b] += *model_.chooser.row(row);
    const std::uint32_t mass_row = model_.chooser.find(log_mass_feature());
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = *model_.chooser.row(mass_row) * lesson.log_mass[i];
      for (std::uint32_t b : lesson.ends[i]) p[i] += bundles[b];
    }
    const float highest = *std::max_element(p.begin(), p.end());
    float total = 0, mass_error = 0;
    for (float& x : p) total += x = std::exp(x - highest);
    for (std::size_t i = 0; i < n; ++i) {
      const float error = (i == lesson.gold ? 1.0F : 0.0F) - p[i] / total;
      mass_error += error * lesson.log_mass[i];
      for (std::uint32_t b : lesson.ends[i]) errors[b] += error;
    }
    optimizer_.update(mass_row, &mass_error);
    for (std::size_t b = 0; b < bundles.size(); ++b)
      for (std::uint32_t row : lesson.bundles[b]) optimizer_.update(row, &errors[b]);
  }

 private:
  LinearModel& model_;
  std::span<const Executor> executors_;
  AdaGrad optimizer_;
};

}  // namespace

std::vector<Dilemma> dilemmas_of(const Grounder& reader, std::span<const Example* const> examples,
                                 std::span<const Executor> executors, const TrainOptions& options) {
  std::vector<Dilemma> dilemmas;
  for (const Example* example : examples) {
    if (options.stop.stop_requested()) throw Stopped{};
    Decision decision = decide(reader, executors[example->map], example->input, {&example->gold.start, 1},
                               {options.beam, options.then, options.trust});
    Dilemma dilemma{example, {}, decision.ends.size()};
    for (std::size_t i = 0; i < decision.ends.size(); ++i) {
      if (decision.ends[i].pose == example->gold.end) dilemma.gold = i;
      dilemma.options.push_back(
          {std::move(*decision.plans[decision.ends[i].candidate]), decision.ends[i].mass});
    }
    if (dilemma.gold < decision.ends.size() && decision.ends.size() > 1)
      dilemmas.push_back(std::move(dilemma));
  }
  return dilemmas;
}

void learn_chooser(LinearModel& model, std::span<const Dilemma* const> dilemmas,
                   std::span<const Executor> executors, const TrainOptions& options,
                   const JobProgress& progress) {
  ChooserLearner learner(model, executors, options);
  std::vector<Lesson> lessons;
  for (const Dilemma* dilemma : dilemmas) {
    if (options.stop.stop_requested()) throw Stopped{};
    lessons.push_back(learner.lesson(*dilemma, false));
    if (options.mirrored) lessons.push_back(learner.lesson(*dilemma, true));
  }
  std::mt19937_64 random(options.seed);
  const auto below = [&](std::size_t n) { return random() % n; };
  each_epoch(lessons.size(), options.chooser_epochs, below,
             [&](std::span<const std::size_t> order, int epoch) {
               for (const std::size_t i : order) {
                 if (options.stop.stop_requested()) throw Stopped{};
                 learner.learn(lessons[i]);
               }
               progress(static_cast<double>(epoch + 1) / options.chooser_epochs);
             });
}

Grounder with_chooser(const Grounder& reader, std::span<const Dilemma* const> dilemmas,
                      std::span<const Executor> executors, const TrainOptions& options,
                      const JobProgress& progress) {
  auto model = std::make_shared<LinearModel>(reader.model->vocabulary(), reader.model->dialect());
  model->words = reader.model->words;
  learn_chooser(*model, dilemmas, executors, options, progress);
  return {reader.reader, std::move(model)};
}

}  // namespace waymark::parser
