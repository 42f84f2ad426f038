// The experiment: for each convention one search for programs; for each seed one reader for every one or two maps,
// shared by the folds that need it, and for each map left out a reranker; then the tests. What a run before this one
// has kept is taken from there.
#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>
#include <stdexcept>

#include "libparser/experiment/action_network.hpp"
#include "libparser/experiment/evaluate.hpp"
#include "libparser/experiment/scores_text.hpp"
#include "libparser/experiment/shared_jobs.hpp"
#include "libparser/model_file.hpp"
#include "libparser/supervision/examples.hpp"
#include "libparser/training/learn_reranker.hpp"

namespace waymark::parser {
namespace {

struct HallwayFold : Fold<Scores, Prediction> {  // scores of all members together
  Convention convention;
  std::size_t left_out;                // the number of its map
  std::vector<std::size_t> instances;  // maps that are learned from
  bool scored;                         // by a run before this one
  std::vector<Scores> singles;         // of each member, when there are several
};

class Experiment {
 public:
  Experiment(const Corpus& train, const Corpus& test, std::span<const plan::Map> maps, const EvaluateOptions& options)
      : train_(train), test_(test), maps_(maps), options_(options), executors_(maps.begin(), maps.end()) {}

  Evaluation run() {
    for (Convention convention : {Convention::Absolute, Convention::Relative})
      if (convention == Convention::Absolute ? options_.absolute : options_.relative) prepare(convention);
    if (folds_.empty()) throw std::invalid_argument("leaving one map out needs sentences on at least two maps");
    read();
    const Report report = [&](double fraction, std::string_view what) {
      if (options_.train.progress) options_.train.progress(0.8 + 0.2 * fraction, what);
    };
    run_shared_jobs({.count = folds_.size(),
                     .part = [&](std::size_t i) { return scores_part(folds_[i]); },
                     .run = [&](std::size_t i, const JobProgress& progress) { finish(folds_[i], progress); }},
                    how_to_share(), report, "learning to choose, testing");
    Evaluation evaluation{
        run_folds<Scores, Prediction>(folds_, 1, nullptr, "", [](const HallwayFold&, const JobProgress&) {}), {}, 0};
    for (const HallwayFold& fold : folds_) {
      evaluation.singles.resize(fold.singles.size());
      for (std::size_t i = 0; i < fold.singles.size(); ++i) evaluation.singles[i] += fold.singles[i];
    }
    return evaluation;
  }

 private:
  using Maps = std::vector<std::size_t>;
  struct ReaderKey {
    std::size_t member;  // of the ensemble
    Convention convention;
    Maps maps;
    friend auto operator<=>(const ReaderKey&, const ReaderKey&) = default;
  };

  std::span<const Example> sentences(Convention convention) const {
    return examples_[static_cast<std::size_t>(convention)];
  }

  std::vector<const Example*> on(Convention convention, const Maps& maps) const {
    std::vector<const Example*> out;
    for (const Example& example : sentences(convention))
      if (std::find(maps.begin(), maps.end(), example.map) != maps.end()) out.push_back(&example);
    return out;
  }

  // Which folds and readers there are to be, and what has to be known to learn them.
  void prepare(Convention convention) {
    auto& examples = examples_[static_cast<std::size_t>(convention)];
    examples = make_examples(train_, executors_, convention).sentences;
    for (std::size_t left_out = 0; left_out < maps_.size(); ++left_out) {
      const bool tested = std::any_of(test_.paragraphs.begin(), test_.paragraphs.end(),
                                      [&](const Paragraph& p) { return p.map == maps_[left_out].name(); });
      Maps instances;
      for (std::size_t m = 0; m < maps_.size(); ++m)
        if (m != left_out && !on(convention, {m}).empty()) instances.push_back(m);
      if (!tested || instances.empty()) continue;
      folds_.push_back({{maps_[left_out].name()}, convention, left_out, instances, false, {}});
      if (find_scores(folds_.back())) continue;
      for (std::size_t member = 0; instances.size() > 1 && !options_.actions && member < options_.ensemble; ++member) {
        readers_[{member, convention, instances}];
        if (!options_.train.reranker) continue;
        for (std::size_t m : instances) readers_[{member, convention, without(instances, m)}];
      }
    }
    if (!options_.actions && something_to_learn(convention)) search(examples);
  }

  void search(std::vector<Example>& examples) {
    find_programs(examples, executors_, PostfixGrammar(maps_.front().vocabulary(), options_.train.dialect),
                  options_.train.threads, [&](double) {
                    if (options_.train.progress) options_.train.progress(0, "searching for programs");
                    return !options_.train.stop.stop_requested();
                  });
  }

  // The maps that a reader may know whose answers on map m are to be chosen between.
  static Maps without(const Maps& maps, std::size_t m) {
    Maps others;
    for (std::size_t other : maps)
      if (other != m) others.push_back(other);
    return others;
  }

  TrainOptions options_for(Convention convention, std::size_t member) const {
    TrainOptions options = options_.train;
    options.convention = convention;
    options.seed += member;
    options.threads = 1;  // readers and folds are what runs side by side
    options.progress = nullptr;
    return options;
  }

  std::string part(Convention convention, const std::string& rest) const {
    return options_.system + '-' + std::string(name(convention)) + '-' + rest;
  }

  std::string part(const ReaderKey& key) const {
    std::string maps;
    for (std::size_t m : key.maps) maps += (maps.empty() ? "" : "+") + maps_[m].name();
    return part(key.convention, std::to_string(options_.train.seed + key.member) + '-' + maps + ".reader");
  }

  std::string reranker_part(const HallwayFold& fold, std::size_t member) const {
    return part(fold.convention, std::to_string(options_.train.seed + member) + "-without-" + fold.map + ".reranker");
  }

  std::string scores_part(const HallwayFold& fold) const {
    return part(fold.convention, std::to_string(options_.train.seed) + '-' + std::to_string(options_.ensemble) +
                                     (options_.train.reranker ? "-reranker-" : "-") + fold.map + ".scores");
  }

  bool has(const std::string& name) const { return options_.checkpoints != nullptr && options_.checkpoints->has(name); }

  // What was kept under this name; or what is learned now, as it is found again when it has been kept.
  Grounder kept_or(const std::string& name, const std::function<Grounder()>& learn) const {
    if (options_.checkpoints == nullptr) return learn();
    if (!has(name)) options_.checkpoints->keep(name, serialize(learn(), 0));
    return parse_grounder(*options_.checkpoints->find(name), name);
  }

  bool find_scores(HallwayFold& fold) const {
    const auto kept = options_.checkpoints ? options_.checkpoints->find_text(scores_part(fold)) : std::nullopt;
    if (!kept) return false;
    std::istringstream lines(*kept);
    std::string line;
    for (std::getline(lines, line), fold.scores = scores_of(line, scores_part(fold)); std::getline(lines, line);)
      fold.singles.push_back(scores_of(line, scores_part(fold)));
    return fold.scored = true;
  }

  void keep_scores(const HallwayFold& fold) const {
    if (options_.checkpoints == nullptr) return;
    std::string lines = text_of(fold.scores);
    for (const Scores& single : fold.singles) lines += text_of(single);
    options_.checkpoints->keep_text(scores_part(fold), lines);
  }

  bool something_to_learn(Convention convention) const {
    for (const auto& [key, reader] : readers_)
      if (key.convention == convention && !has(part(key))) return true;
    for (const HallwayFold& fold : folds_)
      for (std::size_t member = 0; member < options_.ensemble; ++member)
        if (fold.convention == convention && !fold.scored && (options_.train.reranker || fold.instances.size() == 1) &&
            !has(reranker_part(fold, member)))
          return true;
    return false;
  }

  // Learns all readers, those with the most maps first.
  void read() {
    std::vector<std::pair<const ReaderKey, Grounder>*> work;
    for (auto& entry : readers_) work.push_back(&entry);
    std::stable_sort(work.begin(), work.end(),
                     [](const auto* a, const auto* b) { return a->first.maps.size() > b->first.maps.size(); });
    const Report report = [&](double fraction, std::string_view what) {
      if (options_.train.progress) options_.train.progress(0.8 * fraction, what);
    };
    const auto learn = [&](std::size_t i, const JobProgress& progress) {
      const ReaderKey& key = work[i]->first;
      work[i]->second = kept_or(part(key), [&] {
        return learn_reader(on(key.convention, key.maps), executors_, options_for(key.convention, key.member),
                            progress);
      });
    };
    run_shared_jobs({.count = work.size(), .part = [&](std::size_t i) { return part(work[i]->first); }, .run = learn},
                    how_to_share(), report, "learning");
  }

  HowToShare how_to_share() const {
    return {.checkpoints = options_.checkpoints, .threads = options_.train.threads, .stop = options_.train.stop};
  }

  void finish(HallwayFold& fold, const JobProgress& progress) {
    if (fold.scored || find_scores(fold)) return;  // maybe by another process meanwhile
    score(fold, progress);
    keep_scores(fold);
  }

  void score(HallwayFold& fold, const JobProgress& progress) {
    HeardSentences heard;
    for (const Example* example : on(fold.convention, fold.instances)) heard.insert(example->input.tokens);
    if (options_.actions) {
      const auto follower = learn_actions(on(fold.convention, fold.instances), executors_,
                                          options_for(fold.convention, 0), [&](double f) { progress(0.9 * f); });
      fold.scores = evaluate(*follower, test_, maps_[fold.left_out], fold.convention, &fold.predictions,
                             options_.train.stop, &heard);
      return;
    }
    std::vector<Grounder> members;
    for (std::size_t member = 0; member < options_.ensemble; ++member) {
      members.push_back(member_of(fold, member));
      progress(0.6 * static_cast<double>(member + 1) / static_cast<double>(options_.ensemble));
    }
    const auto test = [&](std::vector<Grounder> grounders, std::vector<Prediction>* predictions) {
      return evaluate(*follower_of(std::move(grounders), options_), test_, maps_[fold.left_out], fold.convention,
                      predictions, options_.train.stop, &heard);
    };
    if (members.size() > 1)
      for (const Grounder& member : members) fold.singles.push_back(test({member}, nullptr));
    fold.scores = test(std::move(members), &fold.predictions);
  }

  Grounder member_of(const HallwayFold& fold, std::size_t member) const {
    const TrainOptions options = options_for(fold.convention, member);
    if (fold.instances.size() > 1 && !options.reranker) return readers_.at({member, fold.convention, fold.instances});
    return kept_or(reranker_part(fold, member), [&] {
      return fold.instances.size() > 1 ? choosing(fold, member, options)
                                       : train_on(on(fold.convention, fold.instances), executors_, options);
    });
  }

  // The fold's reader and a reranker that learned from readers of fewer maps.
  Grounder choosing(const HallwayFold& fold, std::size_t member, const TrainOptions& options) const {
    RankingInstances instances;
    for (std::size_t m : fold.instances)
      add_ranking_instances(readers_.at({member, fold.convention, without(fold.instances, m)}),
                            on(fold.convention, {m}), executors_, options, instances);
    return with_reranker(readers_.at({member, fold.convention, fold.instances}), instances, executors_, options,
                         [](double) {});
  }

  const Corpus &train_, &test_;
  std::span<const plan::Map> maps_;
  const EvaluateOptions& options_;
  std::vector<Executor> executors_;
  std::vector<Example> examples_[2];  // by convention
  std::map<ReaderKey, Grounder> readers_;
  std::vector<HallwayFold> folds_;
};

}  // namespace

Evaluation evaluate_leave_one_map_out(const Corpus& train, const Corpus* test, std::span<const plan::Map> maps,
                                      const EvaluateOptions& options) {
  if (maps.empty()) throw std::invalid_argument("leaving one map out needs maps");
  const auto begin = std::chrono::steady_clock::now();
  Evaluation evaluation = Experiment(train, test == nullptr ? train : *test, maps, options).run();
  evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return evaluation;
}

}  // namespace waymark::parser
