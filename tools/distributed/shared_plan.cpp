// waymark plan --case under mpirun: the tasks of a grid case one after the other, each solved by all ranks.
#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libltl/watch.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "tools/case_answer.hpp"
#include "tools/case_options.hpp"
#include "tools/distributed/shared_task.hpp"
#include "tools/plan_case.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/program.hpp"
#include "tools/shell/reply.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

namespace {

struct SharedPlanOptions {
  CaseChoice planning_case;
  SharedOptions shared;
  std::string checkpoints, statistics;
};

void check(const SharedPlanOptions& options) {
  const CaseChoice& choice = options.planning_case;
  if (choice.file.empty() || !choice.model.empty() || !choice.query.empty() || !choice.properties.empty())
    throw UsageError("ranks share planning cases: plan --case FILE, without --model, --query and --properties");
  if (choice.method != "best" && choice.method != "vi") throw UsageError("ranks solve by value iteration: --method vi");
  if (!choice.strategy.empty() || !choice.scheduler.empty() || choice.top > 1)
    throw UsageError("--strategy, --scheduler and --top are not shared among ranks");
}

struct SharedCase {
  std::string name;
  std::vector<std::pair<std::size_t, plan::CaseTask>> tasks;  // that were chosen, with their places in the file
  std::optional<GridBand> band;
};

// The file is read by every rank; of the map it keeps its band.
SharedCase read(const SharedPlanOptions& options, const Ranks& ranks) {
  check(options);
  plan::PlanningCase whole = plan::read_case(options.planning_case.file);
  const auto* grid = std::get_if<plan::GridWorld>(&whole.model);
  if (grid == nullptr) throw UsageError("ranks share cases of the format ltlgrid/1");
  if (grid->height() < static_cast<std::uint32_t>(ranks.count()))
    throw UsageError("more ranks than the grid has rows: " + std::to_string(grid->height()));
  SharedCase out{std::move(whole.name), {}, {}};
  const std::string& wanted = options.planning_case.task;
  for (std::size_t i = 0; i < whole.tasks.size(); ++i)
    if (wanted.empty() || whole.tasks[i].id == wanted) out.tasks.emplace_back(i, std::move(whole.tasks[i]));
  if (out.tasks.empty())
    throw UsageError(wanted.empty() ? options.planning_case.file + " has no tasks"
                                    : options.planning_case.file + " has no task '" + wanted + "'");
  out.band.emplace(*grid, rows_of(ranks.rank(), ranks.count(), grid->height()));
  return out;
}

// One object for each rank, by rank.
std::string of_all_ranks(const Ranks& ranks, const std::string& task, const SharedStatistics& own, double solve) {
  std::array<double, 12> row{static_cast<double>(own.pairs),
                             static_cast<double>(own.unknowns),
                             static_cast<double>(own.rounds),
                             static_cast<double>(own.updates),
                             static_cast<double>(own.longest),
                             static_cast<double>(own.values),
                             own.sweeping,
                             own.exchanging,
                             own.agreeing,
                             static_cast<double>(own.resumed),
                             static_cast<double>(own.checkpoints),
                             solve};
  constexpr std::array names{"pairs",
                             "unknowns",
                             "rounds",
                             "updates",
                             "longest_updates",
                             "values_received",
                             "sweeping_seconds",
                             "exchanging_seconds",
                             "agreeing_seconds",
                             "resumed",
                             "checkpoints",
                             "solve_seconds"};
  std::vector<double> all(row.size() * static_cast<std::size_t>(ranks.count()));
  MPI_Gather(row.data(), row.size(), MPI_DOUBLE, all.data(), row.size(), MPI_DOUBLE, 0, ranks.communicator());
  std::string out;
  for (int r = 0; r < ranks.count() && ranks.rank() == 0; ++r) {
    JsonObject line;
    line.add("task", task).add("ranks", ranks.count()).add("rank", r);
    for (std::size_t i = 0; i < row.size(); ++i) line.add(names[i], all[static_cast<std::size_t>(r) * row.size() + i]);
    out += line.text() + '\n';
  }
  return out;
}

// What is wrong with a task is reported like any other bad line; every rank finds the same.
Reply try_task(const Ranks& ranks, const SharedCase& shared, const plan::CaseTask& task, const SharedPlanOptions& asked,
               const KeptBands* kept, const std::stop_token& stop, std::string& statistics) {
  const ltl::Watch watch(granted(asked.planning_case.parallel.limits), stop);
  SharedOptions options = asked.shared;
  options.stop = watch.token();
  try {
    SharedStatistics own;
    plan::CaseAnswer found = answer(ranks, *shared.band, task, options, kept, own);
    statistics += of_all_ranks(ranks, task.id, own, found.seconds.solve);
    if (found.status == plan::CaseAnswer::Status::Exhausted) {
      std::ostringstream bounds;
      bounds.precision(12);
      bounds << found.reason << ": the value is at least " << found.value.lower << " and at most " << found.value.upper;
      found.reason = bounds.str();
    }
    return told(shared.name, task, found, asked.planning_case.json);
  } catch (const ltl::SyntaxError& error) {
    return {ExitCode::BadInput, "", "task " + task.id + ": " + error.what()};
  } catch (const std::invalid_argument& error) {
    return {ExitCode::BadInput, "", "task " + task.id + ": " + error.what()};
  }
}

ExitCode of_fault(const std::exception_ptr& fault) {
  return guarded([&]() -> ExitCode { std::rethrow_exception(fault); });
}

// The least rank that found a fault tells it, and all end with its exit code.
ExitCode agree(const Ranks& ranks, const std::exception_ptr& fault) {
  const int first = static_cast<int>(ranks.least(fault != nullptr ? ranks.rank() : ranks.count()));
  int code = first == ranks.rank() ? static_cast<int>(of_fault(fault)) : 0;
  MPI_Bcast(&code, 1, MPI_INT, first, ranks.communicator());
  return static_cast<ExitCode>(code);
}

ExitCode run(const SharedPlanOptions& asked, const Session& session, const Ranks& ranks) {
  std::exception_ptr fault;
  std::optional<SharedCase> shared;
  std::optional<KeptBands> kept;
  SharedPlanOptions options = asked;
  options.shared.tolerance = asked.planning_case.tolerance;
  options.shared.discount = asked.planning_case.discount;
  try {
    shared = read(options, ranks);
    if (!options.checkpoints.empty())
      kept.emplace(options.checkpoints,
                   session.settings({"--json", "--statistics", "--task", "--checkpoint-seconds", "--local-sweeps",
                                     "--limit-seconds", "--limit-memory", "--method"}),
                   *shared->band);
  } catch (...) {
    fault = std::current_exception();
  }
  if (ranks.any(fault != nullptr)) return agree(ranks, fault);
  ReplyOutput output;
  ExitCode worst = ExitCode::Done;
  std::string statistics;
  for (const auto& [place, task] : shared->tasks) {
    if (kept) kept->begin_task(place);
    const Reply reply = try_task(ranks, *shared, task, options, kept ? &*kept : nullptr, session.stop, statistics);
    worst = worse(worst, reply.code);
    if (ranks.rank() == 0) output.put(reply);
    if (ranks.rank() == 0) ReplyOutput::flush();
    if (ranks.any(session.stop.stop_requested())) return ExitCode::GaveUp;
  }
  if (!options.statistics.empty() && ranks.rank() == 0) write_file(options.statistics, statistics);
  return worst;
}

}  // namespace

Runner setup_shared_plan(Command command) {
  const auto options = std::make_shared<SharedPlanOptions>();
  command.in("Output").add_flag("--json", options->planning_case.json, "one JSON object a line");
  add_case_options(command, options->planning_case);
  command = command.in("Ranks of mpirun");
  command
      .add_option("--checkpoints", options->checkpoints,
                  "keep bounds in this directory, which all ranks see; the same command goes on from them")
      .type_name("DIR");
  command.add_option("--checkpoint-seconds", options->shared.checkpoint_seconds, "between two checkpoints")
      .not_negative()
      .show_default();
  command
      .add_option("--local-sweeps", options->shared.local_sweeps, "of a band between two exchanges with its neighbours")
      .between(1, 1000)
      .show_default();
  command
      .add_option("--statistics", options->statistics,
                  "write what every rank did for every task, JSON lines; - is standard output")
      .type_name("FILE");
  // A rank that fails alone ends the job: the others would wait for it.
  return [options](const Session& session) {
    const Ranks ranks;
    try {
      return run(*options, session, ranks);
    } catch (...) {
      const ExitCode code = of_fault(std::current_exception());
      MPI_Abort(ranks.communicator(), static_cast<int>(code));
      return code;
    }
  };
}

}  // namespace waymark::tools
