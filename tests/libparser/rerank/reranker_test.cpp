#include "libparser/rerank/reranker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "libparser/corpus/token.hpp"
#include "tests/libparser/rerank/random_decisions.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

plan::PoseId random_pose(const plan::Map& map, std::mt19937_64& random) {
  return {static_cast<std::uint32_t>(random() % map.poses())};
}

struct Case {
  const plan::Map& map = shipped_maps()[1];
  Executor executor{map};
  std::shared_ptr<RankingModel> model = std::make_shared<RankingModel>(map.vocabulary());
  std::mt19937_64 random{7};
  SentenceInput input;
  plan::PoseId start;
  Decision decision;

  Case() {
    for (const char* word : {"left", "right", "chair", "blue", "two", "until", "wall", "second"})
      model->words.add(word);
  }
  void draw() {
    input = random_sentence(random);
    input.heading_unknown = random() % 2 == 0;
    start = random_pose(map, random);
    decision = decide(random_candidates(input, model->language.grammar(), 16), executor, {&start, 1}, Then::WholePlan);
    add_weights(*model, executor, input, start, decision, model->reranker, random);
    add_weights(*model, executor, input, start, decision, model->start_pose_model, random);
  }
  // w · f, feature by feature, each end by itself.
  double score(const WeightTable& table, const End& end) const {
    RerankerSentence sentence(*model, input);
    sentence.add_end(executor, start, *decision.plans[end.candidate], end.mass);
    const CandidateFeatures features = sentence.take();
    double sum = 0;
    for (const std::uint32_t bundle : features.candidates.front())
      for (const auto& [feature, value] : features.bundles[bundle])
        sum += static_cast<double>(table.weight(table.find(feature).value(), 0)) * static_cast<double>(value);
    return sum;
  }
};

TEST(Reranker, ProbabilitiesAreASoftmaxOfWeightedFeatures) {
  Case c;
  std::size_t reranked = 0;
  for (int i = 0; i < 100; ++i) {
    c.draw();
    if (c.decision.ends.size() < 2) continue;
    std::vector<double> want;
    double total = 0;
    for (const End& end : c.decision.ends) total += std::exp(c.score(c.model->reranker, end));
    for (const End& end : c.decision.ends) want.push_back(std::exp(c.score(c.model->reranker, end)) / total);
    Decision chosen = c.decision;
    choose_end(*c.model, c.executor, c.input, {&c.start, 1}, chosen);
    ASSERT_EQ(chosen.ends.size(), want.size());
    for (std::size_t k = 0; k < want.size(); ++k) {
      const auto same = std::find_if(chosen.ends.begin(), chosen.ends.end(),
                                     [&](const End& e) { return e.pose == c.decision.ends[k].pose; });
      ASSERT_NE(same, chosen.ends.end());
      EXPECT_NEAR(same->mass, want[k], 1e-4);
      if (k > 0) {
        EXPECT_GE(chosen.ends[k - 1].mass, chosen.ends[k].mass);
      }
    }
    reranked += chosen.ends.front().pose == c.decision.ends.front().pose ? 0U : 1U;
  }
  EXPECT_GT(reranked, 0U);
}

TEST(Reranker, EvidenceOfAStartIsTheLogarithmOfASum) {
  Case c;
  for (int i = 0; i < testing::scaled(50); ++i) {
    c.draw();
    if (c.decision.ends.empty()) continue;
    double total = 0;
    for (const End& end : c.decision.ends) total += std::exp(c.score(c.model->start_pose_model, end));
    Decision located = c.decision, chosen = c.decision;
    EXPECT_NEAR(choose_and_locate(*c.model, c.executor, c.input, c.start, located), std::log(total), 1e-3);
    choose_end(*c.model, c.executor, c.input, {&c.start, 1}, chosen);
    for (std::size_t k = 0; k < chosen.ends.size(); ++k) {
      EXPECT_EQ(located.ends[k].pose, chosen.ends[k].pose);
      EXPECT_EQ(located.ends[k].mass, chosen.ends[k].mass);
    }
  }
  c.model->start_pose_model = WeightTable(1);
  EXPECT_EQ(choose_and_locate(*c.model, c.executor, c.input, c.start, c.decision), 0.0);
}

// The map seen in a mirror, node by node; a pose and its image have one node.
plan::Map mirrored(const plan::Map& map) {
  std::vector<plan::Node> nodes = map.nodes();
  for (plan::Node& node : nodes) node.x = -node.x;
  return {map.name(), nodes, map.edges(), map.objects(), map.floors(), map.walls()};
}
plan::PoseId image(plan::PoseId pose) { return {pose.index / 4 * 4 + (4 - pose.index % 4) % 4}; }

std::multiset<std::uint64_t> features_of(const RankingModel& model, const Executor& executor,
                                         const SentenceInput& input, plan::PoseId start, const Plan& plan,
                                         bool seen_in_mirror) {
  RerankerSentence sentence(model, input, seen_in_mirror);
  sentence.add_end(executor, start, plan, 0.5);
  std::multiset<std::uint64_t> out;
  const CandidateFeatures features = sentence.take();
  for (const std::uint32_t bundle : features.candidates.front())
    for (const WeightedFeature& feature : features.bundles[bundle]) out.insert(feature.key);
  return out;
}

TEST(RouteFeatures, OfAMirrorImageAreThoseOfTheRouteInTheMirror) {
  Case c;
  const plan::Map glass = mirrored(c.map);
  const Executor behind(glass);
  std::size_t changed = 0, routes = 0;
  for (int i = 0; i < testing::scaled(50); ++i) {
    c.draw();
    SentenceInput said = c.input;
    said.tokens = mirror(said.tokens);
    for (const End& end : c.decision.ends) {
      const Plan& plan = *c.decision.plans[end.candidate];
      Plan there = plan;
      there.end = image(plan.end);
      for (plan::Action& action : there.actions)
        if (action != plan::Action::Forward)
          action = action == plan::Action::Left ? plan::Action::Right : plan::Action::Left;
      const auto got = features_of(*c.model, c.executor, said, c.start, plan, true);
      EXPECT_EQ(got, features_of(*c.model, behind, said, image(c.start), there, false));
      changed += got != features_of(*c.model, c.executor, c.input, c.start, plan, false) ? 1U : 0U;
      ++routes;
    }
  }
  EXPECT_GT(2 * changed, routes);
}

// Where the heading is unknown, a route is looked at from its first move on, but for one property (alone, its words and
// pairs) and what is true at poses.
TEST(RouteFeatures, TurnsThatNobodySpeaksOfAreOneProperty) {
  Case c;
  SentenceInput known{{"chair"}, false}, unknown{{"chair"}, true};
  const auto differing = [&](const SentenceInput& input, plan::PoseId one, plan::PoseId other, const Plan& from_one,
                             const Plan& from_other) {
    const auto a = features_of(*c.model, c.executor, input, one, from_one, false);
    const auto b = features_of(*c.model, c.executor, input, other, from_other, false);
    std::vector<std::uint64_t> out;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
    return out.size();
  };
  std::size_t fewer = 0, tried = 0;
  for (std::uint32_t pose = 0; pose < c.map.poses(); ++pose) {
    const auto moved = c.map.successor({pose}, plan::Action::Forward);
    if (!moved) continue;
    const plan::PoseId left = *c.map.successor({pose}, plan::Action::Right);  // one turn to the left of it is `pose`
    const plan::PoseId right = *c.map.successor({pose}, plan::Action::Left);
    const Plan from_left{*moved, {plan::Action::Left, plan::Action::Forward}},
        from_right{*moved, {plan::Action::Right, plan::Action::Forward}};
    const std::size_t some = differing(known, left, right, from_left, from_right),
                      less = differing(unknown, left, right, from_left, from_right);
    EXPECT_LE(less, some);
    fewer += less < some ? 1U : 0U;
    ++tried;
  }
  EXPECT_EQ(fewer, tried);
}

}  // namespace
}  // namespace waymark::parser
