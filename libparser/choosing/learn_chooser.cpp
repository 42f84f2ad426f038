#include "libparser/choosing/learn_chooser.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
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
  std::vector<std::size_t> right;
};

class ChooserLearner {
 public:
  // table: of the model, the chooser or the locator.
  ChooserLearner(LinearModel& model, WeightTable& table, std::span<const Executor> executors,
                 const TrainOptions& options)
      : model_(model),
        table_(table),
        executors_(executors),
        optimizer_(table, options.chooser_rate, options.chooser_decay) {
    *table_.row(table_.add(log_mass_feature())) = 1.0F;
  }

  Lesson lesson(const Dilemma& dilemma, bool mirrored) {
    SentenceInput input = dilemma.example->input;
    if (mirrored) input.tokens = mirror(input.tokens);
    ChooserSentence sentence(model_, input, mirrored);
    for (const Dilemma::Option& option : dilemma.options)
      sentence.add_end(executors_[dilemma.example->map], option.start, option.plan, option.mass);
    EndFeatures features = sentence.take();
    Lesson lesson{{}, std::move(features.ends), std::move(features.log_mass), dilemma.right};
    for (const auto& bundle : features.bundles) {
      auto& rows = lesson.bundles.emplace_back();
      for (std::uint64_t feature : bundle) rows.push_back(table_.add(feature));
    }
    return lesson;
  }

  // One step up the log-probability that one of the right options is taken.
  void learn(const Lesson& lesson) {
    const std::size_t n = lesson.ends.size();
    std::vector<float> bundles(lesson.bundles.size(), 0.0F), errors(lesson.bundles.size(), 0.0F), p(n);
    for (std::size_t b = 0; b < bundles.size(); ++b)
      for (std::uint32_t row : lesson.bundles[b]) bundles[b] += *table_.row(row);
    const std::uint32_t mass_row = table_.find(log_mass_feature());
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = *table_.row(mass_row) * lesson.log_mass[i];
      for (std::uint32_t b : lesson.ends[i]) p[i] += bundles[b];
    }
    const float highest = *std::max_element(p.begin(), p.end());
    float total = 0, right = 0, mass_error = 0;
    for (float& x : p) total += x = std::exp(x - highest);
    for (std::size_t i : lesson.right) right += p[i];
    std::vector<float> wanted(n, 0.0F);
    for (std::size_t i : lesson.right)
      wanted[i] = right > 0 ? p[i] / right : 1.0F / static_cast<float>(lesson.right.size());
    for (std::size_t i = 0; i < n; ++i) {
      const float error = wanted[i] - p[i] / total;
      mass_error += error * lesson.log_mass[i];
      for (std::uint32_t b : lesson.ends[i]) errors[b] += error;
    }
    optimizer_.update(mass_row, &mass_error);
    for (std::size_t b = 0; b < bundles.size(); ++b)
      for (std::uint32_t row : lesson.bundles[b]) optimizer_.update(row, &errors[b]);
  }

 private:
  LinearModel& model_;
  WeightTable& table_;
  std::span<const Executor> executors_;
  AdaGrad optimizer_;
};

// The options that one decision gives.
void add_options(const Decision& decision, plan::PoseId start, Dilemma& dilemma) {
  for (const End& end : decision.ends)
    dilemma.options.push_back({start, *decision.plans[end.candidate], end.mass});
}

void learn_table(LinearModel& model, WeightTable& table, std::span<const Dilemma> dilemmas,
                 std::span<const Executor> executors, const TrainOptions& options,
                 const JobProgress& progress) {
  ChooserLearner learner(model, table, executors, options);
  std::vector<Lesson> lessons;
  for (const Dilemma& dilemma : dilemmas) {
    if (options.stop.stop_requested()) throw Stopped{};
    lessons.push_back(learner.lesson(dilemma, false));
    if (options.mirrored) lessons.push_back(learner.lesson(dilemma, true));
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

}  // namespace

void Dilemmas::add(Dilemmas&& more) {
  const auto move = [](std::vector<Dilemma>& from, std::vector<Dilemma>& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move(more.of_ends, of_ends);
  move(more.of_starts, of_starts);
}

void add_dilemmas(const Grounder& reader, std::span<const Example* const> examples,
                  std::span<const Executor> executors, const TrainOptions& options, Dilemmas& dilemmas) {
  constexpr std::size_t other_starts = 4;
  Decision before;
  for (std::size_t i = 0; i < examples.size(); ++i) {
    if (options.stop.stop_requested()) throw Stopped{};
    const Example& example = *examples[i];
    const Executor& executor = executors[example.map];
    const plan::PoseId start = example.gold.start;
    const std::vector<Weighed> programs =
        likely_programs(reader, example.input, {options.beam, options.then, options.trust, options.clauses});
    Decision decision = decide(programs, executor, {&start, 1}, options.then);
    Dilemma dilemma{&example, {}, {}};
    add_options(decision, start, dilemma);
    for (std::size_t k = 0; k < decision.ends.size(); ++k)
      if (decision.ends[k].pose == example.gold.end) dilemma.right.push_back(k);
    if (!dilemma.right.empty() && dilemma.options.size() > 1) dilemmas.of_ends.push_back(dilemma);
    if (i > 0 && goes_on(*examples[i - 1], example)) {
      dilemma.right.resize(decision.ends.size());
      std::iota(dilemma.right.begin(), dilemma.right.end(), std::size_t{0});
      std::size_t others = 0;
      for (const End& end : before.ends)
        if (end.pose != start && others++ < other_starts)
          add_options(decide(programs, executor, {&end.pose, 1}, options.then), end.pose, dilemma);
      if (!dilemma.right.empty() && dilemma.options.size() > dilemma.right.size())
        dilemmas.of_starts.push_back(std::move(dilemma));
    }
    before = std::move(decision);
  }
}

Grounder with_chooser(const Grounder& reader, const Dilemmas& dilemmas, std::span<const Executor> executors,
                      const TrainOptions& options, const JobProgress& progress) {
  auto model = std::make_shared<LinearModel>(reader.model->vocabulary(), reader.model->dialect());
  model->words = reader.model->words;
  learn_table(*model, model->chooser, dilemmas.of_ends, executors, options,
              [&](double fraction) { progress(0.3 * fraction); });
  learn_table(*model, model->locator, dilemmas.of_starts, executors, options,
              [&](double fraction) { progress(0.3 + 0.7 * fraction); });
  return {reader.reader, std::move(model)};
}

}  // namespace waymark::parser
