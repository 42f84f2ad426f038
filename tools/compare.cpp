// waymark compare: exact search, value iteration and learners on one task, or on a suite of tasks.
#include <iostream>
#include <memory>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/product/task_table.hpp"
#include "libplan/solve/product_search.hpp"
#include "libplan/solve/route_planner.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tools/compare_runs.hpp"
#include "tools/corridor.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/noise.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct CompareOptions {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, automaton, planning_case, task;
  NoiseOptions noise;
  CompareChoice choice;
};

// An automaton in the place of a formula.
struct Given {
  automata::Dfa dfa;
  std::string name;
};

// nullopt: none was named. Throws ltl::FormatError for an automaton on infinite words: an episode has to end.
std::optional<Given> read_given(const std::string& file) {
  if (file.empty()) return std::nullopt;
  plan::GivenAutomaton given = plan::read_given_automaton(read_file(file), source_name(file));
  auto* const dfa = std::get_if<automata::Dfa>(&given);
  if (dfa == nullptr)
    throw ltl::FormatError(source_name(file), 0, 0, "an automaton on infinite words: learners need an end");
  return Given{std::move(*dfa), source_name(file)};
}

// Formulas on a hallway map.
class OnMap {
 public:
  OnMap(const CompareOptions& options, const Session& session, Comparison& comparison)
      : options_(options),
        session_(session),
        comparison_(comparison),
        noise_(noise_of(options.noise)),
        map_(read_map(options.map)),
        starts_(start_poses(options.start, map_)) {}

  ExitCode compare(const Text& text, bool is_single) {
    ltl::Arena arena(map_.vocabulary());
    const ltl::Formula formula = parse_on_map(text, arena, options_.notation, options_.map.map);
    return compare(translate(formula, session_.stop), {.formula = formula}, is_single);
  }

  ExitCode compare(const automata::Dfa& dfa, ComparedTask compared, bool is_single) {
    plan::LearningTaskOptions task_options = comparison_.task_options();
    task_options.noise = noise_;
    const plan::LearningTask task(map_, dfa, compared.formula, starts_, task_options);
    compared.map = map_.name();
    for (const plan::PoseId start : starts_) compared.starts.push_back(map_.pose(start));
    compared.automaton_states = dfa.states();
    if (noise_ == plan::MapNoise{}) compared.search = search(dfa);
    return comparison_.run(std::move(compared), task, is_single);
  }

 private:
  // The mean over the starts, each with a search of its own; nothing where one of them has no route.
  std::optional<Searched> search(const automata::Dfa& dfa) const {
    StopWatch watch;
    plan::RoutePlanner planner(map_, dfa);
    Searched searched;
    for (const plan::PoseId start : starts_) {
      const auto answer = planner.plan(start, session_.stop);
      if (std::holds_alternative<plan::Exhausted>(answer)) throw Interrupted();
      const auto* route = std::get_if<plan::Route>(&answer);
      if (route == nullptr) return std::nullopt;
      searched.cost += route->cost / static_cast<double>(starts_.size());
    }
    searched.is_reference = starts_.size() == 1;
    searched.seconds = watch.lap();
    return searched;
  }

  const CompareOptions& options_;
  const Session& session_;
  Comparison& comparison_;
  plan::MapNoise noise_;
  plan::Map map_;
  std::vector<plan::PoseId> starts_;
};

// Tasks of a planning case, as far as a finite prefix decides them: an episode has to end.
template <class Model>
class OnModel {
 public:
  OnModel(const plan::PlanningCase& planning_case, const Model& model, const std::optional<Given>& given,
          const Session& session, Comparison& comparison)
      : case_(planning_case), model_(model), given_(given), session_(session), comparison_(comparison) {}

  // Throws std::invalid_argument for a task that learners cannot be given.
  ExitCode compare(const plan::CaseTask& task, bool is_single) {
    if (!task.fault.empty()) throw std::invalid_argument(task.fault);
    if (task.logic == plan::CaseTask::Logic::Derived) throw std::invalid_argument("a tour is no task for learners");
    if (given_) return compare(task, given_->dfa, {.automaton = given_->name}, is_single);
    ltl::Arena arena(model_.letters().vocabulary());
    const ltl::Formula formula = ltl::parse(task.formula, arena, {.unknown = ltl::Unknown::Reject});
    const auto automaton = plan::task_automaton(formula, task.logic, task.query, {.stop = session_.stop});
    if (!automaton && session_.stop.stop_requested()) throw Interrupted();
    if (!automaton) throw GaveUp("no automaton within the limits");
    const auto* dfa = std::get_if<automata::Dfa>(&*automaton);
    if (dfa == nullptr) throw std::invalid_argument("no finite prefix decides it: learners need an end");
    return compare(task, *dfa, {.formula = formula}, is_single);
  }

 private:
  ExitCode compare(const plan::CaseTask& task, const automata::Dfa& dfa, ComparedTask compared, bool is_single) {
    const plan::LearningTask learning(model_, dfa, compared.formula, comparison_.task_options());
    compared.map = case_.name;
    compared.task = task.id;
    compared.start = model_.name(model_.initial());
    compared.automaton_states = dfa.states();
    if (model_.is_deterministic()) compared.search = search(dfa);
    return comparison_.run(std::move(compared), learning, is_single);
  }

  std::optional<Searched> search(const automata::Dfa& dfa) const {
    StopWatch watch;
    const auto answer = plan::search(plan::Product(model_, plan::TaskTable(dfa, model_.letters())),
                                     {.states = SIZE_MAX, .stop = session_.stop});
    if (!answer) throw Interrupted();
    if (!answer->route) return std::nullopt;
    return Searched{answer->route->cost, watch.lap(), plan::uniform_cost(model_).has_value()};
  }

  const plan::PlanningCase& case_;
  const Model& model_;
  const std::optional<Given>& given_;
  const Session& session_;
  Comparison& comparison_;
};

// A task that is wrong, or no task for learners, is reported, and the others are compared; one that was asked for by
// name is an error.
ExitCode compare_case(const CompareOptions& options, const Session& session, Comparison& comparison) {
  const plan::PlanningCase planning_case = plan::read_case(options.planning_case);
  const std::optional<Given> given = read_given(options.automaton);
  const bool is_single = !options.task.empty();
  ExitCode worst = ExitCode::Done;
  bool any = false;
  for (const plan::CaseTask& task : planning_case.tasks) {
    if (is_single && task.id != options.task) continue;
    any = true;
    try {
      worst = std::max(worst,
                       std::visit(
                           [&](const auto& model) {
                             return OnModel(planning_case, model, given, session, comparison).compare(task, is_single);
                           },
                           planning_case.model));
    } catch (const std::invalid_argument& error) {
      complain(is_single ? "error" : "note", "task " + task.id + ": " + error.what());
      if (is_single) worst = ExitCode::BadInput;
    } catch (const ltl::SyntaxError& error) {
      complain("error", "task " + task.id + ": " + error.what());
      worst = ExitCode::BadInput;
    }
    std::cout.flush();
  }
  if (!any) throw UsageError(options.planning_case + " has no task" + (is_single ? " '" + options.task + "'" : "s"));
  if (comparison.tasks() > 1) comparison.suite();
  return worst;
}

void check(const CompareOptions& options) {
  const double discount = options.choice.protocol.discount;
  if (!(discount > 0 && discount < 1)) throw UsageError("--discount lies between 0 and 1");
  const bool formulas = !options.text.arguments.empty() || !options.text.file.empty();
  if (formulas && !options.automaton.empty()) throw UsageError("give a formula or --automaton, not both");
  if (options.planning_case.empty()) {
    if (!options.task.empty()) throw UsageError("--task goes with --case");
    return;
  }
  if (formulas) throw UsageError("a planning case brings its own formulas");
  if (options.noise.given())
    throw UsageError("--slip and --slip-turn are for maps: a planning case has its own motion");
  if (!options.choice.svg.empty() && options.task.empty())
    throw UsageError("--svg is for a single task: name it by --task");
}

ExitCode run_compare(const CompareOptions& options, const Session& session) {
  check(options);
  Comparison comparison(options.choice, session);
  if (!options.planning_case.empty()) return compare_case(options, session, comparison);
  if (const auto given = read_given(options.automaton))
    return OnMap(options, session, comparison).compare(given->dfa, {.automaton = given->name}, true);
  TextReader texts(options.text, "formula");
  if (texts.is_batch() && !options.choice.svg.empty())
    throw UsageError("--svg is for a single formula given as an argument");
  OnMap on_map(options, session, comparison);
  const ExitCode code = answer_each(
      texts, session.stop, [&](const Text& text) { return on_map.compare(text, !texts.is_batch()); },
      options.choice.json);
  if (texts.is_batch()) comparison.suite();
  return code;
}

std::string method_names() {
  std::string text =
      "separated by commas; all, or of:\n  search*: exact, where nothing slips\n  value-iteration*: exact";
  for (const plan::Method& method : plan::learning_methods())
    text += "\n  " + method.name + (method.by_default ? "*" : "") + ": " + method.summary;
  return text + "\n  (* when none is named)";
}

}  // namespace

Runner setup_compare(Command command) {
  const auto options = std::make_shared<CompareOptions>();
  Protocol& protocol = options->choice.protocol;
  add_text_options(command, options->text, "formula");
  command.add_option("--automaton", options->automaton, "a DFA in HOA instead of a formula; - is standard input")
      .type_name("FILE");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  command
      .add_option("--case", options->planning_case,
                  "the tasks of a planning case (ltlgrid/1 or ltlmap/1) instead of a formula and a map")
      .type_name("FILE");
  command.add_option("--task", options->task, "with --case: this task only").type_name("ID");
  constexpr int most = 1'000'000'000;
  command.add_option("--methods", options->choice.methods, method_names()).separated_by(',').type_name("NAME,...");
  command.add_option("--seeds", protocol.seeds, "runs of each learner").between(1, most).show_default();
  command.add_option("--steps", protocol.steps, "of the environment, in each run").between(1, most).show_default();
  command.add_option("--interval", protocol.interval, "steps between two exact evaluations of the policy")
      .between(1, most)
      .show_default();
  command.add_option("--horizon", protocol.horizon, "steps of an episode before it is cut")
      .between(1, most)
      .show_default();
  command.add_option("--discount", protocol.discount, "of the return that learners maximise").show_default();
  add_noise_options(command, options->noise);
  command
      .add_option("--threads", options->choice.threads,
                  "runs at a time (else one for each core); no influence on what they learn")
      .between(1, 1024);
  command.in("Output").add_flag("--json", options->choice.json, "one JSON object a line");
  command.in("Output").add_option("--svg", options->choice.svg, "draw the learning curves").type_name("FILE");
  return [options](const Session& session) { return run_compare(*options, session); };
}

}  // namespace waymark::tools
