// waymark evaluate: corpus → accuracy, leaving one map out.
#include <CLI/App.hpp>
#include <iomanip>
#include <iostream>
#include <memory>

#include "libparser/evaluate.hpp"
#include "libparser/sail_corpus.hpp"
#include "libparser/streets/street_corpus.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/streets.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

using parser::Percent;

struct Options {
  std::string corpus, test_corpus, predictions, model = "linear", data;
  parser::TrainOptions train;
  bool leave_one_map_out = false, train_all = false, json = false;
};

Json json_of(const parser::ConventionScores& scores) {
  return JsonObject().add("absolute", scores.absolute.value()).add("relative", scores.relative.value());
}

JsonObject& add(JsonObject& json, const parser::Scores& scores) {
  return json.add("sentence", json_of(scores.sentence))
      .add("paragraph", json_of(scores.paragraph))
      .add("path", JsonObject()
                       .add("precision", scores.path_precision.value())
                       .add("recall", scores.path_recall.value())
                       .add("accuracy", scores.path_accuracy.value()))
      .add("n", JsonObject()
                    .add("sentences", scores.sentence.absolute.total)
                    .add("paragraphs", scores.paragraph.absolute.total)
                    .add("unsegmented_paragraphs_skipped", scores.skipped_paragraphs));
}

Json json_of(const parser::Evaluation& evaluation) {
  JsonObject folds, json;
  for (const auto& [map, scores] : evaluation.folds) {
    JsonObject fold;
    folds.add(map, add(fold, scores));
  }
  json.add("folds", folds);
  return add(json, evaluation.all).add("seconds", evaluation.seconds);
}

void print_row(const std::string& name, const parser::Scores& scores) {
  const auto cell = [](const Percent& percent) {
    std::cout << std::setw(10) << (percent.total == 0 ? "-" : fixed(percent.value(), 2));
  };
  std::cout << std::left << std::setw(10) << name << std::right;
  cell(scores.sentence.absolute), cell(scores.sentence.relative);
  cell(scores.paragraph.absolute), cell(scores.paragraph.relative);
  cell(scores.path_precision), cell(scores.path_recall), cell(scores.path_accuracy);
  std::cout << std::setw(11) << scores.sentence.absolute.total << std::setw(12)
            << scores.paragraph.absolute.total << '\n';
}

void print_table(const parser::Evaluation& evaluation) {
  std::cout << "per cent; the unknown start heading is north (absolute) or 90 degrees left of the first "
               "known one (relative);\n"
               "path scores are under the absolute convention\n\n"
            << "               sentence            paragraph                  path\n"
            << "left out    absolute  relative  absolute  relative precision    recall  accuracy  sentences  "
               "paragraphs\n";
  for (const auto& [map, scores] : evaluation.folds) print_row(map, scores);
  print_row("all", evaluation.all);
  std::cout << "\nunsegmented paragraphs skipped: " << evaluation.all.skipped_paragraphs << "; "
            << fixed(evaluation.seconds, 1) << " s of training and testing\n";
}

ExitCode run_on_streets(const Options& options, const Session& session) {
  if (options.leave_one_map_out == options.train_all)
    throw UsageError("say what is held out: --leave-one-map-out, or --train-all with --test-corpus");
  if (options.train_all && options.test_corpus.empty())
    throw UsageError("--train-all asks for --test-corpus");
  StreetExperiment experiment{options.corpus,
                              options.test_corpus,
                              options.predictions,
                              options.train_all,
                              options.json,
                              options.train.threads,
                              {}};
  experiment.options.seed = options.train.seed;
  return evaluate_streets(experiment, session);
}

ExitCode run_evaluate(const Options& options, const Session& session) {
  if (streets::is_street_corpus(options.corpus)) return run_on_streets(options, session);
  if (!options.leave_one_map_out)
    throw UsageError("say what is held out: --leave-one-map-out is the only experiment there is so far");
  const parser::Corpus corpus = parser::read_sail_corpus(options.corpus);
  std::optional<parser::Corpus> test;
  if (!options.test_corpus.empty()) test = parser::read_sail_corpus(options.test_corpus);
  parser::EvaluateOptions evaluate;
  evaluate.train = options.train;
  evaluate.train.stop = session.stop;
  ProgressBar bar;
  evaluate.train.progress = [&](double fraction, std::string_view what) { bar.show(fraction, what); };
  std::optional<parser::Evaluation> evaluation;
  try {
    evaluation = parser::evaluate_leave_one_map_out(corpus, test ? &*test : nullptr,
                                                    maps_of(corpus, options.data), evaluate);
  } catch (const parser::Stopped&) {
    throw Interrupted();
  }
  bar.wipe();
  if (options.json)
    std::cout << json_of(*evaluation).text() << '\n';
  else
    print_table(*evaluation);
  return ExitCode::Done;
}

}  // namespace

Runner setup_evaluate(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  command
      .add_option("--corpus", options->corpus,
                  "directory with instructions.jsonl and, if it has its own, maps/")
      ->type_name("DIR")
      ->required();
  command
      .add_option("--test-corpus", options->test_corpus, "take the sentences to test on from here instead")
      ->type_name("DIR");
  command.add_flag("--leave-one-map-out", options->leave_one_map_out,
                   "train on all maps but one, test on that one, for each map");
  command.add_flag("--train-all", options->train_all, "train on every map, test on those of --test-corpus");
  command
      .add_option("--predictions", options->predictions, "write every answer there, one JSON object a line")
      ->type_name("FILE");
  add_model_kind_option(command, options->model);
  add_data_option(command, options->data);
  add_training_options(command, options->train);
  command.add_flag("--json", options->json, "one JSON object");
  return [options](const Session& session) { return run_evaluate(*options, session); };
}

}  // namespace waymark::tools
