#include "tools/plan_case.hpp"

#include <atomic>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/parallel.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/formats/read_model.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/solve/mapped_files.hpp"
#include "tools/automaton_output.hpp"
#include "tools/case_answer.hpp"
#include "tools/case_scheduler.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

using plan::CaseAnswer;
using Status = CaseAnswer::Status;

// One object that says what the strategy is worth and which automaton it follows, then one for every state that it
// meets.
std::string written(const plan::PlanningCase& planning_case, const plan::CaseTask& task, const CaseAnswer& answer) {
  const CaseAnswer::Written& strategy = *answer.strategy;
  const bool negated = task.query == plan::CaseTask::Query::MinProbability && !task.formula.empty() &&
                       std::holds_alternative<automata::MdpSafe>(strategy.automaton);
  const std::string name = negated ? "!(" + task.formula + ')' : task.formula;
  const std::string hoa =
      std::visit([&](const auto& a) { return show(a, {.name = name}, {.one_line = true}).text; }, strategy.automaton);
  std::string out =
      JsonObject()
          .add("case", planning_case.name)
          .add("task", task.id.empty() ? "formula" : task.id)
          .add("query", plan::name(task.query))
          .add("formula", task.formula.empty() ? Json() : Json(task.formula))
          .add("lower", answer.value.lower)
          .add("upper", answer.value.upper)
          .add("re_evaluated",
               JsonObject().add("lower", strategy.re_evaluated.lower).add("upper", strategy.re_evaluated.upper))
          .add("decisions", strategy.decisions.size())
          .add("automaton", hoa)
          .text() +
      '\n';
  for (const plan::Decision& decision : strategy.decisions) {
    JsonObject line;
    line.add("state", decision.place).add("task", decision.task);
    if (decision.jump == plan::Decision::no_jump)
      line.add("action", decision.action);
    else
      line.add("jump", decision.jump);
    out += line.text() + '\n';
  }
  return out;
}

// Answers tasks side by side; what they share is told once.
class TaskAnswers {
 public:
  TaskAnswers(const plan::PlanningCase& planning_case, const CaseChoice& choice, const Session& session)
      : case_(planning_case), choice_(choice), session_(session) {
    if (choice.values_in.empty()) return;
    if (!std::filesystem::is_directory(choice.values_in))
      throw UsageError("--values-in: " + choice.values_in + " is no folder");
    files_.emplace(choice.values_in);
  }

  // `place`: of its strategy among all of them. Throws as plan::answer.
  Reply answer(const plan::CaseTask& task, std::size_t place, const TextWatch& watch,
               const plan::GivenAutomaton* given = nullptr) {
    const plan::CaseOptions options{.method = method_of(choice_.method),
                                    .tolerance = choice_.tolerance,
                                    .discount = choice_.discount,
                                    .order = order_of(choice_.order),
                                    .top = choice_.top,
                                    .route = !choice_.model.empty(),
                                    .strategy = !choice_.strategy.empty(),
                                    .sweepers = {threads(), &working_},
                                    .memory = memory(),
                                    .stop = watch.token()};
    const AtWork at_work(working_);
    CaseAnswer answer = given != nullptr ? plan::answer(case_, task, *given, options) : answered(task, options);
    if (answer.status == Status::Exhausted && session_.stop.stop_requested()) throw Interrupted();
    if (answer.status == Status::Exhausted && watch.overrun() != ltl::Overrun::None)
      answer.reason += " (" + amount(watch.overrun(), choice_.parallel.limits) + ')';
    Reply reply = told(case_.name, task, answer, choice_.json);
    if (answer.strategy) keep_strategy(task, place, answer, reply);
    return reply;
  }

  // What is wrong with the formula or query of a task is reported like any other bad line.
  Reply try_task(const plan::CaseTask& task, std::size_t place, const TextWatch& watch) {
    try {
      return answer(task, place, watch);
    } catch (const ltl::SyntaxError& error) {
      return {ExitCode::BadInput, "", "task " + task.id + ": " + error.what()};
    } catch (const std::invalid_argument& error) {
      return {ExitCode::BadInput, "", "task " + task.id + ": " + error.what()};
    }
  }

  void write_strategies() const {
    if (choice_.strategy.empty()) return;
    std::string all;
    for (const auto& [place, text] : strategies_) all += text;
    if (all.empty()) {  // an older file stays as it was
      if (choice_.strategy != "-")
        std::cerr << "note: no strategy is written to " << ltl::printable(choice_.strategy) << '\n';
      return;
    }
    write_file(choice_.strategy, all);
  }

 private:
  // The value is told, whether the strategy can be written in the format or not.
  void keep_strategy(const plan::CaseTask& task, std::size_t place, const CaseAnswer& answer, Reply& reply) {
    const bool ours = choice_.strategy_format == "waymark";
    try {
      std::string text = ours ? written(case_, task, answer) : scheduler_text(case_, answer, choice_.strategy_format);
      const std::lock_guard lock(mutex_);
      strategies_[place] = std::move(text);
    } catch (const UsageError& error) {
      reply.code = worse(reply.code, ExitCode::Usage);
      reply.problem = (task.id.empty() ? "" : task.id + ": ") + error.what();
    }
  }
  CaseAnswer answered(const plan::CaseTask& task, const plan::CaseOptions& options) const {
    try {
      return plan::answer(case_, task, options);
    } catch (const plan::MappedFiles::Full& full) {
      throw GaveUp(full.what());
    }
  }
  class AtWork {  // where a task has ended, its thread may sweep for others
   public:
    explicit AtWork(std::atomic<std::size_t>& working) : working_(working) { ++working_; }
    ~AtWork() { --working_; }
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;

   private:
    std::atomic<std::size_t>& working_;
  };
  std::pmr::memory_resource* memory() {
    return files_ ? static_cast<std::pmr::memory_resource*>(&*files_) : std::pmr::get_default_resource();
  }
  std::size_t threads() const {
    return choice_.parallel.threads > 0 ? choice_.parallel.threads : ltl::hardware_threads();
  }

  const plan::PlanningCase& case_;
  const CaseChoice& choice_;
  const Session& session_;
  std::optional<plan::MappedFiles> files_;
  std::atomic<std::size_t> working_{0};  // tasks
  std::mutex mutex_;
  std::map<std::size_t, std::string> strategies_;  // by place
};

}  // namespace

plan::CaseMethod method_of(const std::string& name) {
  if (name == "search") return plan::CaseMethod::Search;
  if (name == "vi") return plan::CaseMethod::ValueIteration;
  if (name == "pi") return plan::CaseMethod::PolicyIteration;
  return plan::CaseMethod::Best;
}

plan::CaseTask task_of(const Text& text, const CaseChoice& choice) {
  using Query = plan::CaseTask::Query;
  using Logic = plan::CaseTask::Logic;
  plan::CaseTask task{.id = text.source.empty() ? "" : "line " + std::to_string(text.line), .formula = text.text};
  task.query = choice.query.empty()           ? Query::MaxProbability
               : choice.query == "pmax"       ? Query::MaxProbability
               : choice.query == "pmin"       ? Query::MinProbability
               : choice.query == "rmin"       ? Query::MinCost
               : choice.query == "rmax"       ? Query::MaxCost
               : choice.query == "lasso"      ? Query::LeastLasso
               : choice.query == "discounted" ? Query::Discounted
                                              : Query::MinSteps;
  task.logic = task.query == Query::MinSteps ? Logic::Ltlf : Logic::Ltl;
  return task;
}

plan::PlanningCase read_model(const CaseChoice& choice, const std::string& start, const std::stop_token& stop) {
  const ltl::Watch watch(granted(choice.parallel.limits), stop);
  try {
    return plan::read_model(choice.model, start, {.states = plan::most_model_states, .stop = watch.token()},
                            {constants_of(choice.constants), choice.rewards});
  } catch (const plan::ReadingStopped&) {
    if (watch.overrun() == ltl::Overrun::None) throw Interrupted();
    throw GaveUp("gave up: " + choice.model + " has more states than were found in " +
                 amount(watch.overrun(), choice.parallel.limits));
  }
}

ExitCode plan_case(const CaseChoice& choice, const Session& session) {
  const plan::PlanningCase planning_case = plan::read_case(choice.file);
  std::vector<const plan::CaseTask*> chosen;
  for (const plan::CaseTask& task : planning_case.tasks)
    if (choice.task.empty() || task.id == choice.task) chosen.push_back(&task);
  if (chosen.empty())
    throw UsageError(choice.task.empty() ? choice.file + " has no tasks"
                                         : choice.file + " has no task '" + choice.task + "'");
  TaskAnswers answers(planning_case, choice, session);
  const ExitCode worst = answer_in_parallel(
      chosen.size(), session.stop, choice.parallel,
      [&](std::size_t job, const TextWatch& watch) { return answers.try_task(*chosen[job], job, watch); });
  answers.write_strategies();
  return worst;
}

ExitCode plan_model(plan::PlanningCase free, const CaseChoice& choice, const TextOptions& formulas,
                    const Session& session) {
  if (!choice.strategy.empty()) require_scheduler_of(free, choice.strategy_format);
  const plan::PlanningCase model = scheduled(std::move(free), choice.scheduler);
  TaskAnswers answers(model, choice, session);
  const auto answered = [&](const plan::CaseTask& task, const Text& text, const TextWatch& watch,
                            const plan::GivenAutomaton* given) {
    try {
      return answers.answer(task, text.line, watch, given);
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());  // a method that does not answer the query
    }
  };
  const ltl::Vocabulary& known =
      std::visit([](const auto& m) -> const ltl::Vocabulary& { return m.letters().vocabulary(); }, model.model);
  ExitCode code = ExitCode::Done;
  if (!choice.automaton.empty()) {
    const plan::GivenAutomaton given =
        plan::read_given_automaton(read_file(choice.automaton), source_name(choice.automaton));
    code = answer_in_parallel(1, session.stop, choice.parallel, [&](std::size_t, const TextWatch& watch) {
      const Text none{.text = "", .source = ""};
      return answered(task_of(none, choice), none, watch, &given);
    });
  } else {
    TextReader texts(formulas, "formula");
    code = answer_in_parallel(
        texts, session.stop, choice.parallel,
        [&](const Text& text, const TextWatch& watch) {
          try {
            ltl::Arena arena(known);
            ltl::parse(text.text, arena, {.unknown = ltl::Unknown::Reject});
            return answered(task_of(text, choice), text, watch, nullptr);
          } catch (const ltl::SyntaxError& error) {
            if (text.source.empty()) throw;
            throw error.in(text.source, text.line);
          }
        },
        [&](const Text& text, const std::string& message) {
          return choice.json ? json_error(text.line, message).text() + '\n' : std::string();
        });
  }
  answers.write_strategies();
  return code;
}

}  // namespace waymark::tools
