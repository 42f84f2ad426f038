// waymark compare: exact search, value iteration and learners on one task, or on a suite of tasks.
#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <sstream>

#include "libltl/print.hpp"
#include "libparser/parallel.hpp"
#include "libplan/solve/shortest_route.hpp"
#include "tools/answer.hpp"
#include "tools/comparing.hpp"
#include "tools/render/learning_curves.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, svg, slip;
  std::vector<std::string> methods;
  Protocol protocol;
  int threads = 1;
  bool json = false;
};

std::vector<plan::Method> chosen_methods(const std::vector<std::string>& names) {
  std::vector<plan::Method> chosen;
  ltl::Vocabulary known;
  for (const plan::Method& method : plan::learning_methods()) {
    known.add(method.name);
    const bool named = std::find(names.begin(), names.end(), method.name) != names.end() ||
                       std::find(names.begin(), names.end(), "all") != names.end();
    if (names.empty() ? method.by_default : named) chosen.push_back(method);
  }
  for (const std::string& name : names) {
    if (known.find(name) || name == "all") continue;
    const auto nearest = known.nearest(name);
    throw UsageError("there is no method '" + name + "'" +
                     (nearest ? " (did you mean '" + *nearest + "'?)" : "; see waymark compare --help"));
  }
  return chosen;
}

// "0.1,0.1" or "0.1,0.1,0.05": the chances that FORWARD goes left, right and back.
plan::SlipChances slip_of(const std::string& text) {
  if (text.empty()) return {};
  std::array<double, 3> chance{};
  std::istringstream in(text);
  std::size_t count = 0;
  for (std::string part; count < 3 && std::getline(in, part, ','); ++count) {
    std::istringstream number(part);
    if (!(number >> chance[count]) || !number.eof())
      throw UsageError("--slip takes LEFT,RIGHT or LEFT,RIGHT,BACK");
  }
  const double forward = 1 - chance[0] - chance[1] - chance[2];
  if (count < 2 || !in.eof() || !(forward > 0) || *std::min_element(chance.begin(), chance.end()) < 0)
    throw UsageError("--slip takes two or three chances that leave something for going forward");
  return {.forward = forward, .left = chance[0], .right = chance[1], .back = chance[2]};
}

class Comparing {
 public:
  Comparing(const Options& options, const Session& session)
      : options_(options),
        session_(session),
        methods_(chosen_methods(options.methods)),
        slip_(slip_of(options.slip)),
        map_(read_map(options.map)),
        starts_(start_poses(options.start, map_)),
        verdicts_(methods_.size()) {}

  ExitCode one(const Text& text, bool is_single) {
    ltl::Arena arena(map_.vocabulary());
    const ltl::Formula formula =
        parse_formula(text, arena, parse_options(options_.notation, ltl::Unknown::Reject));
    const automata::Dfa dfa = translate(formula, session_.stop);
    const plan::LearningTask task(map_, dfa, formula, starts_, slip_, options_.protocol.discount);
    ComparedTask compared{formula, map_.name()};
    describe(compared, task, dfa);
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
    for (std::size_t i = 0; i < methods_.size(); ++i)
      if (!verdicts_[i].empty()) pooled.push_back({methods_[i].name, plan::summarise(verdicts_[i]), {}});
    if (options_.json)
      std::cout << json_of_suite(pooled, tasks_, options_.protocol).text() << '\n';
    else
      print_suite(std::cout, pooled, tasks_, options_.protocol);
  }

 private:
  void describe(ComparedTask& compared, const plan::LearningTask& task, const automata::Dfa& dfa) const {
    for (const plan::PoseId start : starts_) compared.starts.push_back(map_.pose(start));
    compared.automaton_states = dfa.states();
    compared.product_states = task.product().states();
    compared.optimum = task.optimum().value;
    compared.seconds_of_optimum = task.seconds_of_optimum();
    compared.sweeps = task.optimum().sweeps;
    compared.is_over = task.product().is_over();
    if (slip_ == plan::SlipChances{}) compared.search = search(dfa);
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
    const std::size_t seeds = options_.protocol.seeds, jobs = methods_.size() * seeds;
    std::vector<plan::LearningCurve> curves(jobs);
    std::vector<double> seconds(jobs);
    ProgressBar bar;
    parser::run_jobs(
        jobs, options_.threads, [&](double fraction, std::string_view what) { bar.show(fraction, what); },
        "learning",
        [&](std::size_t job, const parser::JobProgress& progress) {
          const plan::Method& method = methods_[job / seeds];
          StopWatch watch;
          curves[job] = task.run(method, training_of(method, job % seeds));
          seconds[job] = watch.lap();
          progress(1);
        });
    bar.wipe();
    if (session_.stop.stop_requested()) throw Interrupted();
    for (std::size_t i = 0; i < methods_.size(); ++i) {
      const std::span<const plan::LearningCurve> own{curves.data() + i * seeds, seeds};
      std::vector<plan::Verdict> verdicts;
      for (std::size_t k = 0; k < seeds; ++k)
        verdicts.push_back(plan::judge(own[k], compared.optimum, seconds[i * seeds + k]));
      compared.methods.push_back(
          {methods_[i].name, plan::summarise(verdicts), plan::mean_curve(own, compared.optimum)});
      verdicts_[i].insert(verdicts_[i].end(), verdicts.begin(), verdicts.end());
    }
  }

  void draw(const ComparedTask& compared) const {
    render::CurvePlot plot{ltl::print(compared.formula),
                           "map " + map_.name() + ", " + counted(options_.protocol.seeds, "seed") +
                               ", means with 95 % intervals, optimal cost " +
                               shortest_text(compared.optimum.cost),
                           {}};
    for (const MethodRuns& method : compared.methods) {
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
  plan::SlipChances slip_;
  plan::Map map_;
  std::vector<plan::PoseId> starts_;
  std::vector<std::vector<plan::Verdict>> verdicts_;  // by method, of all tasks
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
  std::string text = "learners, separated by commas; all, or of:";
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
  command.add_option("--slip", options->slip, "chances that FORWARD goes left, right, back instead")
      ->type_name("L,R[,B]");
  command.add_option("--threads", options->threads, "runs at a time; no influence on what they learn")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_flag("--json", options->json, "one JSON object a line");
  command.add_option("--svg", options->svg, "draw the learning curves")->type_name("FILE");
  return [options](const Session& session) { return run_compare(*options, session); };
}

}  // namespace waymark::tools
