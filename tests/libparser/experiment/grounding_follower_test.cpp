#include "libparser/experiment/grounding_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "tests/libparser/rerank/random_decisions.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

constexpr double trust = 1.5;

// Random weights for every word that random_sentence says.
WordModel random_word_model(const ltl::Vocabulary& vocabulary) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> weight(-0.7F, 0.7F);
  auto model = std::make_shared<LinearModel>(vocabulary);
  for (const std::string& word : random_words)
    for (const auto& by_step : sentence_features({{word}, false}, model->words).by_context)
      for (const auto& features : by_step)
        for (const std::uint64_t feature : features) {
          float* const row = model->weights.row(model->weights.add(feature));
          for (std::size_t c = 0; c < model->weights.columns(); ++c) row[c] = weight(random);
        }
  return model;
}

// A follower with random weights for all that a paragraph may need, and every way through the paragraph by enumeration.
class World {
 public:
  World()
      : executor_(map_),
        ranking_(std::make_shared<RankingModel>(map_.vocabulary())),
        word_model_(random_word_model(map_.vocabulary())) {}

  Grounder grounder() const { return {word_model_, ranking_}; }
  GroundingFollower follower(std::size_t beam_width) const {
    return {{grounder()}, {.deciding = {.beam = 16, .trust = 0}, .paragraph = {beam_width, trust}}};
  }

  void draw() {
    paragraph = {random_sentence(random_), random_sentence(random_), random_sentence(random_)};
    start = {static_cast<std::uint32_t>(random_() % map_.poses())};
    draw_weights();
  }

  void draw_weights() {
    ranking_ = std::make_shared<RankingModel>(map_.vocabulary());
    for (const SentenceInput& input : paragraph)
      for (const std::string& word : input.tokens) ranking_->words.add(word);
    for (const SentenceInput& input : paragraph)  // ends of sentences depend on where they begin: from a few poses
      for (int i = 0; i < 4; ++i) {
        const plan::PoseId from{i == 0 ? start.index : static_cast<std::uint32_t>(random_() % map_.poses())};
        const Decision decision = decide(grounder(), executor_, input, {&from, 1}, {.beam = 16, .trust = 0});
        for (WeightTable* table : {&ranking_->reranker, &ranking_->start_pose_model})
          add_weights(*ranking_, executor_, input, from, decision, *table, random_);
      }
  }

  struct Way {
    std::vector<plan::PoseId> ends;
    double weight;
  };
  std::vector<Way> all_ways(const GroundingFollower& follower) const {
    std::vector<Way> ways{{{}, 1}};
    for (const SentenceInput& input : paragraph) {
      std::vector<Way> longer;
      for (const Way& way : ways) {
        const plan::PoseId from = way.ends.empty() ? start : way.ends.back();
        const auto verdict = follower.judge(executor_, input, follower.read(input), from);
        const double here = way.weight * std::exp(trust * verdict.evidence);
        const auto go = [&](plan::PoseId end, double p) {
          longer.push_back(way);
          longer.back().ends.push_back(end);
          longer.back().weight = here * p;
        };
        for (const Response& answer : verdict.answers) go(answer.end, answer.probability);
        if (verdict.answers.empty()) go(from, 1);
      }
      ways = std::move(longer);
    }
    return ways;
  }

  const plan::Map& map() const { return map_; }
  const Executor& executor() const { return executor_; }
  std::vector<SentenceInput> paragraph;
  plan::PoseId start;

 private:
  const plan::Map& map_ = shipped_maps()[2];
  Executor executor_;
  std::shared_ptr<RankingModel> ranking_;
  WordModel word_model_;
  std::mt19937_64 random_{11};
};

TEST(GroundingFollower, ParagraphsEndAtTheLikeliestPlaceOverAllWays) {
  World world;
  std::size_t not_greedy = 0;
  for (int i = 0; i < (testing::sanitized ? 15 : 45); ++i) {
    world.draw();
    const GroundingFollower whole = world.follower(100'000);
    std::map<std::uint32_t, double> places;
    std::map<plan::PoseId, double> poses;
    for (const auto& way : world.all_ways(whole)) {
      places[world.map().node_of(way.ends.back())] += way.weight;
      poses[way.ends.back()] += way.weight;
    }
    const auto answers = whole.follow_all(world.executor(), world.paragraph, world.start);
    ASSERT_EQ(answers.size(), world.paragraph.size());
    const plan::PoseId end = answers.back().end;
    for (const auto& [place, weight] : places) EXPECT_LE(weight, places[world.map().node_of(end)] * (1 + 1e-9));
    for (const auto& [pose, weight] : poses)
      if (world.map().node_of(pose) == world.map().node_of(end)) {
        EXPECT_LE(weight, poses[end] * (1 + 1e-9));
      }
    // Of the ways there, the likeliest.
    double best = 0, got = 0;
    for (const auto& way : world.all_ways(whole)) {
      if (way.ends.back() == end) best = std::max(best, way.weight);
      bool same = true;
      for (std::size_t k = 0; k < answers.size(); ++k) same = same && way.ends[k] == answers[k].end;
      if (same) got = std::max(got, way.weight);
    }
    EXPECT_NEAR(got, best, 1e-9 * best);
    const auto settled = world.follower(1).follow_all(world.executor(), world.paragraph, world.start);
    not_greedy += world.map().node_of(settled.back().end) != world.map().node_of(end) ? 1U : 0U;
  }
  EXPECT_GT(not_greedy, 0U);
}

TEST(GroundingFollower, AnswersGoOnWhereTheLastOneEnded) {
  World world;
  for (int i = 0; i < testing::scaled(40); ++i) {
    world.draw();
    for (const std::size_t beam_width : {1U, 3U}) {
      plan::PoseId pose = world.start;
      for (const Response& answer :
           world.follower(beam_width).follow_all(world.executor(), world.paragraph, world.start)) {
        if (!answer.program.empty()) {
          const auto plan = world.executor().run(answer.program, pose);
          ASSERT_TRUE(plan);
          EXPECT_EQ(plan->end, answer.end);
          EXPECT_EQ(plan->actions, answer.actions);
        }
        for (const plan::Action action : answer.actions) pose = *world.map().successor(pose, action);
        EXPECT_EQ(pose, answer.end);
      }
    }
  }
}

TEST(GroundingFollower, WithOnePoseAliveSentencesAreSettledOneByOne) {
  World world;
  for (int i = 0; i < testing::scaled(20); ++i) {
    world.draw();
    const GroundingFollower follower = world.follower(1);
    plan::PoseId pose = world.start;
    const auto answers = follower.follow_all(world.executor(), world.paragraph, world.start);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const Response want = follower.follow(world.executor(), world.paragraph[k], pose);
      EXPECT_EQ(answers[k].end, want.end);
      EXPECT_EQ(answers[k].actions, want.actions);
      pose = want.end;
    }
  }
}

TEST(GroundingFollower, VotersAreAveraged) {
  World world;
  std::size_t compared = 0;
  for (int i = 0; i < testing::scaled(20); ++i) {
    world.draw();
    const SentenceInput& input = world.paragraph.front();
    const Grounder one = world.grounder();
    world.draw_weights();
    const Grounder other = world.grounder();
    const auto judged = [&](std::vector<Grounder> grounders) {
      const GroundingFollower follower(std::move(grounders), {.deciding = {.beam = 16, .trust = 0}});
      return follower.judge(world.executor(), input, follower.read(input), world.start);
    };
    const auto a = judged({one}), b = judged({other}), both = judged({one, other});
    const auto of = [](const GroundingFollower::Verdict& verdict, plan::PoseId end) {
      double p = 0;
      for (const Response& answer : verdict.answers) p += answer.end == end ? answer.probability : 0;
      return p;
    };
    EXPECT_NEAR(both.evidence, (a.evidence + b.evidence) / 2, 1e-9);
    for (const Response& answer : both.answers) {
      EXPECT_NEAR(answer.probability, (of(a, answer.end) + of(b, answer.end)) / 2, 1e-9);
      compared += of(a, answer.end) != of(b, answer.end) ? 1U : 0U;
    }
  }
  EXPECT_GT(compared, 0U);
}

}  // namespace
}  // namespace waymark::parser
