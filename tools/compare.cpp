// waymark compare: exact search, value iteration and learners on one task, or on a suite of tasks.
#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <ctime>
#include <iostream>
#include <memory>
#include <thread>

#include "libltl/print.hpp"
#include "libparser/parallel.hpp"
#include "libplan/solve/route_planner.hpp"
#include "tools/answer.hpp"
#include "tools/comparing.hpp"
#include "tools/render/learning_curves.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/noise.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, svg;
  NoiseOptions noise;
  std::vector<std::string> methods;
  Protocol protocol;
  int threads = 0;  // one for each core
  bool json = false;
};

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

int threads_of(const Options& options) {
  if (options.threads > 0) return options.threads;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

class Comparing {
 public:
  Comparing(const Options& options, const Session& session)
      : options_(options),
        session_(session),
        methods_(chosen_methods(options.methods)),
        noise_(noise_of(options.noise)),
        map_(read_map(options.map)),
        starts_(start_poses(options.start, map_)),
        verdicts_(methods_.size()) {}

  ExitCode one(const Text& text, bool is_single) {
    ltl::Arena arena(map_.vocabulary());
    const ltl::Formula formula =
        parse_formula(text, arena, parse_options(options_.notation, ltl::Unknown::Reject));
    const automata::Dfa dfa = translate(formula, session_.stop);
    const bool gltl = std::any_of(methods_.begin(), methods_.end(), [](const plan::Method& method) {
      return std::holds_alternative<plan::GltlMethod>(method.how);
    });
    const plan::LearningTask task(map_, dfa, formula, starts_,
                                  {.noise = noise_, .discount = options_.protocol.discount, .gltl = gltl});
    ComparedTask compared{formula, map_.name()};
    describe(compared, task, dfa);
    if (compared.optimum.probability > 0) add_exact(compared);
    if (compared.optimum.probability > 0 && !compared.is_over) run_methods(compared, task);
    ++tasks_;
    if (options_.json)
      std::cout << json_of(compared, options_.protocol).text() << '\n';
    else
      print(std::cout, session_.out, compared, options_.protocol);
    if (is_single && !options_.svg.empty()) draw(compared);
    return compared.optimum.probability > 0 ? ExitCode::Done : ExitCode::No;
  }

  void suite() const {
    std::vector<MethodRuns> pooled;
    for (std::size_t i = 0; i < exact_methods.size(); ++i)
      if (!exact_seconds_[i].empty()) pooled.push_back(exact(exact_methods[i], exact_seconds_[i]));
    for (std::size_t i = 0; i < methods_.size(); ++i)
      if (!verdicts_[i].empty()) pooled.push_back({methods_[i].name, plan::summarise(verdicts_[i]), {}});
    if (options_.json)
      std::cout << json_of_suite(pooled, tasks_, options_.protocol).text() << '\n';
    else
      print_suite(std::cout, pooled, tasks_, options_.protocol);
  }

 private:
  // What is exact needs no steps and has no spread; its cost is that of the optimum.
  static MethodRuns exact(std::string_view name, const std::vector<double>& seconds) {
    plan::Summary summary;
    summary.success = summary.score = summary.cost_ratio = summary.optimal = {1, 1, 1};
    summary.runs = seconds.size();
    summary.seconds = plan::median(seconds);
    return {std::string(name), summary, {}};
  }

  void add_exact(ComparedTask& compared) {
    const auto add = [&](std::size_t i, double seconds) {
      if (!options_.methods.empty() && !is_named(options_.methods, exact_methods[i])) return;
      compared.methods.push_back(exact(exact_methods[i], {seconds}));
      exact_seconds_[i].push_back(seconds);
    };
    if (compared.search) add(0, compared.search->seconds);
    add(1, compared.seconds_of_optimum);
  }

  void describe(ComparedTask& compared, const plan::LearningTask& task, const automata::Dfa& dfa) const {
    for (const plan::PoseId start : starts_) compared.starts.push_back(map_.pose(start));
    compared.automaton_states = dfa.states();
    compared.product_states = task.product().states();
    compared.optimum = task.optimum().value;
    compared.seconds_of_optimum = task.seconds_of_optimum();
    compared.sweeps = task.optimum().sweeps;
    compared.is_over = task.product().is_over();
    if (noise_ == plan::MapNoise{}) compared.search = search(dfa);
    if (compared.search && starts_.size() == 1 && compared.search->cost != compared.optimum.cost)
      throw std::logic_error("search and value iteration disagree on " + ltl::print(compared.formula));
  }

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
    searched.seconds = watch.lap();
    return searched;
  }

  plan::Training training_of(const plan::Method& method, std::size_t run) const {
    const Protocol& protocol = options_.protocol;
    plan::Training training{.steps = protocol.steps,
                            .interval = protocol.interval,
                            .horizon = protocol.horizon,
                            .discount = protocol.discount,
                            .seed = run + 1,
                            .stop = session_.stop};
    if (!std::holds_alternative<plan::DqnMethod>(method.how)) return training;
    training.explore = 1;  // a network is not optimistic: it explores at random first, over half of the steps
    training.explore_steps = protocol.steps / 2;
    return training;
  }

  void run_methods(ComparedTask& compared, const plan::LearningTask& task) {
    std::vector<std::size_t> allowed;  // places in methods_
    for (std::size_t i = 0; i < methods_.size(); ++i) {
      if (task.allows(methods_[i]))
        allowed.push_back(i);
      else
        complain("note", methods_[i].name + " is left out: it takes one start and few temporal operators");
    }
    const std::size_t seeds = options_.protocol.seeds, jobs = allowed.size() * seeds;
    std::vector<plan::LearningCurve> curves(jobs);
    std::vector<double> seconds(jobs);
    ProgressBar bar;
    parser::run_jobs(
        jobs, threads_of(options_), [&](double fraction, std::string_view what) { bar.show(fraction, what); },
        "learning",
        [&](std::size_t job, const parser::JobProgress& progress) {
          const plan::Method& method = methods_[allowed[job / seeds]];
          const double begin = thread_seconds();
          curves[job] = task.run(method, training_of(method, job % seeds));
          seconds[job] = thread_seconds() - begin;
          progress(1);
        });
    bar.wipe();
    if (session_.stop.stop_requested()) throw Interrupted();
    for (std::size_t k = 0; k < allowed.size(); ++k)
      summarise(compared, allowed[k], {curves.data() + k * seeds, seeds},
                {seconds.data() + k * seeds, seeds});
  }

  void summarise(ComparedTask& compared, std::size_t method, std::span<const plan::LearningCurve> curves,
                 std::span<const double> seconds) {
    std::vector<plan::Verdict> verdicts;
    for (std::size_t k = 0; k < curves.size(); ++k)
      verdicts.push_back(plan::judge(curves[k], compared.optimum, seconds[k]));
    compared.methods.push_back(
        {methods_[method].name, plan::summarise(verdicts), plan::mean_curve(curves, compared.optimum)});
    verdicts_[method].insert(verdicts_[method].end(), verdicts.begin(), verdicts.end());
  }

  void draw(const ComparedTask& compared) const {
    render::CurvePlot plot{ltl::print(compared.formula),
                           "map " + map_.name() + ", " + counted(options_.protocol.seeds, "seed") +
                               ", means with 95 % intervals, optimal cost " +
                               shown_cost(compared.optimum.cost),
                           {}};
    for (const MethodRuns& method : compared.methods) {
      if (method.curve.empty()) continue;  // exact
      render::Curve curve{method.name, {}};
      for (const plan::CurvePoint& p : method.curve)
        curve.points.push_back({static_cast<double>(p.steps), p.score.value, p.score.low, p.score.high});
      plot.curves.push_back(std::move(curve));
    }
    write_file(options_.svg, render::draw_curves(plot));
  }

  const Options& options_;
  const Session& session_;
  std::vector<plan::Method> methods_;
  plan::MapNoise noise_;
  plan::Map map_;
  std::vector<plan::PoseId> starts_;
  std::vector<std::vector<plan::Verdict>> verdicts_;                     // by method, of all tasks
  std::array<std::vector<double>, exact_methods.size()> exact_seconds_;  // of all tasks
  std::size_t tasks_ = 0;
};

ExitCode run_compare(const Options& options, const Session& session) {
  TextReader texts(options.text, "formula");
  if (texts.is_batch() && !options.svg.empty())
    throw UsageError("--svg is for a single formula given as an argument");
  if (!(options.protocol.discount > 0 && options.protocol.discount < 1))
    throw UsageError("--discount lies between 0 and 1");
  Comparing comparing(options, session);
  const ExitCode code = answer_each(
      texts, session.stop, [&](const Text& text) { return comparing.one(text, !texts.is_batch()); },
      [&](const Text& text, const std::string& message) {
        if (options.json) std::cout << json_error(text.line, message).text() << '\n';
      });
  if (texts.is_batch()) comparing.suite();
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

Runner setup_compare(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  Protocol& protocol = options->protocol;
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  const auto count = CLI::Range(std::size_t{1}, std::size_t{1'000'000'000});
  command.add_option("--methods", options->methods, method_names())
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,...");
  command.add_option("--seeds", protocol.seeds, "runs of each learner")->check(count)->capture_default_str();
  command.add_option("--steps", protocol.steps, "of the environment, in each run")
      ->check(count)
      ->capture_default_str();
  command.add_option("--interval", protocol.interval, "steps between two exact evaluations of the policy")
      ->check(count)
      ->capture_default_str();
  command.add_option("--horizon", protocol.horizon, "steps of an episode before it is cut")
      ->check(count)
      ->capture_default_str();
  command.add_option("--discount", protocol.discount, "of the return that learners maximise")
      ->capture_default_str();
  add_noise_options(command, options->noise);
  command
      .add_option("--threads", options->threads,
                  "runs at a time (else one for each core); no influence on what they learn")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--json", options->json, "one JSON object a line");
  command.add_option("--svg", options->svg, "draw the learning curves")->type_name("FILE");
  return [options](const Session& session) { return run_compare(*options, session); };
}

}  // namespace waymark::tools
