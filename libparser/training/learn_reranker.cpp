#include "libparser/training/learn_reranker.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <random>

#include "libparser/corpus/token.hpp"
#include "libparser/rerank/adagrad.hpp"
#include "libparser/training/training_instance.hpp"

namespace waymark::parser {
namespace {

// An instance, or its mirror image, with its features turned into rows of the reranker's table.
struct RankingRows {
  std::vector<std::vector<std::uint32_t>> bundles, ends;
  std::vector<float> log_mass;
  std::vector<std::size_t> right;
};

class RankingLearner {
 public:
  // table: of the model, the reranker or the start-pose model.
  RankingLearner(const RankingModel& model, WeightTable& table, std::span<const Executor> executors,
                 const TrainOptions& options)
      : model_(model),
        table_(table),
        executors_(executors),
        optimizer_(table, options.reranker_rate, options.reranker_decay) {
    *table_.row(table_.add(log_mass_feature())) = 1.0F;
  }

  RankingRows rows_of(const RankingInstance& instance, bool mirrored) {
    SentenceInput input = instance.example->input;
    if (mirrored) input.tokens = mirror(input.tokens);
    RerankerSentence sentence(model_, input, mirrored);
    for (const RankingInstance::Option& option : instance.options)
      sentence.add_end(executors_[instance.example->map], option.start, option.plan, option.mass);
    EndFeatures features = sentence.take();
    RankingRows rows{{}, std::move(features.ends), std::move(features.log_mass), instance.right};
    for (const auto& bundle : features.bundles) {
      auto& list = rows.bundles.emplace_back();
      for (std::uint64_t feature : bundle) list.push_back(table_.add(feature));
    }
    return rows;
  }

  // One step up the log-probability that one of the right options is taken.
  void learn(const RankingRows& instance) {
    const std::size_t n = instance.ends.size();
    std::vector<float> bundles(instance.bundles.size(), 0.0F), errors(instance.bundles.size(), 0.0F), p(n);
    for (std::size_t b = 0; b < bundles.size(); ++b)
      for (std::uint32_t row : instance.bundles[b]) bundles[b] += *table_.row(row);
    const std::uint32_t mass_row = table_.find(log_mass_feature());
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = *table_.row(mass_row) * instance.log_mass[i];
      for (std::uint32_t b : instance.ends[i]) p[i] += bundles[b];
    }
    const float highest = *std::max_element(p.begin(), p.end());
    float total = 0, right = 0, mass_error = 0;
    for (float& x : p) total += x = std::exp(x - highest);
    for (std::size_t i : instance.right) right += p[i];
    std::vector<float> wanted(n, 0.0F);
    for (std::size_t i : instance.right)
      wanted[i] = right > 0 ? p[i] / right : 1.0F / static_cast<float>(instance.right.size());
    for (std::size_t i = 0; i < n; ++i) {
      const float error = wanted[i] - p[i] / total;
      mass_error += error * instance.log_mass[i];
      for (std::uint32_t b : instance.ends[i]) errors[b] += error;
    }
    optimizer_.update(mass_row, &mass_error);
    for (std::size_t b = 0; b < bundles.size(); ++b)
      for (std::uint32_t row : instance.bundles[b]) optimizer_.update(row, &errors[b]);
  }

 private:
  const RankingModel& model_;
  WeightTable& table_;
  std::span<const Executor> executors_;
  AdaGrad optimizer_;
};

// The options that one decision gives.
void add_options(const Decision& decision, plan::PoseId start, RankingInstance& instance) {
  for (const End& end : decision.ends)
    instance.options.push_back({start, *decision.plans[end.candidate], end.mass});
}

void learn_table(const RankingModel& model, WeightTable& table, std::span<const RankingInstance> all,
                 std::span<const Executor> executors, const TrainOptions& options,
                 const JobProgress& progress) {
  RankingLearner learner(model, table, executors, options);
  std::vector<RankingRows> instances;
  for (const RankingInstance& instance : all) {
    if (options.stop.stop_requested()) throw Stopped{};
    instances.push_back(learner.rows_of(instance, false));
    if (options.mirrored) instances.push_back(learner.rows_of(instance, true));
  }
  std::mt19937_64 random(options.seed);
  const auto below = [&](std::size_t n) { return random() % n; };
  each_epoch(instances.size(), options.reranker_epochs, below,
             [&](std::span<const std::size_t> order, int epoch) {
               for (const std::size_t i : order) {
                 if (options.stop.stop_requested()) throw Stopped{};
                 learner.learn(instances[i]);
               }
               progress(static_cast<double>(epoch + 1) / options.reranker_epochs);
             });
}

}  // namespace

void RankingInstances::add(RankingInstances&& more) {
  const auto move = [](std::vector<RankingInstance>& from, std::vector<RankingInstance>& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move(more.of_ends, of_ends);
  move(more.of_starts, of_starts);
}

void add_ranking_instances(const Grounder& reader, std::span<const Example* const> examples,
                           std::span<const Executor> executors, const TrainOptions& options,
                           RankingInstances& all) {
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
    RankingInstance instance{&example, {}, {}};
    add_options(decision, start, instance);
    for (std::size_t k = 0; k < decision.ends.size(); ++k)
      if (decision.ends[k].pose == example.gold.end) instance.right.push_back(k);
    if (!instance.right.empty() && instance.options.size() > 1) all.of_ends.push_back(instance);
    if (i > 0 && goes_on(*examples[i - 1], example)) {
      instance.right.resize(decision.ends.size());
      std::iota(instance.right.begin(), instance.right.end(), std::size_t{0});
      std::size_t others = 0;
      for (const End& end : before.ends)
        if (end.pose != start && others++ < other_starts)
          add_options(decide(programs, executor, {&end.pose, 1}, options.then), end.pose, instance);
      if (!instance.right.empty() && instance.options.size() > instance.right.size())
        all.of_starts.push_back(std::move(instance));
    }
    before = std::move(decision);
  }
}

Grounder with_reranker(const Grounder& reader, const RankingInstances& all,
                       std::span<const Executor> executors, const TrainOptions& options,
                       const JobProgress& progress) {
  auto model = std::make_shared<RankingModel>(reader.ranking->language.vocabulary(),
                                              reader.ranking->language.dialect());
  model->words = reader.ranking->words;
  learn_table(*model, model->reranker, all.of_ends, executors, options,
              [&](double fraction) { progress(0.3 * fraction); });
  learn_table(*model, model->start_pose_model, all.of_starts, executors, options,
              [&](double fraction) { progress(0.3 + 0.7 * fraction); });
  return {reader.word_model, std::move(model)};
}

}  // namespace waymark::parser
