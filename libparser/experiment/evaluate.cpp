#include "libparser/experiment/evaluate.hpp"

#include <set>

#include "libparser/supervision/examples.hpp"

namespace waymark::parser {
namespace {

using Nodes = std::set<std::uint32_t>;

// Walks from `pose`, which is moved along.
void walk(const plan::Map& map, plan::PoseId& pose, const std::vector<plan::Action>& actions, Nodes& nodes) {
  for (plan::Action action : actions) {
    pose = *map.successor(pose, action);
    nodes.insert(map.node_of(pose));
  }
}

PathScores compared(const plan::Map& map, plan::PoseId start, Nodes want, Nodes got) {
  want.erase(map.node_of(start));
  got.erase(map.node_of(start));
  std::size_t common = 0;
  for (std::uint32_t node : got) common += want.count(node);
  const std::size_t others = map.nodes().size() - 1, wrong = want.size() + got.size() - 2 * common;
  return {{common, got.size()}, {common, want.size()}, {others - wrong, others}};
}

class Test {
 public:
  Test(const Follower& follower, const Executor& executor, Convention convention, std::vector<Prediction>* predictions,
       std::stop_token stop, const HeardSentences* heard)
      : follower_(follower),
        executor_(executor),
        convention_(convention),
        predictions_(predictions),
        stop_(std::move(stop)),
        heard_(heard) {}

  void sentence(const Example& example, const std::string& id) {
    if (stop_.stop_requested()) throw Stopped{};
    Response answer = follower_.follow(executor_, example.input, example.gold.start);
    const Percent right{answer.end == example.gold.end ? 1U : 0U, 1};
    of(scores_.sentence) += right;
    if (heard_ != nullptr && heard_->count(example.input.tokens) == 0) of(scores_.unheard) += right;
    if (follower_.reads_formulas())
      scores_.satisfiable +=
          {!answer.program.empty() && executor_.run(answer.program, example.gold.start) ? 1U : 0U, 1};
    if (convention_ == Convention::Absolute) {
      Nodes want, got;
      plan::PoseId gold = example.gold.start, own = gold;
      walk(map(), gold, example.gold.actions, want);
      walk(map(), own, answer.actions, got);
      scores_.path += compared(map(), example.gold.start, want, got);
    }
    if (predictions_ != nullptr)
      predictions_->push_back(
          {id, map().name(), convention_, example.gold.start, example.gold.end, std::move(answer), {}});
  }

  void paragraph(std::span<const Example> sentences, std::span<const std::string> ids, const std::string& id) {
    plan::PoseId pose = sentences.front().gold.start;
    Nodes want, got;
    std::vector<SentenceInput> inputs;
    for (const Example& sentence : sentences) {
      inputs.push_back(sentence.input);
      plan::PoseId gold = sentence.gold.start;
      walk(map(), gold, sentence.gold.actions, want);
    }
    if (stop_.stop_requested()) throw Stopped{};
    std::size_t k = 0;
    for (Response& answer : follower_.follow_all(executor_, inputs, pose)) {
      const plan::PoseId from = pose;
      walk(map(), pose, answer.actions, got);
      if (predictions_ != nullptr)
        predictions_->push_back(
            {ids[k], map().name(), convention_, from, sentences[k].gold.end, std::move(answer), id});
      ++k;
    }
    of(scores_.paragraph) += {map().node_of(pose) == map().node_of(sentences.back().gold.end) ? 1U : 0U, 1};
    if (convention_ == Convention::Absolute)
      scores_.paragraph_path += compared(map(), sentences.front().gold.start, want, got);
  }

  void skip_paragraph() { scores_.skipped_paragraphs += convention_ == Convention::Absolute ? 1 : 0; }
  const Scores& scores() const { return scores_; }

 private:
  const plan::Map& map() const { return executor_.map(); }

  Percent& of(ConventionScores& scores) const {
    return convention_ == Convention::Absolute ? scores.absolute : scores.relative;
  }

  const Follower& follower_;
  const Executor& executor_;
  Convention convention_;
  std::vector<Prediction>* predictions_;
  std::stop_token stop_;
  const HeardSentences* heard_;
  Scores scores_;
};

}  // namespace

PathScores& PathScores::operator+=(const PathScores& other) {
  precision += other.precision;
  recall += other.recall;
  accuracy += other.accuracy;
  return *this;
}

Scores& Scores::operator+=(const Scores& other) {
  sentence.absolute += other.sentence.absolute;
  sentence.relative += other.sentence.relative;
  paragraph.absolute += other.paragraph.absolute;
  paragraph.relative += other.paragraph.relative;
  unheard.absolute += other.unheard.absolute;
  unheard.relative += other.unheard.relative;
  path += other.path;
  paragraph_path += other.paragraph_path;
  satisfiable += other.satisfiable;
  skipped_paragraphs += other.skipped_paragraphs;
  return *this;
}

Following following(const TrainOptions& options) {
  return {.deciding = {options.beam, options.then, options.trust, options.clauses},
          .paragraph = {.beam_width = options.beam_width}};
}

std::shared_ptr<const Follower> follower_of(std::vector<Grounder> systems, const EvaluateOptions& options) {
  auto reads = std::make_shared<const GroundingFollower>(std::move(systems), following(options.train));
  return options.carried_out ? options.carried_out(std::move(reads)) : std::move(reads);
}

Scores evaluate(const Follower& follower, const Corpus& corpus, const plan::Map& map, Convention convention,
                std::vector<Prediction>* predictions, std::stop_token stop, const HeardSentences* heard) {
  const Executor executor(map);
  const Examples examples = make_examples(corpus, {&executor, 1}, convention);
  Test test(follower, executor, convention, predictions, std::move(stop), heard);
  for (std::size_t i = 0; i < examples.sentences.size(); ++i) test.sentence(examples.sentences[i], examples.ids[i]);
  for (std::size_t begin = 0, end = 0; begin < examples.sentences.size(); begin = end) {
    while (end < examples.sentences.size() && examples.paragraph[end] == examples.paragraph[begin]) ++end;
    test.paragraph(std::span(examples.sentences).subspan(begin, end - begin),
                   std::span(examples.ids).subspan(begin, end - begin),
                   corpus.paragraphs[examples.paragraph[begin]].id);
  }
  for (const Paragraph& paragraph : corpus.paragraphs)
    if (paragraph.map == map.name() && paragraph.sentences.empty()) test.skip_paragraph();
  return test.scores();
}

}  // namespace waymark::parser
