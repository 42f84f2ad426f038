// waymark plan: formula or automaton, and a map → a certified route of least cost.
#include <algorithm>
#include <cctype>
#include <iostream>
#include <memory>
#include <string_view>

#include "libautomata/hoa/finite.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"
#include "libplan/behavior_tree.hpp"
#include "libplan/model/formats/read_model.hpp"
#include "tools/answer.hpp"
#include "tools/picture.hpp"
#include "tools/plan_case.hpp"
#include "tools/plan_properties.hpp"
#include "tools/plan_roads.hpp"
#include "tools/plan_walk.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/noise.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct PlanCommandOptions {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, automaton, svg, hoa, tree, semantics = "finite";
  bool json = false;
  CaseChoice planning_case;
  NoiseOptions noise;
};

bool is_infinite(const PlanCommandOptions& options) { return options.semantics == "infinite"; }

// Does a formula say what holds again and again (G F), or for ever from some time on (F G)? Over finite words, both
// speak of the end alone.
bool speaks_of_ever(ltl::Formula formula) {
  const auto subformulas = ltl::subformulas(formula);
  return std::any_of(subformulas.begin(), subformulas.end(), [](ltl::Formula f) {
    return (is_always(f) && is_eventually(f[1])) || (is_eventually(f) && is_always(f[1]));
  });
}

// A text of words alone that is no formula: most likely English.
bool is_english(const std::string& text) {
  const auto is_word = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 ||
           std::string_view(" ',.").find(c) != std::string_view::npos;
  };
  const bool is_formula =
      text.size() > 1 && text[1] == ' ' && std::string_view("FGXN").find(text[0]) != std::string_view::npos;
  return !is_formula && std::count(text.begin(), text.end(), ' ') >= 2 &&
         std::all_of(text.begin(), text.end(), is_word);
}

class Planning {
 public:
  explicit Planning(const PlanCommandOptions& options)
      : options_(options), map_(read_map(options.map)), starts_(start_poses(options.start, map_)) {
    load_ = watch_.lap();
  }

  ExitCode of_formula(const Text& text, const Session& session, const TextStreams& streams) const {
    StopWatch watch;
    ltl::Arena arena(map_.vocabulary());
    const ltl::Formula formula = formula_of(text, arena, streams);
    if (is_infinite(options_)) return plan_lasso(task(formula, nullptr), walk_options(), session, streams.out);
    if (speaks_of_ever(formula) && !options_.json)
      streams.notes
          << "note: read over finite words, where G F and F G speak of the end of the route; --semantics infinite "
             "plans for ever\n";
    const automata::Dfa dfa = translate(formula, session.stop);
    if (options_.planning_case.top > 1)
      return plan_routes(task(formula, nullptr), dfa, walk_options(watch.lap()), session, streams.out);
    return answer(dfa, formula, watch.lap(), session, streams.out);
  }

  ExitCode of_automaton(const std::string& file, const Session& session, std::ostream& out) const {
    StopWatch watch;
    const plan::GivenAutomaton given = plan::read_given_automaton(read_file(file), source_name(file));
    const auto* dfa = std::get_if<automata::Dfa>(&given);
    if (dfa == nullptr || is_infinite(options_))
      return plan_lasso(task(std::nullopt, &given), walk_options(), session, out);
    if (options_.planning_case.top > 1)
      return plan_routes(task(std::nullopt, nullptr), *dfa, walk_options(watch.lap()), session, out);
    return answer(*dfa, std::nullopt, watch.lap(), session, out);
  }

 private:
  ltl::Formula formula_of(const Text& text, ltl::Arena& arena, const TextStreams& streams) const {
    try {
      return parse_on_map(text, arena, options_.notation, options_.map.map);
    } catch (const ltl::SyntaxError&) {
      if (is_english(text.text))
        streams.notes << "note: waymark run and waymark ground read English; waymark map lists what a map knows\n";
      throw;
    }
  }
  WalkTask task(std::optional<ltl::Formula> formula, const plan::GivenAutomaton* given) const {
    return {map_, starts_, formula, given};
  }
  WalkOptions walk_options(double translating = 0) const {
    return {options_.planning_case.order,
            options_.svg,
            options_.planning_case.top,
            options_.json,
            load_,
            translating,
            {},
            false,
            options_.tree};
  }
  ExitCode answer(const automata::Dfa& dfa, std::optional<ltl::Formula> formula, double translating,
                  const Session& session, std::ostream& out) const {
    Answer answer{.formula = formula, .corridor_run = run_corridor(map_, dfa, formula, starts_, session.stop)};
    answer.corridor_run.seconds.load = load_;
    answer.corridor_run.seconds.translate = translating;
    if (options_.json)
      out << json_of(answer, map_).text() << '\n';
    else
      print(out, session.out, answer, map_);
    if (!options_.hoa.empty())
      write_file(options_.hoa, automata::write_hoa(dfa, {.name = formula ? ltl::print(*formula) : ""}));
    const std::optional<ShownRoute> route = shown(answer.corridor_run);
    if (route && !options_.tree.empty())
      write_file(options_.tree, plan::write_behavior_tree(trajectory_of(*route, map_), map_,
                                                          formula ? ltl::print(*formula) : "automaton"));
    if (!options_.svg.empty())
      draw({.map = &map_, .dfa = &dfa, .formula = formula, .route = route}, options_.svg, session.stop);
    return route ? ExitCode::Done : ExitCode::No;
  }

  const PlanCommandOptions& options_;
  StopWatch watch_;
  plan::Map map_;
  std::vector<plan::PoseId> starts_;
  double load_;
};

bool gives_formula(const PlanCommandOptions& options) {
  return !options.text.arguments.empty() || !options.text.file.empty();
}

plan::PlanningCase noisy_map(const PlanCommandOptions& options) {
  const plan::Map map = read_map(options.map);
  const auto starts = start_poses(options.start, map);
  if (starts.size() > 1) throw UsageError("a model starts in one pose: give --start with a heading");
  return {map.name(), plan::mdp_of(map, starts[0], noise_of(options.noise)), {}};
}

// What goes with one way of planning only.
void check(const PlanCommandOptions& options) {
  const CaseChoice& choice = options.planning_case;
  if (!options.automaton.empty() && gives_formula(options)) throw UsageError("give a formula or --automaton, not both");
  const bool map = choice.file.empty() && choice.model.empty();
  if (!map && (is_infinite(options) || !options.svg.empty() || !options.hoa.empty()))
    throw UsageError("--semantics, --svg and --hoa are for plans on a map");
  if (!map && !options.tree.empty()) throw UsageError("--behavior-tree is for plans on a map");
  if (!map && options.noise.given()) throw UsageError("--slip and --slip-turn are for maps");
  if (map && options.noise.given()) {
    if (is_infinite(options) || choice.top > 1 || !options.svg.empty() || !options.hoa.empty() || !options.tree.empty())
      throw UsageError("where actions may slip there is no route: a value is asked for by --query");
    return;
  }
  if (map && !choice.query.empty())
    throw UsageError("--query asks for a value where actions may fail: give --slip, --case or --model with it");
  if (map && !choice.strategy.empty()) throw UsageError("--strategy goes with --case and --model");
  if (choice.model.empty() && (choice.strategy_format != "waymark" || !choice.scheduler.empty()))
    throw UsageError("--strategy-format prism and storm, and --scheduler, go with --model");
  if (choice.model.empty() && !(choice.constants + choice.rewards + choice.properties).empty())
    throw UsageError("--const, --rewards and --properties go with --model");
  if (!choice.hierarchy.empty() && !is_road_file(choice)) throw UsageError("--hierarchy goes with --model FILE.gr");
  if (!choice.hierarchy.empty() && choice.hierarchy != "none" && !is_on_roads(choice))
    throw UsageError("--hierarchy goes with --query rmin and steps, for one route found by search");
  if (!choice.properties.empty() &&
      (gives_formula(options) || !options.automaton.empty() || !choice.query.empty() || !choice.rewards.empty() ||
       !choice.strategy.empty() || !choice.scheduler.empty() || choice.top > 1))
    throw UsageError("--properties goes with --model, --const, --tolerance and limits only: they bring what is asked");
  if (!options.tree.empty() && choice.top > 1) throw UsageError("--behavior-tree is for one plan");
  if (map && choice.top > 1 && (is_infinite(options) || !options.svg.empty() || !options.hoa.empty()))
    throw UsageError("--top is for routes, without --svg, --hoa and --semantics infinite");
  if (is_infinite(options) && !options.hoa.empty())
    throw UsageError("--hoa is for finite words; waymark translate writes automata on infinite ones");
}

ExitCode run_plan(const PlanCommandOptions& options, const Session& session) {
  check(options);
  CaseChoice choice = options.planning_case;
  choice.json = options.json;
  choice.automaton = options.automaton;
  if (!choice.file.empty()) {
    if (gives_formula(options) || !options.automaton.empty())
      throw UsageError("a planning case brings its own formulas; --model takes others");
    return plan_case(choice, session);
  }
  if (!choice.properties.empty()) return plan_properties(choice, session);
  if (is_on_roads(choice)) return plan_roads(choice, options.start, options.text, session);
  if (!choice.model.empty())
    return plan_model(read_model(choice, options.start, session.stop), choice, options.text, session);
  if (options.noise.given()) return plan_model(noisy_map(options), choice, options.text, session);
  if (!options.automaton.empty()) {
    const Planning planning(options);
    return answer_in_parallel(1, session.stop, choice.parallel, [&](std::size_t, const TextWatch& watch) -> Reply {
      return {within(watch, choice.parallel.limits, [&] {
        return planning.of_automaton(options.automaton, {watch.token(), session.out}, std::cout);
      })};
    });
  }
  TextReader texts(options.text, "formula");
  if (texts.is_batch() && (!options.svg.empty() || !options.hoa.empty() || !options.tree.empty()))
    throw UsageError("--svg, --hoa and --behavior-tree are for a single formula given as an argument");
  const Planning planning(options);
  return answer_each(
      texts, session, choice.parallel,
      [&](const Text& text, const Session& limited, const TextStreams& streams) {
        return planning.of_formula(text, limited, streams);
      },
      options.json);
}

}  // namespace

Runner setup_plan(Command command) {
  const auto options = std::make_shared<PlanCommandOptions>();
  add_text_options(command, options->text, "formula");
  command.add_option("--automaton", options->automaton, "an automaton in HOA instead of a formula; - is standard input")
      .type_name("FILE");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  command.in("Output").add_flag("--json", options->json, "one JSON object a line");
  command.in("Output").add_option("--svg", options->svg, "draw map, route and automaton").type_name("FILE");
  command.in("Output").add_option("--hoa", options->hoa, "write the automaton").type_name("FILE");
  command.in("Output")
      .add_option("--behavior-tree", options->tree, "write the plan for BehaviorTree.CPP 4")
      .type_name("FILE");
  command
      .add_option("--semantics", options->semantics,
                  "on a map: a route to where the formula holds, or a lasso, a route without end that it holds on")
      .one_of({"finite", "infinite"})
      .show_default();
  add_noise_options(command, options->noise);
  add_case_options(command, options->planning_case);
  return [options](const Session& session) { return run_plan(*options, session); };
}

}  // namespace waymark::tools
