#include "tools/compare_runs.hpp"

#include <algorithm>
#include <ctime>
#include <iostream>
#include <stdexcept>

#include "libltl/parallel.hpp"
#include "libltl/text/print.hpp"
#include "libparser/training/parallel.hpp"
#include "tools/answer.hpp"
#include "tools/render/learning_curves.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

constexpr std::array<std::string_view, 2> exact_methods{"search", "value-iteration"};

bool is_named(const std::vector<std::string>& names, std::string_view method) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return name == method || name == "all"; });
}

std::vector<plan::Method> chosen_methods(const std::vector<std::string>& names) {
  std::vector<plan::Method> chosen;
  ltl::Vocabulary known;
  for (const std::string_view exact : exact_methods) known.add(exact);
  for (const plan::Method& method : plan::learning_methods()) {
    known.add(method.name);
    if (names.empty() ? method.by_default : is_named(names, method.name)) chosen.push_back(method);
  }
  for (const std::string& name : names) {
    if (known.find(name) || name == "all") continue;
    const auto nearest = known.nearest(name);
    throw UsageError("there is no method '" + name + "'" +
                     (nearest ? " (did you mean '" + *nearest + "'?)" : "; see waymark compare --help"));
  }
  return chosen;
}

// Processor time of this thread: what a run takes does not depend on what runs beside it.
double thread_seconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

int threads_of(int asked) {
  if (asked > 0) return asked;
  return static_cast<int>(ltl::hardware_threads());
}

// What is exact needs no steps and has no spread; its cost is that of the optimum.
MethodRuns exact(std::string_view name, const std::vector<double>& seconds) {
  plan::Summary summary;
  summary.success = summary.score = summary.cost_ratio = summary.optimal = {1, 1, 1};
  summary.runs = seconds.size();
  summary.seconds = plan::median(seconds);
  return {std::string(name), summary, {}};
}

std::string why_not(const plan::Method& method, const ComparedTask& compared) {
  const auto* dqn = std::get_if<plan::DqnMethod>(&method.how);  // the others are allowed everywhere
  return !compared.formula && dqn->trees ? "it reads a formula" : "what it sees is on hallway maps only";
}

}  // namespace

Comparison::Comparison(const CompareChoice& choice, const Session& session)
    : choice_(choice), session_(session), methods_(chosen_methods(choice.methods)), verdicts_(methods_.size()) {}

plan::LearningTaskOptions Comparison::task_options() const {
  return {.noise = {}, .discount = choice_.protocol.discount};
}

ExitCode Comparison::run(ComparedTask compared, const plan::LearningTask& task, bool is_single) {
  compared.product_states = task.product().states();
  compared.optimum = task.optimum().value;
  compared.seconds_of_optimum = task.seconds_of_optimum();
  compared.sweeps = task.optimum().sweeps;
  compared.is_over = task.product().is_over();
  if (compared.search && compared.search->is_reference && compared.search->cost != compared.optimum.cost)
    throw std::logic_error("search and value iteration disagree on " + title_of(compared));
  if (compared.optimum.probability > 0) add_exact(compared);
  if (compared.optimum.probability > 0 && !compared.is_over) run_methods(compared, task);
  ++tasks_;
  if (choice_.json)
    std::cout << json_of(compared, choice_.protocol).text() << '\n';
  else
    print(std::cout, session_.out, compared, choice_.protocol);
  if (is_single && !choice_.svg.empty()) draw(compared);
  return compared.optimum.probability > 0 ? ExitCode::Done : ExitCode::No;
}

void Comparison::suite() const {
  std::vector<MethodRuns> pooled;
  for (std::size_t i = 0; i < exact_methods.size(); ++i)
    if (!exact_seconds_[i].empty()) pooled.push_back(exact(exact_methods[i], exact_seconds_[i]));
  for (std::size_t i = 0; i < methods_.size(); ++i)
    if (!verdicts_[i].empty()) pooled.push_back({methods_[i].name, plan::summarise(verdicts_[i]), {}});
  if (choice_.json)
    std::cout << json_of_suite(pooled, tasks_, choice_.protocol).text() << '\n';
  else
    print_suite(std::cout, pooled, tasks_, choice_.protocol);
}

void Comparison::add_exact(ComparedTask& compared) {
  const auto add = [&](std::size_t i, double seconds) {
    if (!choice_.methods.empty() && !is_named(choice_.methods, exact_methods[i])) return;
    compared.methods.push_back(exact(exact_methods[i], {seconds}));
    exact_seconds_[i].push_back(seconds);
  };
  if (compared.search) add(0, compared.search->seconds);
  add(1, compared.seconds_of_optimum);
}

void Comparison::run_methods(ComparedTask& compared, const plan::LearningTask& task) {
  std::vector<std::size_t> allowed;  // places in methods_
  for (std::size_t i = 0; i < methods_.size(); ++i) {
    if (task.allows(methods_[i]))
      allowed.push_back(i);
    else
      complain("note", methods_[i].name + " is left out: " + why_not(methods_[i], compared));
  }
  const std::size_t seeds = choice_.protocol.seeds, jobs = allowed.size() * seeds;
  std::vector<plan::LearningCurve> curves(jobs);
  std::vector<double> seconds(jobs);
  ProgressBar bar;
  parser::run_jobs(
      jobs, threads_of(choice_.threads), [&](double fraction, std::string_view what) { bar.show(fraction, what); },
      "learning",
      [&](std::size_t job, const parser::JobProgress& progress) {
        const plan::Method& method = methods_[allowed[job / seeds]];
        const double begin = thread_seconds();
        curves[job] = task.run(method, training_of(method, choice_.protocol, job % seeds, session_.stop));
        seconds[job] = thread_seconds() - begin;
        progress(1);
      });
  bar.wipe();
  if (session_.stop.stop_requested()) throw Interrupted();
  for (std::size_t k = 0; k < allowed.size(); ++k)
    summarise(compared, allowed[k], {curves.data() + k * seeds, seeds}, {seconds.data() + k * seeds, seeds});
}

void Comparison::summarise(ComparedTask& compared, std::size_t method, std::span<const plan::LearningCurve> curves,
                           std::span<const double> seconds) {
  std::vector<plan::Verdict> verdicts;
  for (std::size_t k = 0; k < curves.size(); ++k)
    verdicts.push_back(plan::judge(curves[k], compared.optimum, seconds[k]));
  compared.methods.push_back(
      {methods_[method].name, plan::summarise(verdicts), plan::mean_curve(curves, compared.optimum)});
  verdicts_[method].insert(verdicts_[method].end(), verdicts.begin(), verdicts.end());
}

void Comparison::draw(const ComparedTask& compared) const {
  render::CurvePlot plot{title_of(compared),
                         "map " + compared.map + ", " + counted(choice_.protocol.seeds, "seed") +
                             ", means with 95 % intervals, optimal cost " + shown_cost(compared.optimum.cost),
                         {}};
  for (const MethodRuns& method : compared.methods) {
    if (method.curve.empty()) {
      plot.exact.push_back(method.name);
      continue;
    }
    render::Curve curve{method.name, {}};
    for (const plan::CurvePoint& p : method.curve)
      curve.points.push_back({static_cast<double>(p.steps), p.score.value, p.score.low, p.score.high});
    plot.curves.push_back(std::move(curve));
  }
  write_file(choice_.svg, render::draw_curves(plot));
}

}  // namespace waymark::tools
