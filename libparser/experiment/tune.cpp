#include "libparser/experiment/tune.hpp"

#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libparser/experiment/shared_jobs.hpp"

namespace waymark::parser {
namespace {

class Validation {
 public:
  Validation(const Corpus& corpus, std::span<const plan::Map> maps, const TrainOptions& options, const KeptPairs& kept)
      : corpus_(corpus),
        maps_(maps),
        options_(options),
        kept_(kept),
        executors_(maps.begin(), maps.end()),
        examples_(make_examples(corpus, executors_, options.convention)),
        instances_(maps.size()) {
    for (const Example& example : examples_.sentences) instances_[example.map].push_back(&example);
    for (std::size_t m = 0; m < maps.size(); ++m)
      if (!instances_[m].empty()) learned_.push_back(m);
    if (learned_.size() < 2) throw std::invalid_argument("validation needs sentences on at least two maps");
    found_.resize(learned_.size());
  }

  void run(bool waits) {
    run_shared_jobs({.count = learned_.size(),
                     .part = [&](std::size_t i) { return part(i); },
                     .run = [&](std::size_t i, const JobProgress& progress) { find_or_learn(i, progress); },
                     .waits = waits},
                    {.checkpoints = kept_.checkpoints, .threads = options_.threads, .stop = options_.stop},
                    options_.progress, "validating");
  }

  std::vector<ValidationPair> pairs() const {
    std::vector<ValidationPair> pairs;
    for (const auto& some : found_) pairs.insert(pairs.end(), some.begin(), some.end());
    return pairs;
  }

 private:
  std::string part(std::size_t i) const { return kept_.setting + maps_[learned_[i]].name() + ".pairs"; }

  void find_or_learn(std::size_t i, const JobProgress& progress) {
    if (const auto text = kept_.checkpoints ? kept_.checkpoints->find_text(part(i)) : std::nullopt) {
      found_[i] = pairs_of(*text, i);
      return;
    }
    learn(i, progress);
    if (kept_.checkpoints != nullptr) kept_.checkpoints->keep_text(part(i), text_of(found_[i]));
  }

  void learn(std::size_t i, const JobProgress& progress) {
    std::call_once(searched_, [&] {  // once something has to be learned
      find_programs(examples_.sentences, executors_, PostfixGrammar(maps_.front().vocabulary(), options_.dialect),
                    options_.threads, [&](double) { return !options_.stop.stop_requested(); });
    });
    TrainOptions single = options_;
    single.threads = 1;
    const Grounder reader =
        learn_reader(instances_[learned_[i]], executors_, single, [&](double fraction) { progress(0.8 * fraction); });
    const GroundingFollower follower({reader}, following(options_));
    for (const std::size_t other : learned_) {
      if (other == learned_[i]) continue;
      const Scores scores = evaluate(follower, corpus_, maps_[other], options_.convention, nullptr, options_.stop);
      Percent sentence = scores.sentence.absolute;
      sentence += scores.sentence.relative;  // of the two, one was counted
      found_[i].push_back({learned_[i], other, sentence});
    }
  }

  // A line for each pair: the number of the map tested, hits, total.
  static std::string text_of(const std::vector<ValidationPair>& pairs) {
    std::ostringstream out;
    for (const ValidationPair& pair : pairs)
      out << pair.tested << ' ' << pair.sentence.hits << ' ' << pair.sentence.total << '\n';
    return out.str();
  }

  std::vector<ValidationPair> pairs_of(const std::string& text, std::size_t i) const {
    std::istringstream in(text);
    std::vector<ValidationPair> pairs;
    for (ValidationPair pair{learned_[i], 0, {}}; in >> pair.tested >> pair.sentence.hits >> pair.sentence.total;)
      pairs.push_back(pair);
    if (pairs.size() + 1 != learned_.size() || !in.eof())
      throw ltl::FormatError(part(i), 0, 0, "is no validation of these maps");
    return pairs;
  }

  const Corpus& corpus_;
  std::span<const plan::Map> maps_;
  const TrainOptions& options_;
  const KeptPairs& kept_;
  std::vector<Executor> executors_;
  Examples examples_;
  std::once_flag searched_;
  std::vector<std::vector<const Example*>> instances_;  // by map
  std::vector<std::size_t> learned_;                    // maps with sentences
  std::vector<std::vector<ValidationPair>> found_;      // by map learned from
};

}  // namespace

std::vector<ValidationPair> validate(const Corpus& corpus, std::span<const plan::Map> maps, const TrainOptions& options,
                                     const KeptPairs& kept) {
  Validation validation(corpus, maps, options, kept);
  validation.run(true);
  return validation.pairs();
}

void help_to_validate(const Corpus& corpus, std::span<const plan::Map> maps, const TrainOptions& options,
                      const KeptPairs& kept) {
  Validation(corpus, maps, options, kept).run(false);
}

Percent without_map(std::span<const ValidationPair> pairs, std::size_t left_out) {
  Percent sum;
  for (const ValidationPair& pair : pairs)
    if (pair.learned != left_out && pair.tested != left_out) sum += pair.sentence;
  return sum;
}

}  // namespace waymark::parser
