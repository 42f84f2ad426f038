#include "libparser/training/learn_reranker.hpp"

#include <algorithm>
#include <iterator>

#include "libparser/training/learn_ranker.hpp"

namespace waymark::parser {
namespace {

// The candidates that one decision gives.
void add_candidates(const Decision& decision, plan::PoseId start, RankingInstance& instance) {
  for (const End& end : decision.ends)
    instance.candidates.push_back({{start, *decision.plans[end.candidate]}, end.mass});
}

// Has it a right candidate and a wrong one?
bool teaches(const RankingInstance& instance) {
  const auto right = std::count_if(instance.candidates.begin(), instance.candidates.end(),
                                   [&](const auto& c) { return Hallways::right(instance, c.route); });
  return right > 0 && static_cast<std::size_t>(right) < instance.candidates.size();
}

void learn_table(const RankingModel& model, WeightTable& table, std::span<const RankingInstance> all,
                 std::span<const Executor> executors, const TrainOptions& options, const JobProgress& progress) {
  *table.row(table.add(log_mass_feature())) = 1.0F;
  std::vector<Hallways::Text> texts;
  for (const RankingInstance& instance : all) {
    texts.push_back({&instance, false});
    if (options.mirrored) texts.push_back({&instance, true});
  }
  Hallways hallways(model, executors);
  learn_ranker(hallways, std::span<const Hallways::Text>(texts), table,
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
                           std::span<const Executor> executors, const TrainOptions& options, RankingInstances& all) {
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
    RankingInstance ends{&example, RankingInstance::Question::End, {}};
    add_candidates(decision, start, ends);
    if (i > 0 && goes_on(*examples[i - 1], example)) {
      RankingInstance starts{&example, RankingInstance::Question::Start, ends.candidates};
      std::size_t others = 0;
      for (const End& end : before.ends)
        if (end.pose != start && others++ < other_starts)
          add_candidates(decide(programs, executor, {&end.pose, 1}, options.then), end.pose, starts);
      if (teaches(starts)) all.of_starts.push_back(std::move(starts));
    }
    if (teaches(ends)) all.of_ends.push_back(std::move(ends));
    before = std::move(decision);
  }
}

Grounder with_reranker(const Grounder& reader, const RankingInstances& all, std::span<const Executor> executors,
                       const TrainOptions& options, const JobProgress& progress) {
  auto model =
      std::make_shared<RankingModel>(reader.ranking->language.vocabulary(), reader.ranking->language.dialect());
  model->words = reader.ranking->words;
  learn_table(*model, model->reranker, all.of_ends, executors, options,
              [&](double fraction) { progress(0.3 * fraction); });
  learn_table(*model, model->start_pose_model, all.of_starts, executors, options,
              [&](double fraction) { progress(0.3 + 0.7 * fraction); });
  return {reader.word_model, std::move(model)};
}

}  // namespace waymark::parser
