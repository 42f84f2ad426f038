#include "libparser/evaluate.hpp"

#include <algorithm>
#include <set>

#include "libparser/chooser.hpp"
#include "libparser/examples.hpp"

namespace waymark::parser {
namespace {

std::set<std::uint32_t> nodes_walked(const plan::Map& map, plan::PoseId start,
                                     const std::vector<plan::Action>& actions) {
  std::set<std::uint32_t> nodes;
  plan::PoseId pose = start;
  for (plan::Action action : actions) {
    pose = *map.successor(pose, action);
    nodes.insert(map.node_of(pose));
  }
  nodes.erase(map.node_of(start));
  return nodes;
}

void score_path(Scores& scores, const plan::Map& map, const GoldRoute& gold,
                const std::vector<plan::Action>& actions) {
  const auto want = nodes_walked(map, gold.start, gold.actions), got = nodes_walked(map, gold.start, actions);
  std::size_t common = 0;
  for (std::uint32_t node : got) common += want.count(node);
  const std::size_t others = map.nodes().size() - 1, wrong = want.size() + got.size() - 2 * common;
  scores.path_precision += {common, got.size()};
  scores.path_recall += {common, want.size()};
  scores.path_accuracy += {others - wrong, others};
}

class Test {
 public:
  Test(const LinearModel& model, const Executor& executor, Convention convention, const TrainOptions& options)
      : model_(model), executor_(executor), convention_(convention), options_(options) {}

  void sentence(const Example& example) {
    const Answer answer = ask(example.input, example.gold.start);
    of(scores_.sentence) += {answer.end == example.gold.end ? 1U : 0U, 1};
    if (convention_ == Convention::Absolute)
      score_path(scores_, executor_.map(), example.gold, answer.actions);
  }

  void paragraph(std::span<const Example> sentences) {
    plan::PoseId pose = sentences.front().gold.start;
    for (std::size_t i = 0; i < sentences.size(); ++i) {
      SentenceInput input = sentences[i].input;
      input.heading_unknown = input.heading_unknown && i == 0;  // later ones start where we stand
      pose = ask(input, pose).end;
    }
    const plan::Map& map = executor_.map();
    of(scores_.paragraph) += {map.node_of(pose) == map.node_of(sentences.back().gold.end) ? 1U : 0U, 1};
  }

  void skip_paragraph() { scores_.skipped_paragraphs += convention_ == Convention::Absolute ? 1 : 0; }
  const Scores& scores() const { return scores_; }

 private:
  struct Answer {
    plan::PoseId end;
    std::vector<plan::Action> actions;
  };

  Answer ask(const SentenceInput& input, plan::PoseId start) const {
    if (options_.stop.stop_requested()) throw Stopped{};
    Decision decision = decide(model_, executor_, input, {&start, 1}, options_.beam, options_.then);
    choose_end(model_, executor_, input, {&start, 1}, decision);
    if (decision.ends.empty()) return {start, {}};
    const Plan& plan = *decision.plans[decision.ends.front().candidate];
    return {plan.end, plan.actions};
  }

  Percent& of(ConventionScores& scores) const {
    return convention_ == Convention::Absolute ? scores.absolute : scores.relative;
  }

  const LinearModel& model_;
  const Executor& executor_;
  Convention convention_;
  const TrainOptions& options_;
  Scores scores_;
};

}  // namespace

Scores& Scores::operator+=(const Scores& other) {
  sentence.absolute += other.sentence.absolute;
  sentence.relative += other.sentence.relative;
  paragraph.absolute += other.paragraph.absolute;
  paragraph.relative += other.paragraph.relative;
  path_precision += other.path_precision;
  path_recall += other.path_recall;
  path_accuracy += other.path_accuracy;
  skipped_paragraphs += other.skipped_paragraphs;
  return *this;
}

Scores evaluate(const LinearModel& model, const Corpus& corpus, const plan::Map& map, Convention convention,
                const TrainOptions& options) {
  model.check_vocabulary(map.vocabulary(), "map " + map.name());
  const Executor executor(map);
  const Examples examples = make_examples(corpus, {&executor, 1}, convention);
  Test test(model, executor, convention, options);
  for (const Example& example : examples.sentences) test.sentence(example);
  for (std::size_t begin = 0, end = 0; begin < examples.sentences.size(); begin = end) {
    while (end < examples.sentences.size() && examples.paragraph[end] == examples.paragraph[begin]) ++end;
    test.paragraph(std::span(examples.sentences).subspan(begin, end - begin));
  }
  for (const Paragraph& paragraph : corpus.paragraphs)
    if (paragraph.map == map.name() && paragraph.sentences.empty()) test.skip_paragraph();
  return test.scores();
}

}  // namespace waymark::parser
