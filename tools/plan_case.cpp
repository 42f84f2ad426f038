#include "tools/plan_case.hpp"

#include <sys/resource.h>

#include <CLI/App.hpp>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libplan/model/read_model.hpp"
#include "libplan/solve/case_task.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/deadline.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

using plan::CaseAnswer;
using Status = CaseAnswer::Status;

plan::CaseMethod method_of(const std::string& name) {
  if (name == "search") return plan::CaseMethod::Search;
  if (name == "vi") return plan::CaseMethod::ValueIteration;
  if (name == "pi") return plan::CaseMethod::PolicyIteration;
  return plan::CaseMethod::Best;
}

std::string_view name(Status status) {
  switch (status) {
    case Status::Solved: return "solved";
    case Status::Infeasible: return "infeasible";
    case Status::Exhausted: return "exhausted";
  }
  return {};
}

ExitCode exit_code(Status status) {
  switch (status) {
    case Status::Solved: return ExitCode::Done;
    case Status::Infeasible: return ExitCode::No;
    case Status::Exhausted: return ExitCode::GaveUp;
  }
  return ExitCode::OurBug;
}

double peak_mib() {  // of the process so far
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

JsonObject json_of(const plan::PlanningCase& planning_case, const plan::CaseTask& task,
                   const CaseAnswer& answer) {
  const bool valued = answer.status != Status::Exhausted;
  const auto number = [&](double value) { return valued ? Json(value) : Json(); };
  JsonObject out;
  out.add("case", planning_case.name).add("task", task.id).add("query", plan::name(task.query));
  out.add("value", number(answer.value.middle()))
      .add("lower", number(answer.value.lower))
      .add("upper", number(answer.value.upper))
      .add("method", plan::name(answer.method))
      .add("automaton_states", answer.automaton_states)
      .add("product_states", answer.product_states)
      .add("product_edges", answer.product_edges)
      .add("seconds", JsonObject()
                          .add("automaton", answer.seconds.automaton)
                          .add("product", answer.seconds.product)
                          .add("solve", answer.seconds.solve))
      .add("peak_mib", peak_mib())
      .add("status", name(answer.status));
  if (!answer.reason.empty()) out.add("reason", answer.reason);
  if (!answer.dropped.empty()) {
    JsonArray dropped;
    for (const std::string& formula : answer.dropped) dropped.add(formula);
    out.add("dropped", dropped);
  }
  return out;
}

void print(const plan::CaseTask& task, const CaseAnswer& answer) {
  std::cout << std::left << std::setw(24) << task.id << ' ' << std::setw(6) << plan::name(task.query) << ' ';
  if (answer.status == Status::Exhausted)
    std::cout << "gave up: " << answer.reason;
  else
    std::cout << std::setprecision(12) << answer.value.middle();
  if (answer.status == Status::Solved && answer.value.lower != answer.value.upper)
    std::cout << "  in [" << answer.value.lower << ", " << answer.value.upper << ']';
  if (answer.status == Status::Infeasible) std::cout << "  infeasible: " << answer.reason;
  for (std::size_t i = 0; i < answer.dropped.size(); ++i)
    std::cout << (i == 0 ? "; possible without " : " and ") << answer.dropped[i];
  std::cout << '\n';
}

// Throws as plan::answer.
ExitCode answer_task(const plan::PlanningCase& planning_case, const plan::CaseTask& task,
                     const CaseChoice& choice, const Session& session) {
  const Deadline deadline(choice.limit_seconds, session.stop);
  const CaseAnswer answer = plan::answer(
      planning_case, task,
      {.method = method_of(choice.method), .tolerance = choice.tolerance, .stop = deadline.token()});
  if (choice.json)
    std::cout << json_of(planning_case, task, answer).text() << '\n';
  else
    print(task, answer);
  return exit_code(answer.status);
}

// What is wrong with the formula or query of a task is reported like any other bad line.
ExitCode try_task(const plan::PlanningCase& planning_case, const plan::CaseTask& task,
                  const CaseChoice& choice, const Session& session) {
  try {
    return answer_task(planning_case, task, choice, session);
  } catch (const ltl::SyntaxError& error) {
    complain("error", "task " + task.id + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    complain("error", "task " + task.id + ": " + error.what());
  }
  return ExitCode::BadInput;
}

plan::CaseTask task_of(const Text& text, const CaseChoice& choice) {
  using Query = plan::CaseTask::Query;
  using Logic = plan::CaseTask::Logic;
  plan::CaseTask task{.id = text.source.empty() ? "formula" : "line " + std::to_string(text.line),
                      .formula = text.text};
  task.query = choice.query == "pmax"   ? Query::MaxProbability
               : choice.query == "pmin" ? Query::MinProbability
               : choice.query == "rmin" ? Query::MinCost
                                        : Query::MinSteps;
  task.logic = task.query == Query::MinSteps ? Logic::Ltlf : Logic::Ltl;
  return task;
}

}  // namespace

void add_case_options(CLI::App& command, CaseChoice& choice) {
  command
      .add_option("--case", choice.file,
                  "a planning case (ltlgrid/1 or ltlmap/1) instead of a formula and a map")
      ->type_name("FILE");
  command
      .add_option(
          "--model", choice.model,
          "a formula's value on another model than a map: PRISM's FILE.nm or FILE.tra, a street graph or "
          "planning case (JSON)")
      ->type_name("FILE");
  command
      .add_option(
          "--query", choice.query,
          "with --model: greatest or least probability, least expected cost until the formula is sure to "
          "hold; steps: least cost of a finite word")
      ->check(CLI::IsMember({"pmax", "pmin", "rmin", "steps"}))
      ->capture_default_str();
  command.add_option("--task", choice.task, "with --case: this task only")->type_name("ID");
  command
      .add_option("--method", choice.method, "with --case: how it is solved; best picks by model and query")
      ->check(CLI::IsMember({"best", "search", "vi", "pi"}))
      ->capture_default_str();
  command
      .add_option("--tolerance", choice.tolerance,
                  "with --case: proved error of values, absolute for probabilities, relative for costs")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--limit-seconds", choice.limit_seconds, "with --case: time for each task")
      ->check(CLI::PositiveNumber);
}

ExitCode plan_case(const CaseChoice& choice, const Session& session) {
  const plan::PlanningCase planning_case = plan::read_case(choice.file);
  ExitCode worst = ExitCode::Done;
  bool any = false;
  for (const plan::CaseTask& task : planning_case.tasks) {
    if (!choice.task.empty() && task.id != choice.task) continue;
    if (session.stop.stop_requested()) throw Interrupted();
    any = true;
    worst = std::max(worst, try_task(planning_case, task, choice, session));
    std::cout.flush();
  }
  if (!any)
    throw UsageError(choice.task.empty() ? choice.file + " has no tasks"
                                         : choice.file + " has no task '" + choice.task + "'");
  return worst;
}

ExitCode plan_model(const CaseChoice& choice, const TextOptions& formulas, const std::string& start,
                    const Session& session) {
  const plan::PlanningCase model = plan::read_model(choice.model, start);
  TextReader texts(formulas, "formula");
  return answer_each(
      texts, session.stop,
      [&](const Text& text) {
        try {
          return answer_task(model, task_of(text, choice), choice, session);
        } catch (const std::invalid_argument& error) {
          throw UsageError(error.what());  // a method that does not answer the query
        } catch (const ltl::SyntaxError& error) {
          if (text.source.empty()) throw;
          throw error.in(text.source, text.line);
        }
      },
      [&](const Text& text, const std::string& message) {
        if (choice.json)
          std::cout
              << JsonObject().add("line", text.line).add("status", "error").add("message", message).text()
              << '\n';
      });
}

}  // namespace waymark::tools
