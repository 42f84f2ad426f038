// The experiment: for each convention one search for programs; for each seed one reader for every one or two maps,
// shared by the folds that need it, and for each map left out a chooser; then the tests.
#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>

#include "libparser/evaluate.hpp"
#include "libparser/examples.hpp"
#include "libparser/learn_chooser.hpp"
#include "libparser/neural/action_network.hpp"

namespace waymark::parser {
namespace {

struct Fold {
  Convention convention;
  std::size_t map;                   // left out
  std::vector<std::size_t> lessons;  // maps that are learned from
  Scores scores;                     // of all members together
  std::vector<Scores> singles;       // of each, when there are several
  std::vector<Prediction> predictions;
};

class Experiment {
 public:
  Experiment(const Corpus& train, const Corpus& test, std::span<const plan::Map> maps,
             const EvaluateOptions& options)
      : train_(train), test_(test), maps_(maps), options_(options), executors_(maps.begin(), maps.end()) {}

  std::vector<Fold> run() {
    for (Convention convention : {Convention::Absolute, Convention::Relative})
      if (convention == Convention::Absolute ? options_.absolute : options_.relative) prepare(convention);
    if (folds_.empty())
      throw std::invalid_argument("leaving one map out needs sentences on at least two maps");
    read();
    const Report report = [&](double fraction, std::string_view what) {
      if (options_.train.progress) options_.train.progress(0.8 + 0.2 * fraction, what);
    };
    run_jobs(folds_.size(), options_.train.threads, report, "learning to choose, testing",
             [&](std::size_t i, const JobProgress& progress) { finish(folds_[i], progress); });
    return std::move(folds_);
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

  // Finds the programs, and which folds and readers there are to be.
  void prepare(Convention convention) {
    auto& examples = examples_[static_cast<std::size_t>(convention)];
    examples = make_examples(train_, executors_, convention).sentences;
    if (!options_.actions)
      find_programs(examples, executors_, PostfixGrammar(maps_.front().vocabulary()), options_.train.threads,
                    [&](double) {
                      if (options_.train.progress) options_.train.progress(0, "searching for programs");
                      return !options_.train.stop.stop_requested();
                    });
    for (std::size_t left_out = 0; left_out < maps_.size(); ++left_out) {
      const bool tested = std::any_of(test_.paragraphs.begin(), test_.paragraphs.end(),
                                      [&](const Paragraph& p) { return p.map == maps_[left_out].name(); });
      Maps lessons;
      for (std::size_t m = 0; m < maps_.size(); ++m)
        if (m != left_out && !on(convention, {m}).empty()) lessons.push_back(m);
      if (!tested || lessons.empty()) continue;
      for (std::size_t member = 0; lessons.size() > 1 && !options_.actions && member < options_.ensemble;
           ++member) {
        readers_[{member, convention, lessons}];
        if (!options_.train.chooser) continue;
        for (std::size_t m : lessons) readers_[{member, convention, without(lessons, m)}];
      }
      folds_.push_back({convention, left_out, lessons, {}, {}, {}});
    }
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

  // Learns all readers, those with the most maps first.
  void read() {
    std::vector<std::pair<const ReaderKey, Grounder>*> work;
    for (auto& entry : readers_) work.push_back(&entry);
    std::stable_sort(work.begin(), work.end(), [](const auto* a, const auto* b) {
      return a->first.maps.size() > b->first.maps.size();
    });
    const Report report = [&](double fraction, std::string_view what) {
      if (options_.train.progress) options_.train.progress(0.8 * fraction, what);
    };
    run_jobs(work.size(), options_.train.threads, report, "learning",
             [&](std::size_t i, const JobProgress& progress) {
               const auto& [member, convention, maps] = work[i]->first;
               work[i]->second =
                   learn_reader(on(convention, maps), executors_, options_for(convention, member), progress);
             });
  }

  void finish(Fold& fold, const JobProgress& progress) {
    if (options_.actions) {
      const auto follower =
          learn_actions(on(fold.convention, fold.lessons), executors_, options_for(fold.convention, 0),
                        [&](double f) { progress(0.9 * f); });
      fold.scores = evaluate(*follower, test_, maps_[fold.map], fold.convention, &fold.predictions,
                             options_.train.stop);
      return;
    }
    std::vector<Grounder> members;
    for (std::size_t member = 0; member < options_.ensemble; ++member) {
      const TrainOptions options = options_for(fold.convention, member);
      members.push_back(fold.lessons.size() > 1
                            ? choosing(fold, member, options)
                            : train_on(on(fold.convention, fold.lessons), executors_, options));
      progress(0.6 * static_cast<double>(member + 1) / static_cast<double>(options_.ensemble));
    }
    const Deciding how{options_.train.beam, options_.train.then, options_.train.trust};
    const auto test = [&](std::vector<Grounder> grounders, std::vector<Prediction>* predictions) {
      return evaluate(GroundingFollower(std::move(grounders), how), test_, maps_[fold.map], fold.convention,
                      predictions, options_.train.stop);
    };
    if (members.size() > 1)
      for (const Grounder& member : members) fold.singles.push_back(test({member}, nullptr));
    fold.scores = test(std::move(members), &fold.predictions);
  }

  // The fold's reader and a chooser that learned from readers of fewer maps.
  Grounder choosing(const Fold& fold, std::size_t member, const TrainOptions& options) const {
    const Grounder& own = readers_.at({member, fold.convention, fold.lessons});
    if (!options.chooser) return own;
    std::vector<Dilemma> dilemmas;
    for (std::size_t m : fold.lessons) {
      const Grounder& reader = readers_.at({member, fold.convention, without(fold.lessons, m)});
      for (Dilemma& dilemma : dilemmas_of(reader, on(fold.convention, {m}), executors_, options))
        dilemmas.push_back(std::move(dilemma));
    }
    std::vector<const Dilemma*> all;
    for (const Dilemma& dilemma : dilemmas) all.push_back(&dilemma);
    return with_chooser(own, all, executors_, options, [](double) {});
  }

  const Corpus &train_, &test_;
  std::span<const plan::Map> maps_;
  const EvaluateOptions& options_;
  std::vector<Executor> executors_;
  std::vector<Example> examples_[2];  // by convention
  std::map<ReaderKey, Grounder> readers_;
  std::vector<Fold> folds_;
};

}  // namespace

Evaluation evaluate_leave_one_map_out(const Corpus& train, const Corpus* test,
                                      std::span<const plan::Map> maps, const EvaluateOptions& options) {
  if (maps.empty()) throw std::invalid_argument("leaving one map out needs maps");
  const auto begin = std::chrono::steady_clock::now();
  Evaluation evaluation;
  for (const Fold& fold : Experiment(train, test == nullptr ? train : *test, maps, options).run()) {
    evaluation.folds[maps[fold.map].name()] += fold.scores;
    evaluation.all += fold.scores;
    evaluation.singles.resize(fold.singles.size());
    for (std::size_t i = 0; i < fold.singles.size(); ++i) evaluation.singles[i] += fold.singles[i];
    evaluation.predictions.insert(evaluation.predictions.end(), fold.predictions.begin(),
                                  fold.predictions.end());
  }
  evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return evaluation;
}

}  // namespace waymark::parser
