// The experiment: one model per (convention, map left out), all of them from one search for programs per convention.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "libparser/evaluate.hpp"
#include "libparser/examples.hpp"

namespace waymark::parser {
namespace {

struct Job {
  Convention convention;
  std::size_t map;  // left out
  Scores scores;
  std::exception_ptr error;
};

// Runs jobs on several threads; only the calling thread reports progress.
class Experiment {
 public:
  Experiment(const Corpus& train, const Corpus& test, std::span<const plan::Map> maps,
             const EvaluateOptions& options)
      : train_(train), test_(test), maps_(maps), options_(options), executors_(maps.begin(), maps.end()) {}

  std::vector<Job> run() {
    const PostfixGrammar grammar(maps_.front().vocabulary());
    for (Convention convention : {Convention::Absolute, Convention::Relative}) {
      if (!(convention == Convention::Absolute ? options_.absolute : options_.relative)) continue;
      auto& sentences = examples_[static_cast<std::size_t>(convention)];
      sentences = make_examples(train_, executors_, convention).sentences;
      find_programs(sentences, executors_, grammar, options_.train.threads,
                    [&](double) { return report(0, "searching for programs"); });
      for (std::size_t m = 0; m < maps_.size(); ++m)
        if (can_leave_out(sentences, m)) jobs_.push_back({convention, m, {}, nullptr});
    }
    if (jobs_.empty())
      throw std::invalid_argument("leaving one map out needs sentences on at least two maps");
    done_.assign(jobs_.size(), 0.0);
    run_all();
    for (const Job& job : jobs_)
      if (job.error) std::rethrow_exception(job.error);
    return std::move(jobs_);
  }

 private:
  bool can_leave_out(std::span<const Example> sentences, std::size_t map) const {
    const bool tested = std::any_of(test_.paragraphs.begin(), test_.paragraphs.end(),
                                    [&](const Paragraph& p) { return p.map == maps_[map].name(); });
    return tested &&
           std::any_of(sentences.begin(), sentences.end(), [&](const Example& e) { return e.map != map; });
  }

  bool report(double fraction, std::string_view what) const {
    if (options_.train.progress && std::this_thread::get_id() == caller_)
      options_.train.progress(fraction, what);
    return !options_.train.stop.stop_requested();
  }

  double progress(std::size_t job, double fraction) {
    const std::lock_guard lock(mutex_);
    done_[job] = std::max(done_[job], fraction);
    double sum = 0;
    for (double part : done_) sum += part;
    return highest_ = std::max(highest_, sum / static_cast<double>(done_.size()));
  }

  void run_all() {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < jobs_.size(); i = next++) {
        try {
          run_one(i);
        } catch (...) {
          jobs_[i].error = std::current_exception();
        }
      }
    };
    std::vector<std::jthread> helpers;
    for (int t = 1; t < options_.train.threads; ++t) helpers.emplace_back(work);
    work();
  }

  void run_one(std::size_t i) {
    Job& job = jobs_[i];
    TrainOptions options = options_.train;
    options.convention = job.convention;
    options.threads = 1;
    options.progress = [&](double fraction, std::string_view) {
      report(progress(i, 0.9 * fraction), "training and testing, one map left out");
    };
    std::vector<const Example*> lessons;
    for (const Example& example : examples_[static_cast<std::size_t>(job.convention)])
      if (example.map != job.map) lessons.push_back(&example);
    const LinearModel model = train_on(lessons, executors_, options);
    job.scores = evaluate(model, test_, maps_[job.map], job.convention, options);
    report(progress(i, 1.0), "training and testing, one map left out");
  }

  const Corpus &train_, &test_;
  std::span<const plan::Map> maps_;
  const EvaluateOptions& options_;
  std::vector<Executor> executors_;
  std::vector<Example> examples_[2];  // by convention
  std::vector<Job> jobs_;
  std::vector<double> done_;
  double highest_ = 0;
  std::mutex mutex_;
  const std::thread::id caller_ = std::this_thread::get_id();
};

}  // namespace

Evaluation evaluate_leave_one_map_out(const Corpus& train, const Corpus* test,
                                      std::span<const plan::Map> maps, const EvaluateOptions& options) {
  if (maps.empty()) throw std::invalid_argument("leaving one map out needs maps");
  const auto begin = std::chrono::steady_clock::now();
  Evaluation evaluation;
  for (const Job& job : Experiment(train, test == nullptr ? train : *test, maps, options).run()) {
    evaluation.folds[maps[job.map].name()] += job.scores;
    evaluation.all += job.scores;
  }
  evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return evaluation;
}

}  // namespace waymark::parser
