#include "libparser/training/learn.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "libparser/training/learn_linear.hpp"
#include "libparser/training/learn_network.hpp"
#include "libparser/training/learn_reranker.hpp"

namespace waymark::parser {
namespace {

// Two or more disjoint groups: by map when there are several, otherwise the first and the second half.
std::vector<std::vector<const Example*>> groups_of(std::span<const Example* const> examples) {
  std::map<std::size_t, std::vector<const Example*>> by_map;
  for (const Example* example : examples) by_map[example->map].push_back(example);
  std::vector<std::vector<const Example*>> groups;
  for (auto& [map, group] : by_map) groups.push_back(std::move(group));
  if (groups.size() > 1) return groups;
  const auto half = examples.begin() + static_cast<std::ptrdiff_t>(examples.size() / 2);
  return {{examples.begin(), half}, {half, examples.end()}};
}

// The words, for the reranker.
std::shared_ptr<const RankingModel> ranking_of(std::span<const Example* const> examples,
                                               const ltl::Vocabulary& vocabulary, Dialect dialect) {
  auto ranking = std::make_shared<RankingModel>(vocabulary, dialect);
  for (const Example* example : examples)
    for (const std::string& word : example->input.tokens) ranking->words.add(word);
  for (const char* side : {"left", "right"}) ranking->words.add(side);  // of mirror images
  return ranking;
}

}  // namespace

Grounder learn_reader(std::span<const Example* const> examples, std::span<const Executor> executors,
                      const TrainOptions& options, const JobProgress& progress) {
  if (options.reader == ReaderKind::Linear) return grounder_of(learn_linear(examples, executors, options, progress));
  return {learn_network(examples, executors, options, progress),
          ranking_of(examples, executors.front().map().vocabulary(), options.dialect)};
}

Grounder train_on(std::span<const Example* const> examples, std::span<const Executor> executors,
                  const TrainOptions& options) {
  const bool chooses = options.reranker && examples.size() > 1;
  const auto groups = chooses ? groups_of(examples) : std::vector<std::vector<const Example*>>{};
  Grounder grounder;
  std::vector<RankingInstances> instances(groups.size());
  const auto job = [&](std::size_t i, const JobProgress& progress) {
    if (i == 0) {  // the longest first
      grounder = learn_reader(examples, executors, options, progress);
      return;
    }
    std::vector<const Example*> others;
    for (std::size_t h = 0; h < groups.size(); ++h)
      if (h != i - 1) others.insert(others.end(), groups[h].begin(), groups[h].end());
    add_ranking_instances(learn_reader(others, executors, options, progress), groups[i - 1], executors, options,
                          instances[i - 1]);
  };
  const Report most = [&](double fraction, std::string_view what) {
    if (options.progress) options.progress(0.9 * fraction, what);
  };
  run_jobs(1 + groups.size(), options.threads, most, "learning", job);
  if (!chooses) return grounder;
  RankingInstances all;
  for (RankingInstances& group : instances) all.add(std::move(group));
  return with_reranker(grounder, all, executors, options, [&](double fraction) {
    if (options.progress) options.progress(0.9 + 0.1 * fraction, "learning to choose");
  });
}

Grounder train(const Corpus& corpus, std::span<const plan::Map> maps, const TrainOptions& options) {
  if (maps.empty()) throw std::invalid_argument("training needs maps");
  const std::vector<Executor> executors(maps.begin(), maps.end());
  for (const plan::Map& map : maps)
    if (!(map.vocabulary() == maps.front().vocabulary()))
      throw std::invalid_argument("maps " + maps.front().name() + " and " + map.name() +
                                  " have different vocabularies");
  for (const Paragraph& paragraph : corpus.paragraphs)
    if (std::none_of(maps.begin(), maps.end(), [&](const plan::Map& map) { return map.name() == paragraph.map; }))
      throw std::invalid_argument("paragraph " + paragraph.id + ": there is no map '" + paragraph.map + "'");
  Examples examples = make_examples(corpus, executors, options.convention);
  if (examples.sentences.empty()) throw std::invalid_argument("the corpus holds no sentence to learn from");
  const auto report = [&](double fraction, std::string_view what) {
    if (options.progress) options.progress(fraction, what);
    return !options.stop.stop_requested();
  };
  find_programs(examples.sentences, executors, PostfixGrammar(maps.front().vocabulary(), options.dialect),
                options.threads, [&](double) { return report(0, "searching for programs"); });
  std::vector<const Example*> instances;
  for (const Example& example : examples.sentences) instances.push_back(&example);
  return train_on(instances, executors, options);
}

}  // namespace waymark::parser
