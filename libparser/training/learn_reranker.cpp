#include "libparser/training/learn_reranker.hpp"

#include <iterator>
#include <numeric>

#include "libparser/corpus/token.hpp"
#include "libparser/training/learn_ranker.hpp"

namespace waymark::parser {
namespace {

// An instance, or its mirror image, with its features as rows of the table.
LabelledDecision labelled(const LinearModel& model, WeightTable& table, const RankingInstance& instance,
                          const Executor& executor, bool mirrored) {
  SentenceInput input = instance.example->input;
  if (mirrored) input.tokens = mirror(input.tokens);
  RerankerSentence sentence(model, input, mirrored);
  for (const RankingInstance::Option& option : instance.options)
    sentence.add_end(executor, option.start, option.plan, option.mass);
  LabelledDecision decision = numbered(sentence.take(), table);
  decision.right = instance.right;
  return decision;
}

// The options that one decision gives.
void add_options(const Decision& decision, plan::PoseId start, RankingInstance& instance) {
  for (const End& end : decision.ends)
    instance.options.push_back({start, *decision.plans[end.candidate], end.mass});
}

void learn_table(const LinearModel& model, WeightTable& table, std::span<const RankingInstance> all,
                 std::span<const Executor> executors, const TrainOptions& options,
                 const JobProgress& progress) {
  *table.row(table.add(log_mass_feature())) = 1.0F;
  std::vector<LabelledDecision> decisions;
  for (const RankingInstance& instance : all) {
    if (options.stop.stop_requested()) throw Stopped{};
    const Executor& executor = executors[instance.example->map];
    decisions.push_back(labelled(model, table, instance, executor, false));
    if (options.mirrored) decisions.push_back(labelled(model, table, instance, executor, true));
  }
  learn_ranker(table, decisions,
               {.seed = options.seed,
                .epochs = options.reranker_epochs,
                .rate = options.reranker_rate,
                .decay = options.reranker_decay,
                .stop = options.stop},
               progress);
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
  auto model = std::make_shared<LinearModel>(reader.model->vocabulary(), reader.model->dialect());
  model->words = reader.model->words;
  learn_table(*model, model->reranker, all.of_ends, executors, options,
              [&](double fraction) { progress(0.3 * fraction); });
  learn_table(*model, model->start_pose_model, all.of_starts, executors, options,
              [&](double fraction) { progress(0.3 + 0.7 * fraction); });
  return {reader.reader, std::move(model)};
}

}  // namespace waymark::parser
