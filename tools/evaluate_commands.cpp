#include "tools/evaluate_commands.hpp"

#include <cmath>
#include <iostream>

#include "libparser/model_file.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/learning.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

std::set<std::string> ids_of(const std::string& fold) {
  const auto ids = parser::read_fold(fold);
  return {ids.begin(), ids.end()};
}

void add_to(parser::CommandScore& sum, const parser::CommandScore& more) {
  sum.n += more.n;
  sum.exact += more.exact;
  sum.equivalent += more.equivalent;
  sum.refused += more.refused;
}

JsonObject json_of(const parser::CommandScore& score) {
  return JsonObject()
      .add("accuracy", score.percent(score.equivalent))
      .add("exact", score.percent(score.exact))
      .add("equivalent", score.percent(score.equivalent))
      .add("right", score.percent(score.equivalent))
      .add("refused", score.percent(score.refused))
      .add("wrong", score.percent(score.wrong()))
      .add("n", score.n);
}

JsonObject json_of(const std::map<std::string, parser::CommandScore>& scores) {
  JsonObject json;
  for (const auto& [name, score] : scores) json.add(name, json_of(score));
  return json;
}

JsonObject json_of(const parser::Calibration& calibration) {
  JsonArray bins;
  for (const auto& bin : calibration.bins) {
    const auto n = static_cast<double>(bin.n);
    bins.add(JsonObject()
                 .add("n", bin.n)
                 .add("probability", bin.n > 0 ? Json(bin.probability / n) : Json())
                 .add("right", bin.n > 0 ? Json(static_cast<double>(bin.right) / n) : Json()));
  }
  return JsonObject().add("expected_error", calibration.expected_error()).add("bins", bins);
}

struct Total {
  parser::CommandScore all;
  std::map<std::string, parser::CommandScore> by_type, by_domain;
  std::vector<std::pair<std::string, double>> folds;  // accuracy of each
  parser::Calibration calibration;
  std::string lines;  // what was answered

  void add(const std::string& fold, const parser::CommandScores& scores) {
    add_to(all, scores.all);
    for (const auto& [name, score] : scores.by_type) add_to(by_type[name], score);
    for (const auto& [name, score] : scores.by_domain) add_to(by_domain[name], score);
    folds.emplace_back(fold, scores.all.percent(scores.all.equivalent));
    for (const parser::CommandAnswer& a : scores.answers) {
      calibration.add(a.probability, a.equivalent);
      lines += JsonObject()
                   .add("id", a.command->id)
                   .add("text", a.command->text)
                   .add("gold", a.command->formula)
                   .add("formula", a.formula)
                   .add("probability", a.probability)
                   .add("refused", a.refused)
                   .add("exact", a.exact)
                   .add("equivalent", a.equivalent)
                   .text() +
               '\n';
    }
  }
  double mean() const {
    double sum = 0;
    for (const auto& [_, accuracy] : folds) sum += accuracy;
    return folds.empty() ? 0 : sum / static_cast<double>(folds.size());
  }
  double deviation() const {  // of the population of folds, as the published tables have it
    double sum = 0;
    for (const auto& [_, accuracy] : folds) sum += (accuracy - mean()) * (accuracy - mean());
    return folds.empty() ? 0 : std::sqrt(sum / static_cast<double>(folds.size()));
  }
};

void print(const Total& total, bool json) {
  if (json) {
    JsonObject folds;
    for (const auto& [name, accuracy] : total.folds) folds.add(name, accuracy);
    std::cout << JsonObject(json_of(total.all))
                     .add("mean", total.mean())
                     .add("deviation", total.deviation())
                     .add("folds", folds)
                     .add("by_type", json_of(total.by_type))
                     .add("by_domain", json_of(total.by_domain))
                     .add("calibration", json_of(total.calibration))
                     .text()
              << '\n';
    return;
  }
  const auto row = [](const std::string& name, const parser::CommandScore& score) {
    std::cout << name << std::string(name.size() < 34 ? 34 - name.size() : 1, ' ')
              << fixed(score.percent(score.equivalent), 2) << "  " << fixed(score.percent(score.refused), 2) << "  "
              << fixed(score.percent(score.wrong()), 2) << "  " << fixed(score.percent(score.exact), 2) << "  "
              << score.n << '\n';
  };
  std::cout << "                                  right  refused  wrong  exact  commands\n";
  for (const auto& [name, score] : total.by_type) row(name, score);
  for (const auto& [name, score] : total.by_domain) row(name, score);
  row("all", total.all);
  std::cout << "mean over " << total.folds.size() << ": " << fixed(total.mean(), 2) << " ± "
            << fixed(total.deviation(), 2) << '\n'
            << "expected calibration error: " << fixed(total.calibration.expected_error(), 3) << '\n';
}

}  // namespace

void add_commands_request(Command command, CommandsRequest& request) {
  const std::string group = "Commands";
  add_command_training_options(command, request.training);
  command.add_option("--folds", request.folds, "tables of ids that are tested, and not learned from")
      .type_name("FILE")
      .group(group);
  command
      .add_option("--test-commands", request.tests,
                  "commands that are tested; with --folds those made of a row of the fold")
      .type_name("FILE")
      .group(group);
  command.add_option("--command-predictions", request.predictions, "write what was answered, as JSON Lines")
      .type_name("FILE")
      .group(group);
  command.add_flag("--given-mentions", request.marks,
                   "test the reader of formulas alone: marks tell what words name, where commands have them");
  command.add_option("--least-probability", request.least, "refuse answers that are less likely")
      .type_name("P")
      .between(0, 1)
      .group(group);
  command.add_flag("--doubted", request.training.how.doubted, "learn from commands whose labels may be doubted, too");
  command.add_flag("--clean", request.clean, "test no commands whose labels may be doubted");
}

ExitCode evaluate_commands(const CommandsRequest& request, const Session&) {
  if (request.folds.empty() && request.tests.empty())
    throw UsageError("--commands needs --folds or --test-commands: what is tested?");
  if (request.training.files.empty() && request.model_file.empty())
    throw UsageError("--test-commands needs --commands to learn from, or --model-file");
  const std::string& beside = request.training.files.empty() ? request.tests.front() : request.training.files.front();
  parser::CommandDomains domains = domains_of(request.training, beside == "own" ? request.tests.front() : beside);
  const auto synonyms = std::make_shared<const parser::Synonyms>(read_synonyms(request.data));
  const parser::MarkedCommands marked(read_map({"grid", request.data}).vocabulary(), synonyms.get());
  parser::ScoreOptions scoring{.read = {}, .marks_are_given = request.marks, .least = request.least};
  Total total;
  if (request.training.files.empty()) {
    const parser::Grounder grounder = parser::load_grounder(request.model_file);
    if (!grounder.commands) throw UsageError(request.model_file + " has no reader of commands");
    const auto tests = commands_of(request.tests, request.clean);
    total.add(request.model_file, parser::score_commands(*grounder.commands, tests, domains, marked, scoring));
  } else {
    const auto vectors = read_vectors(request.data);
    const parser::SynchronousGrammar grammar = read_grammar(request.data);
    std::vector<std::string> folds = request.folds;
    if (folds.empty()) folds.emplace_back();
    ProgressBar bar;
    for (const std::string& fold : folds) {
      parser::CommandSplit split =
          parser::split_commands(commands_of(request.training.files, false), commands_of(request.tests, request.clean),
                                 fold.empty() ? std::set<std::string>() : ids_of(fold));
      if (request.clean) std::erase_if(split.test, [](const parser::Command& c) { return c.suspect; });
      if (split.test.empty()) throw ltl::FormatError(fold, 0, 0, "names no row that could be tested");
      parser::CommandsExperiment how = request.training.how;
      how.network.seed = request.seed;
      how.synonyms = read_synonyms(request.data);
      how.progress = [&](double done) { bar.show(done, "learning commands"); };
      const parser::LiftedReader reader = parser::train_commands(split, domains, marked, grammar, vectors, how);
      bar.wipe();
      const std::string name = fold.empty() ? "all" : std::filesystem::path(fold).stem().string();
      scoring.read.names_domain = !split.new_kinds;
      total.add(name, parser::score_commands(reader, split.test, domains, marked, scoring));
    }
  }
  if (!request.predictions.empty()) write_file(request.predictions, total.lines);
  print(total, request.json);
  return ExitCode::Done;
}

}  // namespace waymark::tools
