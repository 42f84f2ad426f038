// waymark evaluate: corpus → accuracy, leaving one map out.
#include <algorithm>
#include <iostream>
#include <memory>

#include "libltl/text/print.hpp"
#include "libparser/domain/streets/street_corpus.hpp"
#include "libparser/experiment/evaluate.hpp"
#include "libparser/experiment/learned/learned_follower.hpp"
#include "tools/evaluate_commands.hpp"
#include "tools/formula_table.hpp"
#include "tools/shell/learning.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/results_table.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/streets.hpp"

namespace waymark::tools {
namespace {

struct EvaluateCommandOptions {
  std::string corpus, test_corpus, data, predictions, paragraph_predictions, convention = "both";
  TrainingOptions training;
  PairsExperiment pairs;  // instead of a corpus
  std::size_t ensemble = 1;
  CommandsRequest commands;
  std::string planner = "exact";
  parser::LearnedExecution dqn;
  bool leave_one_map_out = false, train_all = false, json = false;
};

Json evaluation_json(const parser::Evaluation& evaluation, const parser::Scores& staying,
                     const parser::FormulaScores& formulas, bool tell_place_numbers) {
  JsonObject folds, json;
  for (const auto& [map, scores] : evaluation.folds) {
    JsonObject fold;
    folds.add(map, add_scores(fold, scores));
  }
  json.add("folds", folds);
  add_scores(json, evaluation.all);
  if (!evaluation.singles.empty()) {
    JsonArray singles;
    for (const parser::Scores& scores : evaluation.singles) {
      JsonObject single;
      singles.add(add_scores(single, scores));
    }
    json.add("singles", singles);
  }
  json.add("place_numbers", told_or_hidden(tell_place_numbers));
  if (formulas.all.same.total > 0) json.add("formulas", formulas_json(formulas));
  JsonObject stays;
  json.add("staying", add_scores(stays, staying)).add("published", published_results());
  return json.add("seconds", evaluation.seconds);
}

// One object a line, so that anyone can score the answers again: those to sentences by themselves, or in their
// paragraphs.
void write_predictions(const std::string& file, bool in_paragraphs, const parser::Evaluation& evaluation,
                       std::span<const plan::Map> maps) {
  if (file.empty()) return;
  std::string lines;
  for (const parser::Prediction& prediction : evaluation.predictions) {
    if (prediction.paragraph.has_value() != in_paragraphs) continue;
    const plan::Map& map =
        *std::find_if(maps.begin(), maps.end(), [&](const plan::Map& m) { return m.name() == prediction.map; });
    ltl::Arena arena(map.vocabulary());
    const auto pose = [&](plan::PoseId p) {
      const plan::Pose at = map.pose(p);
      return JsonArray().add(at.x).add(at.y).add(at.heading);
    };
    JsonObject line;
    if (in_paragraphs) line.add("paragraph", *prediction.paragraph);
    line.add("id", prediction.id)
        .add("map", prediction.map)
        .add("convention", std::string(parser::name(prediction.convention)))
        .add("start", pose(prediction.start));
    if (!prediction.answer.program.empty())
      line.add("formula", ltl::print(parser::formula_of(prediction.answer.program, arena)));
    line.add("probability", prediction.answer.probability)
        .add("end", pose(prediction.answer.end))
        .add("gold_end", pose(prediction.gold_end));
    lines += line.text() + '\n';
  }
  write_file(file, lines);
}

void print_table(const parser::Evaluation& evaluation, const parser::Scores& staying,
                 const parser::FormulaScores& formulas, bool tell_place_numbers) {
  std::vector<ResultRow> rows;
  for (const auto& [map, scores] : evaluation.folds) rows.push_back({map, {scores}});
  rows.push_back({"all", {evaluation.all}});
  for (std::size_t i = 0; i < evaluation.singles.size(); ++i)
    rows.push_back({"single " + std::to_string(i + 1), {evaluation.singles[i]}});
  if (evaluation.singles.size() > 1) rows.push_back({"singles, mean", evaluation.singles});
  rows.push_back({"who stays put", {staying}});
  print_results("left out", rows);
  if (formulas.all.same.total == 0) print_published_results();  // they are for a corpus without formulas
  std::cout << "\nnumbers of places " << told_or_hidden(tell_place_numbers)
            << "; unsegmented paragraphs skipped: " << evaluation.all.skipped_paragraphs << "; "
            << fixed(evaluation.seconds, 1) << " s of training and testing\n";
  print_formulas(formulas);
}

void print_scores(const parser::Evaluation& evaluation, const parser::Corpus& test, std::span<const plan::Map> maps,
                  const parser::EvaluateOptions& evaluate, const EvaluateCommandOptions& options) {
  const parser::Scores staying = scores_of_staying(test, maps, evaluate.absolute, evaluate.relative);
  const parser::FormulaScores formulas = parser::formula_scores(evaluation.predictions, test, maps, evaluate.absolute);
  const bool told = options.training.tell_place_numbers;
  if (options.json)
    std::cout << evaluation_json(evaluation, staying, formulas, told).text() << '\n';
  else
    print_table(evaluation, staying, formulas, told);
}

void check_what_is_held_out(const EvaluateCommandOptions& options) {
  if (options.corpus.empty()) throw UsageError("evaluate asks for --corpus, or for --pairs");
  if (!options.leave_one_map_out && !options.train_all)
    throw UsageError("say what is held out: --leave-one-map-out, or --train-all with --test-corpus");
  if (options.train_all && options.test_corpus.empty()) throw UsageError("--train-all asks for --test-corpus");
  if (!options.pairs.model.file.empty())
    throw UsageError("--model-file is scored by --pairs; what --corpus tests is learned first");
  if (options.training.model != "actions") return;
  if (options.ensemble > 1) throw UsageError("--ensemble is for readers of formulas, not for actions");
  if (options.planner != "exact") throw UsageError("--planner is for readers of formulas, not for actions");
}

ExitCode run_on_streets(const EvaluateCommandOptions& options, const Session& session) {
  StreetExperiment experiment{options.corpus,
                              options.test_corpus,
                              options.predictions,
                              options.train_all,
                              options.json,
                              options.training.train.threads,
                              {}};
  experiment.options.ranker.seed = options.training.train.seed;
  return evaluate_streets(experiment, session);
}

ExitCode run_evaluate(const EvaluateCommandOptions& options, const Session& session) {
  if (!options.pairs.pairs.empty())
    return evaluate_pairs(
        {options.pairs.pairs, options.pairs.model, options.data, options.json, options.training.train.clauses},
        session);
  check_what_is_held_out(options);
  if (streets::is_street_corpus(options.corpus)) return run_on_streets(options, session);
  const parser::Corpus corpus = read_hallway_corpus(options.corpus, options.training.tell_place_numbers);
  std::optional<parser::Corpus> test;
  if (!options.test_corpus.empty())
    test = read_hallway_corpus(options.test_corpus, options.training.tell_place_numbers);
  parser::EvaluateOptions evaluate;
  evaluate.train = options.training.settled();
  evaluate.ensemble = options.ensemble;
  evaluate.actions = options.training.model == "actions";
  evaluate.absolute = options.convention != "relative";
  evaluate.relative = options.convention != "absolute";
  evaluate.train.stop = session.stop;
  if (options.planner == "dqn")
    evaluate.carried_out = [&](std::shared_ptr<const parser::Follower> reads) {
      return std::make_shared<const parser::LearnedFollower>(std::move(reads), options.dqn);
    };
  ProgressBar bar;
  evaluate.train.progress = [&](double fraction, std::string_view what) { bar.show(fraction, what); };
  const std::vector<plan::Map> maps = maps_of(corpus, options.data);
  const std::vector<plan::Map> test_maps = options.train_all ? maps_of(*test, options.data) : maps;
  const parser::Evaluation evaluation = learn_from(options.corpus, [&] {
    return options.train_all ? parser::evaluate_train_all(corpus, maps, *test, test_maps, evaluate)
                             : parser::evaluate_leave_one_map_out(corpus, test ? &*test : nullptr, maps, evaluate);
  });
  bar.wipe();
  write_predictions(options.predictions, false, evaluation, test_maps);
  write_predictions(options.paragraph_predictions, true, evaluation, test_maps);
  print_scores(evaluation, test ? *test : corpus, test_maps, evaluate, options);
  return ExitCode::Done;
}

}  // namespace

Runner setup_evaluate(Command command) {
  const auto options = std::make_shared<EvaluateCommandOptions>();
  add_corpus_option(command, options->corpus, false);
  command
      .add_option("--pairs", options->pairs.pairs,
                  "score the formulas that a model reads against lines 'sentence TAB formula' instead")
      .type_name("FILE");
  add_model_options(command, options->pairs.model);
  command.add_option("--test-corpus", options->test_corpus, "take the sentences to test on from here instead")
      .type_name("DIR");
  command.add_flag("--leave-one-map-out", options->leave_one_map_out,
                   "train on all maps but one, test on that one, for each map");
  command.add_flag("--train-all", options->train_all, "train on every map, test on those of --test-corpus");
  add_data_option(command, options->data);
  add_training_options(command, options->training, {"linear", "encoder-decoder", "actions"});
  add_convention_option(command, options->convention, {"absolute", "relative", "both"});
  command.add_option("--ensemble", options->ensemble, "systems of seeds N, N + 1, … that vote")
      .type_name("COUNT")
      .between(1, 100)
      .show_default();
  command
      .add_option("--planner", options->planner,
                  "what carries formulas out: exact (the default), or dqn, learned anew for each of them")
      .type_name("KIND")
      .one_of({"exact", "dqn"});
  command.add_option("--dqn-steps", options->dqn.steps, "in the environment, for each formula that dqn learns")
      .type_name("N")
      .between(100, 10000000)
      .show_default();
  command.add_option("--predictions", options->predictions, "write what was answered to every sentence, as JSON Lines")
      .type_name("FILE");
  command
      .add_option("--paragraph-predictions", options->paragraph_predictions,
                  "the same of sentences in their paragraphs, each from where the one before it had ended")
      .type_name("FILE");
  command.in("Output").add_flag("--json", options->json, "one JSON object");
  add_commands_request(command, options->commands);
  return [options](const Session& session) {
    if (options->commands.training.files.empty() && options->commands.tests.empty())
      return run_evaluate(*options, session);
    CommandsRequest request = options->commands;
    request.model_file = options->pairs.model.file;
    request.data = options->data;
    request.seed = options->training.train.seed;
    request.json = options->json;
    return evaluate_commands(request, session);
  };
}

}  // namespace waymark::tools
