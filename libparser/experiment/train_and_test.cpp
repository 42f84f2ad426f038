// The other experiment: everything is learned from, another corpus is tested on.
#include <chrono>
#include <stdexcept>
#include <utility>

#include "libparser/experiment/action_network.hpp"
#include "libparser/experiment/evaluate.hpp"

namespace waymark::parser {
namespace {

std::shared_ptr<const Follower> actions_follower(const Corpus& corpus, std::span<const plan::Map> maps,
                                                 const TrainOptions& options) {
  const std::vector<Executor> executors(maps.begin(), maps.end());
  const Examples examples = make_examples(corpus, executors, options.convention);
  std::vector<const Example*> all;
  for (const Example& example : examples.sentences) all.push_back(&example);
  return learn_actions(all, executors, options, [&](double fraction) {
    if (options.progress) options.progress(fraction, "learning actions");
  });
}

std::shared_ptr<const Follower> learned(const Corpus& corpus, std::span<const plan::Map> maps,
                                        const EvaluateOptions& how, Convention convention) {
  TrainOptions options = how.train;
  options.convention = convention;
  if (how.actions) return actions_follower(corpus, maps, options);
  std::vector<Grounder> members;
  for (std::size_t member = 0; member < how.ensemble; ++member, ++options.seed)
    members.push_back(train(corpus, maps, options));
  return follower_of(std::move(members), how);
}

}  // namespace

Evaluation evaluate_train_all(const Corpus& train, std::span<const plan::Map> maps, const Corpus& test,
                              std::span<const plan::Map> test_maps, const EvaluateOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Evaluation evaluation;
  HeardSentences heard;
  for (const Paragraph& paragraph : train.paragraphs)
    for (const Sentence& sentence : paragraph.sentences) heard.insert(sentence.tokens);
  for (const Convention convention : {Convention::Absolute, Convention::Relative}) {
    if (!(convention == Convention::Absolute ? options.absolute : options.relative)) continue;
    const auto follower = learned(train, maps, options, convention);
    for (const plan::Map& map : test_maps) {
      if (!(map.vocabulary() == maps.front().vocabulary()))
        throw std::invalid_argument("maps " + maps.front().name() + " and " + map.name() +
                                    " have different vocabularies");
      Fold<Scores, Prediction> fold{map.name()};
      fold.scores = evaluate(*follower, test, map, convention, &fold.predictions, options.train.stop, &heard);
      if (fold.scores.sentence.absolute.total + fold.scores.sentence.relative.total == 0) continue;
      evaluation.add(std::move(fold));
    }
  }
  evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return evaluation;
}

}  // namespace waymark::parser
