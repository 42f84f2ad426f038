#include "libparser/training/learn_network.hpp"

#include <algorithm>

#include "libltl/parallel.hpp"
#include "libneural/adam.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/decode/network_trie.hpp"
#include "libparser/decode/randomised_beam.hpp"
#include "libparser/supervision/lexical_overlap.hpp"
#include "libparser/training/feedback.hpp"
#include "libparser/training/objective.hpp"
#include "libparser/training/training_instance.hpp"

namespace waymark::parser {
namespace {

using neural::Index;

// A sentence, or its mirror image, while it is learned from.
struct TrainingInstance {
  const Example* example;
  bool mirrored;
  NetworkSentence sentence;
  std::vector<bool> places;  // it names
  Wording wording;
  NetworkTrie trie;
};

class Learner {
 public:
  Learner(std::span<const Example* const> examples, std::span<const Executor> executors, const TrainOptions& options,
          const JobProgress& progress)
      : options_(options),
        how_(options.network),
        progress_(progress),
        random_(options.seed),
        language_(executors.front().map().vocabulary(), options.dialect),
        images_(mirror_images(language_.vocabulary())),
        place_numbers_(place_numbers(language_)),
        network_(TypedPostfix(language_), words_met_twice(examples), how_.sizes, [this] { return random_.unit(); }),
        adam_(network_.parameters(), {.rate = how_.rate}) {
    for (std::size_t s = 0; s < shards; ++s) shards_.emplace_back(network_, executors, options, s);
    instances_.reserve(2 * examples.size());
    for (const Example* example : examples) {
      add_instance(*example, false);
      if (options.mirrored) add_instance(*example, true);
    }
  }

  std::shared_ptr<const NetworkModel> run() {
    const std::size_t steps = (instances_.size() + how_.batch - 1) / how_.batch;
    each_batch(
        instances_.size(), how_.batch, how_.epochs, options_.stop, [&](std::size_t n) { return random_.below(n); },
        [&](std::span<const std::size_t> instances, int epoch, std::size_t begin) {
          const std::size_t b = begin / how_.batch;
          const double done = (epoch + static_cast<double>(b) / static_cast<double>(steps)) / how_.epochs;
          step(instances, how_.search == ProgramSearch::Beam || explores(options_, epoch), done);
          if (b % 16 == 0) progress_(done);
        });
    return std::make_shared<const NetworkModel>(std::move(network_));
  }

 private:
  static constexpr std::size_t shards = 2;

  struct Shard {  // what one thread needs for its part of a batch
    Shard(const EncoderDecoder& network, std::span<const Executor> executors, const TrainOptions& options,
          std::size_t number)
        : parameters(network.parameters()),
          masks(network.symbols()),
          random(options.seed + 1000 * (number + 1)),
          feedback(executors, options.network.feedback, options.then, options.seed) {}
    neural::Parameters parameters;
    ChoiceMasks masks;
    ltl::Random random;
    Feedback feedback;
    EncoderDecoder::Pass pass;
  };

  void add_instance(const Example& example, bool mirrored) {
    SentenceInput input = example.input;
    if (mirrored) input.tokens = mirror(input.tokens);
    SentenceFeatures features = sentence_features(input, network_.words());
    TrainingInstance instance{
        &example, mirrored, network_.sentence(input), std::move(features.places), Wording(language_, features.mentions),
        {}};
    if (how_.search == ProgramSearch::Consistent) {
      std::vector<std::pair<Program, double>> programs;
      double best = 0;
      for (const Consistent& candidate : *example.programs) {
        const auto weighed = weigh(instance, candidate.program, candidate.same_route, shards_.front().feedback);
        if (weighed.second <= 0) continue;
        best = std::max(best, weighed.second);
        programs.push_back(weighed);
      }
      for (const auto& [program, weight] : programs)
        if (weight >= how_.least * best)
          instance.trie.add(NetworkPrefixes(network_, shards_.front().masks), program, weight);
      if (instance.trie.programs() == 0) return;
    }
    instances_.push_back(std::move(instance));
  }

  // A program of the sentence as it stands → the program of the instance, mirrored or not, and its reward times its
  // prior.
  std::pair<Program, double> weigh(const TrainingInstance& instance, const Program& program, bool same_route,
                                   Feedback& feedback) const {
    if (names_other_place(program, place_numbers_, instance.places)) return {program, 0};
    Program read = instance.mirrored ? mirror(program, images_) : program;
    const double prior = prior_weight(options_, same_route, instance.wording.lexical_overlap_penalty(read));
    const bool known = how_.search == ProgramSearch::Consistent && how_.feedback == FeedbackKind::Plan;
    return {std::move(read), prior * (known ? 1.0 : feedback.of(program, *instance.example))};
  }

  void step(std::span<const std::size_t> instances, bool explore, double done) {
    neural::Parameters& parameters = network_.parameters();
    const auto learn_shard = [&](std::size_t s, std::size_t) {
      std::vector<TrainingInstance*> own;
      for (std::size_t i = s; i < instances.size(); i += shards) own.push_back(&instances_[instances[i]]);
      if (!own.empty()) learn(shards_[s], own, explore);
    };
    for (Shard& shard : shards_) {
      shard.parameters.values() = parameters.values();
      shard.parameters.gradients().setZero();
    }
    ltl::parallel_for(shards, static_cast<std::size_t>(std::max(options_.threads, 1)), learn_shard);
    for (const Shard& shard : shards_) parameters.gradients() += shard.parameters.gradients();
    parameters.gradients() /= static_cast<float>(instances.size());
    neural::clip_gradients(parameters, how_.clip);
    adam_.set_rate(how_.rate * (1 - done));
    adam_.step(parameters);
  }

  void learn(Shard& shard, std::span<TrainingInstance* const> instances, bool explore) const {
    std::vector<const NetworkSentence*> sentences;
    for (const TrainingInstance* instance : instances) sentences.push_back(&instance->sentence);
    if (explore) add_own_programs(shard, instances, sentences);
    shard.pass.encode(network_, shard.parameters, sentences,
                      {how_.dropout, how_.word_dropout, [&] { return shard.random.unit(); }});
    std::vector<History> histories;
    std::vector<Index> begin{0};
    for (const TrainingInstance* instance : instances) {
      append_histories(instance->trie, histories);
      begin.push_back(static_cast<Index>(histories.size()));
    }
    if (histories.empty()) return;
    const neural::Matrix& scores = shard.pass.decode(begin, histories);
    neural::Matrix dscores = neural::Matrix::Zero(scores.rows(), scores.cols());
    for (std::size_t i = 0; i < instances.size(); ++i) {
      TrainingInstance& instance = *instances[i];
      if (instance.trie.programs() == 0) continue;
      const Likelihoods found = likelihoods(instance.trie, scores, begin[i], instance.sentence.forbidden);
      std::vector<float> gradient =
          objective_gradient(how_.objective, how_.beta, found.log_p, instance.trie.log_weights());
      for (float& g : gradient) g = -g;  // Adam goes down
      backpropagate(instance.trie, found, gradient, dscores, begin[i]);
    }
    shard.pass.backward(shard.parameters, dscores);
    if (how_.search == ProgramSearch::Beam)
      for (TrainingInstance* instance : instances) instance->trie = {};
  }

  // Those of its randomised beam that are rewarded go to an instance's programs.
  void add_own_programs(Shard& shard, std::span<TrainingInstance* const> instances,
                        std::span<const NetworkSentence* const> sentences) const {
    shard.pass.encode(network_, shard.parameters, sentences);
    const auto found =
        randomised_beam(network_, shard.pass, sentences, shard.masks, how_.beam, how_.epsilon, shard.random);
    for (std::size_t i = 0; i < instances.size(); ++i) {
      TrainingInstance& instance = *instances[i];
      for (const Candidate& candidate : found[i]) {
        const Program here = instance.mirrored ? mirror(candidate.program, images_) : candidate.program;
        if (how_.search == ProgramSearch::Consistent && shard.feedback.of(here, *instance.example) <= 0) continue;
        if (!agrees(shard.feedback.executor(*instance.example), here, instance.example->judged)) continue;
        const auto [program, weight] =
            weigh(instance, here, goes_the_gold_route(here, *instance.example, shard), shard.feedback);
        if (weight > 0) instance.trie.add(NetworkPrefixes(network_, shard.masks), program, weight);
      }
    }
  }

  // Asked only where it counts for something.
  bool goes_the_gold_route(const Program& program, const Example& example, const Shard& shard) const {
    if (options_.other_route == 1) return true;
    const auto plan = shard.feedback.executor(example).run(program, example.gold.start, options_.then);
    return plan && plan->actions == example.gold.actions;
  }

  const TrainOptions& options_;
  const NetworkTraining& how_;
  const JobProgress& progress_;
  ltl::Random random_;
  ProgramLanguage language_;
  std::vector<std::uint16_t> images_;
  std::vector<std::size_t> place_numbers_;
  EncoderDecoder network_;
  neural::Adam adam_;
  std::vector<Shard> shards_;
  std::vector<TrainingInstance> instances_;
};

}  // namespace

std::shared_ptr<const NetworkModel> learn_network(std::span<const Example* const> examples,
                                                  std::span<const Executor> executors, const TrainOptions& options,
                                                  const JobProgress& progress) {
  return Learner(examples, executors, options, progress).run();
}

}  // namespace waymark::parser
