// What the networks reach in a language of our own, on a map that they have not seen: minutes of training.
#include "libparser/training/learn_network.hpp"

#include <gtest/gtest.h>

#include "libparser/experiment/action_network.hpp"
#include "libparser/experiment/evaluate.hpp"
#include "libparser/language/generate.hpp"
#include "tests/libparser/training/instances.hpp"

namespace waymark::parser {
namespace {

const Corpus& small_corpus() {
  static const Corpus corpus = training_corpus(60);
  return corpus;
}

// Sentences of the same language on a map that was not learned from.
double accuracy(const Follower& follower, std::size_t most_clauses = 2) {
  const auto other = std::span(shipped_maps()).subspan(2);
  const Corpus test =
      generate_corpus(other, {.seed = 9, .paragraphs = 25, .sentences = 4, .most_clauses = most_clauses});
  return evaluate(follower, test, other.front(), Convention::Absolute).sentence.absolute.value();
}

TEST(NetworkAccuracy, LearnsItsOwnLanguageFromTrajectories) {
  const Grounder grounder = train(small_corpus(), training_maps(), small_options(8));
  EXPECT_GE(accuracy(GroundingFollower({grounder}, {})), 70);
}

// Of one clause: rewards are found by chance there, and seldom for two.
TEST(NetworkAccuracy, AsThePaperHasItLearnsSomethingFromItsOwnBeam) {
  const Corpus clauses =
      generate_corpus(training_maps(), {.seed = 1, .paragraphs = 240, .sentences = 4, .most_clauses = 1});
  for (const Objective objective : {Objective::MarginalLikelihood, Objective::Meritocratic, Objective::Reinforce}) {
    TrainOptions options = small_options(16);
    options.network.search = ProgramSearch::Beam;
    options.network.objective = objective;
    options.network.feedback = FeedbackKind::Plan;
    options.network.beam = 16;
    options.wording = 0;
    options.other_route = 1;
    options.mirrored = false;
    const Grounder grounder = train(clauses, training_maps(), options);
    EXPECT_GE(accuracy(GroundingFollower({grounder}, {.deciding = {.trust = 0}}), 1), 20)
        << static_cast<int>(objective);
  }
}

TEST(NetworkAccuracy, ActionsAreLearnedFromTheSameTrajectories) {
  const TrainingExamples on(small_corpus());
  EXPECT_GE(accuracy(*learn_actions(on.all, on.executors, small_options(12), [](double) {})), 30);
}

}  // namespace
}  // namespace waymark::parser
