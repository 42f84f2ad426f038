// waymark experiment: a whole table of results in one command.
#include <iomanip>
#include <iostream>
#include <memory>

#include "tools/lab/compare_systems.hpp"
#include "tools/lab/feedback_cost.hpp"
#include "tools/lab/rerun.hpp"
#include "tools/render/cost_plot.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct FeedbackTableOptions {
  FeedbackCostOptions measure;
  std::string svg;
  bool json = false;
};

JsonArray json_of(const std::vector<FeedbackCost>& rows) {
  JsonArray list;
  for (const FeedbackCost& row : rows) {
    JsonObject costs;
    for (std::size_t e = 0; e < feedback_engines.size(); ++e) costs.add(feedback_engines[e], row.microseconds[e]);
    list.add(JsonObject()
                 .add("places", row.places)
                 .add("steps", row.steps)
                 .add("length", row.length)
                 .add("microseconds", costs));
  }
  return list;
}

void print_rows(const std::string& what, const std::vector<FeedbackCost>& rows) {
  std::cout << '\n' << std::left << std::setw(22) << what << std::right;
  for (const char* engine : feedback_engines) std::cout << std::setw(21) << engine;
  std::cout << '\n';
  for (const FeedbackCost& row : rows) {
    std::cout << std::setw(6) << row.places << std::setw(6) << row.steps << std::setw(10) << fixed(row.length, 1);
    for (const double cost : row.microseconds) std::cout << std::setw(21) << fixed(cost, 3);
    std::cout << '\n';
  }
}

template <class Size>
render::CostPanel panel_of(const std::string& over, const std::vector<FeedbackCost>& rows, const Size& size) {
  render::CostPanel panel{over, {}, std::vector<std::vector<double>>(feedback_engines.size())};
  for (const FeedbackCost& row : rows) {
    panel.sizes.push_back(static_cast<double>(size(row)));
    for (std::size_t e = 0; e < feedback_engines.size(); ++e) panel.costs[e].push_back(row.microseconds[e]);
  }
  return panel;
}

std::string plot_of(const FeedbackCosts& costs) {
  render::CostPlot plot{"What feedback costs: does the trajectory satisfy the formula, or does its plan end there?",
                        std::to_string(costs.candidates) + " formulas a sentence, routes to furniture in order",
                        "microseconds a formula",
                        {feedback_engines.begin(), feedback_engines.end()},
                        {}};
  plot.panels.push_back(panel_of("places of the map", costs.by_places, [](const auto& r) { return r.places; }));
  plot.panels.push_back(panel_of("letters of the trajectory", costs.by_length, [](const auto& r) { return r.length; }));
  plot.panels.push_back(panel_of("steps of the formula", costs.by_steps, [](const auto& r) { return r.steps; }));
  return render::draw_costs(plot);
}

ExitCode run_feedback_table(const FeedbackTableOptions& options, const Session& session) {
  FeedbackCostOptions measure = options.measure;
  measure.stop = session.stop;
  const FeedbackCosts costs = measure_feedback(measure);
  if (!options.svg.empty()) write_file(options.svg, plot_of(costs));
  if (options.json) {
    std::cout << JsonObject()
                     .add("table", "table2")
                     .add("seed", measure.seed)
                     .add("candidates", costs.candidates)
                     .add("by_places", json_of(costs.by_places))
                     .add("by_length", json_of(costs.by_length))
                     .add("by_steps", json_of(costs.by_steps))
                     .text()
              << '\n';
    return ExitCode::Done;
  }
  std::cout << "microseconds a formula; a sentence has " << costs.candidates
            << " of them and costs so many times as much\n";
  print_rows("places steps   letters", costs.by_places);
  print_rows("places steps   letters", costs.by_length);
  print_rows("places steps   letters", costs.by_steps);
  return ExitCode::Done;
}

void add_feedback_options(Command command, FeedbackTableOptions& options) {
  command.add_option("--seed", options.measure.seed, "of maps, formulas and walks").type_name("N").show_default();
  command.add_option("--sentences", options.measure.sentences, "of each row")
      .type_name("COUNT")
      .between(1, 10000)
      .show_default();
  command.add_option("--candidates", options.measure.candidates, "formulas of each sentence")
      .type_name("COUNT")
      .between(1, 10000)
      .show_default();
  command.add_option("--svg", options.svg, "write a plot").type_name("FILE");
  command.add_flag("--json", options.json, "one JSON object");
}

void add_system_options(Command command, CompareSystemsOptions& options) {
  command.add_option("--corpus", options.corpus, "directory with instructions.jsonl and, if it has its own, maps/")
      .type_name("DIR")
      .required();
  command.add_option("--test-corpus", options.test_corpus, "take the sentences to test on from here instead")
      .type_name("DIR");
  command
      .add_option("--checkpoints", options.directory,
                  "where finished parts are kept, and found again by the same command")
      .type_name("DIR")
      .required();
  add_data_option(command, options.data);
  command.add_option("--seed", options.train.seed, "of the first system").type_name("N").show_default();
  command.add_option("--ensemble", options.ensemble, "systems of seeds N, N + 1, …: a row each, and one that votes")
      .type_name("COUNT")
      .between(1, 100)
      .show_default();
  command.add_option("--epochs", options.epochs, "passes over the sentences; what is usual for each")
      .type_name("N")
      .between(1, 1000);
  command
      .add_option_function(
          "--convention",
          [&options](const std::string& which) {
            options.absolute = which != "relative";
            options.relative = which != "absolute";
          },
          "what an unknown start heading counts as: absolute, relative or both (the default)")
      .one_of({"absolute", "relative", "both"})
      .type_name("KIND");
  command.add_option("--threads", options.train.threads, "of no influence on the result")
      .type_name("N")
      .between(1, 256)
      .show_default();
  command.add_flag("--tell-place-numbers", options.tell_place_numbers, "as `waymark evaluate` has it");
  command.add_flag("--json", options.json, "one JSON object");
}

struct Recorded {  // an experiment that is its transcript
  const char *name, *summary;
};
constexpr Recorded all_recorded[] = {
    {"learners", "learners with tables and with networks on five tasks (three minutes)"},
    {"known-language", "a language of our own: from its formulas and from trajectories (4 minutes)"},
    {"noisy-grids", "probabilities and costs on noisy grids: sizes and proved values (a minute)"},
    {"routes", "ten waypoints on large grids: what search meets (half a minute)"},
};

}  // namespace

Runner setup_experiment(Command command) {
  const auto feedback = std::make_shared<FeedbackTableOptions>();
  const auto systems = std::make_shared<CompareSystemsOptions>();
  const Command costs =
      command.add_subcommand("feedback-cost", "what feedback costs: checking a trajectory, or planning");
  costs.alias("table2");  // of the seed paper
  add_feedback_options(costs, *feedback);
  const Command comparison =
      command.add_subcommand("compare-systems", "systems, one map left out, beside the published rows");
  comparison.alias("table4");  // of the seed paper
  add_system_options(comparison, *systems);
  const auto again = std::make_shared<RerunOptions>();
  add_rerun_options(costs, *again);
  std::vector<Command> recorded;
  for (const Recorded& one : all_recorded) {
    recorded.push_back(command.add_subcommand(one.name, one.summary));
    add_rerun_options(recorded.back(), *again);
    add_data_option(recorded.back(), again->data);
  }
  return [=](const Session& session) {
    for (std::size_t i = 0; i < recorded.size(); ++i)
      if (recorded[i].parsed()) again->name = all_recorded[i].name;
    if (again->check && again->name.empty()) again->name = "feedback-cost";
    if (!again->name.empty()) return rerun(*again, session);
    return comparison.parsed() ? compare_systems(*systems, session) : run_feedback_table(*feedback, session);
  };
}

}  // namespace waymark::tools