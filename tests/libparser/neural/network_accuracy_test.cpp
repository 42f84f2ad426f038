// What the networks reach in a language of our own, on a map that they have not seen: minutes of training.
#include "libparser/neural/learn_network.hpp"

#include <gtest/gtest.h>

#include "libparser/evaluate.hpp"
#include "libparser/generate.hpp"
#include "libparser/neural/action_network.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

const Corpus& lessons() {  // on grid and jelly
  static const Corpus corpus =
      generate_corpus(std::span(shipped_maps()).first(2), {.seed = 1, .paragraphs = 60, .sentences = 4});
  return corpus;
}

TrainOptions options_of(int epochs) {
  TrainOptions options;
  options.reader = ReaderKind::EncoderDecoder;
  options.network.epochs = epochs;
  options.network.sizes = {.word = 16, .width = 16, .query = 24, .symbol = 12, .history = 4};
  options.chooser = false;
  options.beam = 16;
  return options;
}

// Sentences of the same language on a map that was not learned from.
double accuracy(const Follower& follower) {
  const auto other = std::span(shipped_maps()).subspan(2);
  const Corpus test = generate_corpus(other, {.seed = 9, .paragraphs = 25, .sentences = 4});
  return evaluate(follower, test, other.front(), Convention::Absolute).sentence.absolute.value();
}

TEST(NetworkAccuracy, LearnsItsOwnLanguageFromTrajectories) {
  const Grounder grounder = train(lessons(), std::span(shipped_maps()).first(2), options_of(8));
  EXPECT_GE(accuracy(GroundingFollower({grounder}, {})), 70);
}

TEST(NetworkAccuracy, AsThePaperHasItLearnsSomethingFromItsOwnBeam) {
  for (const Objective objective :
       {Objective::MarginalLikelihood, Objective::Meritocratic, Objective::Reinforce}) {
    TrainOptions options = options_of(12);
    options.network.search = ProgramSearch::Beam;
    options.network.objective = objective;
    options.network.feedback = FeedbackKind::Plan;
    options.network.beam = 16;
    options.wording = 0;
    options.other_route = 1;
    options.mirrored = false;
    const Grounder grounder = train(lessons(), std::span(shipped_maps()).first(2), options);
    EXPECT_GE(accuracy(GroundingFollower({grounder}, {.trust = 0})), 20) << static_cast<int>(objective);
  }
}

TEST(NetworkAccuracy, ActionsAreLearnedFromTheSameTrajectories) {
  const std::vector<Executor> executors(shipped_maps().begin(), shipped_maps().end());
  const Examples examples = make_examples(lessons(), executors, Convention::Absolute);
  std::vector<const Example*> all;
  for (const Example& example : examples.sentences) all.push_back(&example);
  EXPECT_GE(accuracy(*learn_actions(all, executors, options_of(12), [](double) {})), 30);
}

}  // namespace
}  // namespace waymark::parser
