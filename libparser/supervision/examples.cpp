#include "libparser/supervision/examples.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <stop_token>

#include "libltl/parallel.hpp"
#include "libparser/supervision/constrained_search.hpp"
#include "libparser/supervision/judged_search.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::parser {
namespace {

plan::Trajectory trajectory_of(const std::vector<plan::Pose>& path, const Sentence& sentence, const plan::Map& map) {
  const auto fail = [&] {
    throw std::invalid_argument("sentence " + sentence.id + ": its trajectory is impossible on map " + map.name());
  };
  plan::Trajectory out;
  for (const plan::Pose& at : path) {
    const auto pose = map.find(at);
    if (!pose) fail();
    if (!out.poses.empty()) {
      const auto action = plan::action_between(map, out.poses.back(), *pose);
      if (!action) fail();
      out.actions.push_back(*action);
    }
    out.poses.push_back(*pose);
  }
  return out;
}

// The gold route is judged, too, where others are and its heading is known.
Judged judged_of(const Sentence& sentence, const plan::Trajectory& gold, const plan::Map& map) {
  Judged out;
  for (const auto& path : sentence.also_good) out.good.push_back(trajectory_of(path, sentence, map));
  for (const auto& path : sentence.refused) out.refused.push_back(trajectory_of(path, sentence, map));
  if (!out.empty() && !sentence.heading_unknown) out.good.push_back(gold);
  return out;
}

}  // namespace

WordTable words_met_twice(std::span<const Example* const> examples) {
  std::map<std::string, int> counts;
  WordTable words;
  for (const char* side : {"left", "right"}) words.add(side);
  for (const Example* example : examples)
    for (const std::string& word : example->input.tokens)
      if (++counts[word] == 2) words.add(word);
  return words;
}

Examples make_examples(const Corpus& corpus, std::span<const Executor> executors, Convention convention) {
  Examples examples;
  for (std::size_t i = 0; i < corpus.paragraphs.size(); ++i) {
    const Paragraph& paragraph = corpus.paragraphs[i];
    std::size_t m = 0;
    while (m < executors.size() && executors[m].map().name() != paragraph.map) ++m;
    if (m == executors.size()) continue;
    for (std::size_t k = 0; k < paragraph.sentences.size(); ++k) {
      const Sentence& sentence = paragraph.sentences[k];
      if (sentence.path(convention).empty()) continue;
      const plan::Map& map = executors[m].map();
      plan::Trajectory gold = trajectory_of(sentence.path(convention), sentence, map);
      Judged judged = judged_of(sentence, gold, map);
      examples.sentences.push_back(
          {{sentence.tokens, sentence.heading_unknown},
           m,
           {gold.poses.front(), gold.poses.back(), std::move(gold.actions), sentence.heading_unknown},
           nullptr,
           i,
           k,
           std::move(judged)});
      examples.paragraph.push_back(i);
      examples.ids.push_back(sentence.id);
    }
  }
  return examples;
}

namespace {

// do_one(i, thread) for i < n on so many threads; go_on(share done) is asked on the first.
template <class DoOne>
void share_out(std::size_t n, std::size_t threads, const std::function<bool(double fraction)>& go_on,
               const DoOne& do_one) {
  std::stop_source stop;
  const auto run = [&](std::size_t i, std::size_t thread) {
    do_one(i, thread);
    if (thread == 0 && !go_on(static_cast<double>(i) / static_cast<double>(n))) stop.request_stop();
  };
  ltl::parallel_for(n, threads, run, stop.get_token());
  if (stop.stop_requested()) throw Stopped{};
}

// In the temporal dialect a sentence also has programs of its own.
void add_said_programs(std::span<Example> examples, std::span<const Executor> executors, std::size_t threads,
                       const std::function<bool(double fraction)>& go_on) {
  const ProgramLanguage language(executors.front().map().vocabulary(), Dialect::Temporal);
  std::vector<std::vector<UnitPlans>> plans(threads, std::vector<UnitPlans>(executors.size()));
  share_out(examples.size(), threads, go_on, [&](std::size_t i, std::size_t thread) {
    Example& example = examples[i];
    const Executor& executor = executors[example.map];
    std::vector<Consistent> all =
        example.judged.empty()
            ? said_programs(executor, language, example.gold, example.input.tokens, plans[thread][example.map])
            : judged_programs(executor, language, example.gold, example.input.tokens, example.judged);
    if (all.empty() || example.judged.empty())
      all.insert(all.end(), example.programs->begin(), example.programs->end());
    example.programs = std::make_shared<const std::vector<Consistent>>(std::move(all));
  });
}

// Its programs that no judged trajectory refutes.
std::shared_ptr<const std::vector<Consistent>> agreeing(const Example& example, const Executor& executor) {
  std::vector<Consistent> out;
  for (const Consistent& one : *example.programs)
    if (agrees(executor, one.program, example.judged)) out.push_back(one);
  return std::make_shared<const std::vector<Consistent>>(std::move(out));
}

}  // namespace

void find_programs(std::span<Example> examples, std::span<const Executor> executors, const PostfixGrammar& grammar,
                   int threads, const std::function<bool(double fraction)>& go_on) {
  std::map<std::pair<std::size_t, GoldRoute>, std::shared_ptr<std::vector<Consistent>>> routes;
  for (Example& example : examples) {
    auto& programs = routes[{example.map, example.gold}];
    if (!programs) programs = std::make_shared<std::vector<Consistent>>();
    example.programs = programs;
  }
  std::vector<std::pair<const std::pair<std::size_t, GoldRoute>*, std::vector<Consistent>*>> work;
  for (auto& [route, programs] : routes) work.emplace_back(&route, programs.get());
  const auto most = static_cast<std::size_t>(std::max(threads, 1));
  share_out(work.size(), most, go_on, [&](std::size_t i, std::size_t) {
    *work[i].second = consistent_programs(executors[work[i].first->first], grammar, work[i].first->second);
  });
  for (Example& example : examples)
    if (!example.judged.empty()) example.programs = agreeing(example, executors[example.map]);
  if (grammar.limits().dialect == Dialect::Temporal) add_said_programs(examples, executors, most, go_on);
}

}  // namespace waymark::parser
