#include "libparser/training/learn_linear.hpp"

#include "libltl/structure/random.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/decode/best_first.hpp"
#include "libparser/decode/linear_trie.hpp"
#include "libparser/rerank/adagrad.hpp"
#include "libparser/supervision/lexical_overlap.hpp"
#include "libparser/training/training_instance.hpp"

namespace waymark::parser {
namespace {

// One sentence (or its mirror image) while it is learned from.
struct TrainingInstance {
  const Example* example;
  bool mirrored;
  SentenceFeatures features;
  Wording wording;
  LinearTrie trie;
};

class Learner {
 public:
  Learner(std::span<const Example* const> examples, std::span<const Executor> executors, const TrainOptions& options,
          const JobProgress& progress)
      : executors_(executors),
        options_(options),
        progress_(progress),
        model_(executors.front().map().vocabulary(), options.dialect),
        images_(mirror_images(model_.language.vocabulary())),
        optimizer_(model_.weights, options.learning_rate, options.decay),
        scorer_(model_),
        place_numbers_(place_numbers(model_.language)) {
    for (std::uint8_t kind = 0; kind < choice_kinds; ++kind)
      for (std::uint8_t step = 0; step < choice_steps; ++step)
        model_.weights.row(model_.weights.add(mention_feature({kind, step, 0, 0})))[model_.language.columns().mention] =
            static_cast<float>(options.mention);
    instances_.reserve(2 * examples.size());
    for (const Example* example : examples) {
      add_instance(*example, false);
      if (options.mirrored) add_instance(*example, true);
    }
  }

  LinearModel run() {
    ltl::Random random(options_.seed);
    const auto below = [&](std::size_t n) { return random.below(n); };
    each_batch(instances_.size(), 1, options_.epochs, options_.stop, below,
               [&](std::span<const std::size_t> one, int epoch, std::size_t i) {
                 learn(instances_[one.front()], explores(options_, epoch));
                 if (i % 64 == 0) progress_(fraction(epoch, i));
               });
    return std::move(model_);
  }

 private:
  double fraction(int epoch, std::size_t i) const {
    const double done = static_cast<double>(i) / static_cast<double>(instances_.size());
    return (epoch + done) / options_.epochs;
  }

  void add_instance(const Example& example, bool mirrored) {
    SentenceInput input = example.input;
    if (mirrored) input.tokens = mirror(input.tokens);
    SentenceFeatures features = sentence_features(input, model_.words, model_.language.steps());
    Wording wording(model_.language, features.mentions);
    TrainingInstance instance{&example, mirrored, std::move(features), std::move(wording), {}};
    for (const Consistent& candidate : *example.programs)
      add_program(instance, candidate.program, candidate.same_route);
    if (instance.trie.programs() > 0) instances_.push_back(std::move(instance));
  }

  // A program of the sentence as it stands, to the instance as it stands or mirrored.
  void add_program(TrainingInstance& instance, const Program& program, bool same_route) {
    if (names_other_place(program, place_numbers_, instance.features.places)) return;
    const Program read = instance.mirrored ? mirror(program, images_) : program;
    const double weight = prior_weight(options_, same_route, instance.wording.lexical_overlap_penalty(read));
    if (weight > 0) instance.trie.add(scorer_.prefixes(), read, weight);
  }

  void learn(TrainingInstance& instance, bool explore) {
    scorer_.begin(instance.features);
    if (explore) add_own_programs(instance);
    accumulate_gradient(instance.trie, scorer_, scratch_);
    scorer_.each_gradient([this](std::uint64_t feature, const float* gradient) {
      optimizer_.update(model_.weights.add(feature), gradient);
    });
  }

  // Consistent programs among those that the model now thinks likely.
  void add_own_programs(TrainingInstance& instance) {
    const Example& example = *instance.example;
    const Executor& executor = executors_[example.map];
    for (const Candidate& candidate : best_programs(scorer_, options_.explore)) {
      const Program here = instance.mirrored ? mirror(candidate.program, images_) : candidate.program;
      const auto plan = executor.run(here, example.gold.start, options_.then);
      if (plan && plan->end == example.gold.end && agrees(executor, here, example.judged))
        add_program(instance, here, plan->actions == example.gold.actions);
    }
  }

  std::span<const Executor> executors_;
  const TrainOptions& options_;
  const JobProgress& progress_;
  LinearModel model_;
  std::vector<std::uint16_t> images_;
  AdaGrad optimizer_;
  Scorer scorer_;
  TrieScratch scratch_;
  std::vector<std::size_t> place_numbers_;
  std::vector<TrainingInstance> instances_;
};

}  // namespace

LinearModel learn_linear(std::span<const Example* const> examples, std::span<const Executor> executors,
                         const TrainOptions& options, const JobProgress& progress) {
  return Learner(examples, executors, options, progress).run();
}

}  // namespace waymark::parser
