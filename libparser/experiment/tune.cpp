#include "libparser/experiment/tune.hpp"

#include <stdexcept>

namespace waymark::parser {

std::vector<ValidationPair> validate(const Corpus& corpus, std::span<const plan::Map> maps,
                                     const TrainOptions& options) {
  const std::vector<Executor> executors(maps.begin(), maps.end());
  Examples examples = make_examples(corpus, executors, options.convention);
  find_programs(examples.sentences, executors, PostfixGrammar(maps.front().vocabulary(), options.dialect),
                options.threads, [&](double) { return !options.stop.stop_requested(); });
  std::vector<std::vector<const Example*>> instances(maps.size());
  for (const Example& example : examples.sentences) instances[example.map].push_back(&example);
  std::vector<std::size_t> learned;
  for (std::size_t m = 0; m < maps.size(); ++m)
    if (!instances[m].empty()) learned.push_back(m);
  if (learned.size() < 2) throw std::invalid_argument("validation needs sentences on at least two maps");
  std::vector<std::vector<ValidationPair>> found(learned.size());
  TrainOptions single = options;
  single.threads = 1;
  run_jobs(
      learned.size(), options.threads, options.progress, "validating", [&](std::size_t i, const JobProgress& progress) {
        const Grounder reader =
            learn_reader(instances[learned[i]], executors, single, [&](double fraction) { progress(0.8 * fraction); });
        const GroundingFollower follower({reader}, following(options));
        for (const std::size_t other : learned) {
          if (other == learned[i]) continue;
          const Scores scores = evaluate(follower, corpus, maps[other], options.convention, nullptr, options.stop);
          Percent sentence = scores.sentence.absolute;
          sentence += scores.sentence.relative;  // of the two, one was counted
          found[i].push_back({learned[i], other, sentence});
        }
      });
  std::vector<ValidationPair> pairs;
  for (const auto& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  return pairs;
}

Percent without_map(std::span<const ValidationPair> pairs, std::size_t left_out) {
  Percent sum;
  for (const ValidationPair& pair : pairs)
    if (pair.learned != left_out && pair.tested != left_out) sum += pair.sentence;
  return sum;
}

}  // namespace waymark::parser
