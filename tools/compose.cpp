// waymark compose: formula or automaton, and a map or any model → their product, its sizes or its graph.
#include <boost/range/iterator_range.hpp>
#include <iostream>
#include <memory>
#include <sstream>

#include "libautomata/hoa/finite.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/print.hpp"
#include "libplan/model/formats/read_model.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/product/compose.hpp"
#include "tools/answer.hpp"
#include "tools/compose_model.hpp"
#include "tools/product_picture.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct ComposeOptions {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, automaton, file, task;
  bool model_only = false;
  GraphOutput output;
  ParallelOptions parallel;
};

struct Counts {
  std::size_t accepting = 0, traps = 0;
};

Counts count(const plan::MapProduct& product) {
  Counts counts;
  for (const plan::ProductState& v : boost::make_iterator_range(vertices(product))) {
    counts.accepting += product.is_accepting(v) ? 1 : 0;
    counts.traps += product.is_trap(v) ? 1 : 0;
  }
  return counts;
}

Json product_json(const plan::MapProduct& product, std::optional<ltl::Formula> formula) {
  const Counts counts = count(product);
  return JsonObject()
      .add("formula", formula ? Json(ltl::print(*formula)) : Json())
      .add("map", product.map().name())
      .add("automaton", json_of(size_of(product.dfa())))
      .add("product", JsonObject()
                          .add("states", num_vertices(product))
                          .add("edges", num_edges(product))
                          .add("starts", product.starts().size())
                          .add("accepting", counts.accepting)
                          .add("traps", counts.traps));
}

void print_text(const plan::MapProduct& product, std::optional<ltl::Formula> formula, const Terminal& terminal,
                std::ostream& out) {
  const Counts counts = count(product);
  if (formula) out << "formula    " << shown(*formula, terminal) << '\n';
  out << "automaton  " << counted(product.dfa().states(), "state") << '\n'
      << "product    " << counted(num_vertices(product), "state") << " (" << counts.accepting << " accepting, "
      << counts.traps << " without hope), " << counted(num_edges(product), "edge") << ", with the map "
      << product.map().name() << '\n';
}

void print_dot(const plan::MapProduct& product, std::ostream& out) {
  out << "digraph product {\n  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=11];\n"
      << "  edge [fontname=\"Helvetica\", fontsize=10];\n";
  for (const plan::ProductState& v : boost::make_iterator_range(vertices(product))) {
    out << "  " << product.index(v) << " [label=\"" << product.model().name(v.place) << " · " << v.task << '"'
        << (product.is_accepting(v) ? ", peripheries=2" : "") << (product.is_trap(v) ? ", color=gray70" : "") << "];\n";
  }
  for (std::size_t i = 0; i < product.starts().size(); ++i)
    out << "  start" << i << " [shape=point]; start" << i << " -> " << product.index(product.starts()[i]) << ";\n";
  for (const plan::ProductState& v : boost::make_iterator_range(vertices(product)))
    for (auto [e, end] = out_edges(v, product); e != end; ++e)
      out << "  " << product.index(v) << " -> " << product.index(e->to) << " [label=\""
          << plan::name(product.action(*e)) << "\"];\n";
  out << "}\n";
}

void answer(const plan::MapProduct& product, std::optional<ltl::Formula> formula, const ComposeOptions& options,
            const Session& session, std::ostream& out) {
  if (options.output.format == "json")
    out << product_json(product, formula).text() << '\n';
  else if (options.output.format == "dot")
    print_dot(product, out);
  else
    print_text(product, formula, session.out, out);
  if (!options.output.svg.empty()) draw_product(picture_of(product), options.output.svg, session.stop);
}

plan::MapProduct composed(const plan::Map& map, const automata::Dfa& dfa, std::span<const plan::PoseId> starts,
                          const Session& session) {
  std::optional<plan::MapProduct> product = plan::compose(map, dfa, starts, {.states = SIZE_MAX, .stop = session.stop});
  if (!product) throw Interrupted();
  return std::move(*product);
}

// ---- any model: what solvers work on

bool gives_formula(const ComposeOptions& options) {
  return !options.text.arguments.empty() || !options.text.file.empty();
}

// Of a map a model, of a file what it holds.
plan::PlanningCase model_of(const ComposeOptions& options, const std::stop_token& stop) {
  try {
    if (!options.file.empty()) return plan::read_model(options.file, options.start, {.stop = stop});
  } catch (const plan::ReadingStopped&) {
    throw Interrupted();
  }
  const plan::Map map = read_map(options.map);
  const auto starts = start_poses(options.start, map);
  if (starts.size() > 1) throw UsageError("a model starts in one pose: give --start with a heading");
  return {map.name(), plan::mdp_of(map, starts[0]), {}};
}

ltl::Arena arena_of(const plan::PlanningCase& model) {
  return std::visit([](const auto& m) { return ltl::Arena(m.letters().vocabulary()); }, model.model);
}

void compose_task(const plan::PlanningCase& model, const plan::CaseTask& task, const ComposeOptions& options,
                  const Session& session, std::ostream& out) {
  if (!task.fault.empty()) throw UsageError("task " + task.id + ": " + task.fault);
  ltl::Arena arena = arena_of(model);
  ltl::Formula f = ltl::parse(task.formula, arena);
  if (options.output.is_game()) {
    if (task.logic != plan::CaseTask::Logic::Ltl)
      throw UsageError("a game is about infinite words: task " + task.id + " is not");
    return write_game(model, f, options.output, session.stop, out);
  }
  if (task.logic == plan::CaseTask::Logic::Ltl) f = ltl::simplify(f, ltl::Semantics::Infinite);
  if (task.query == plan::CaseTask::Query::MinProbability && !plan::is_finite_task(f, task.logic))
    f = ltl::simplify(ltl::negate(f), ltl::Semantics::Infinite);
  const auto automaton = plan::task_automaton(f, task.logic, task.query, {.stop = session.stop});
  if (!automaton) throw GaveUp("no automaton of task " + task.id);
  write_product(model, *automaton, {task.id, ltl::print(f)}, options.output, session.stop, out);
}

// The tasks of the file that were asked for and have an automaton: a tour has none.
ExitCode compose_tasks(const plan::PlanningCase& model, const ComposeOptions& options, const Session& session) {
  std::vector<const plan::CaseTask*> chosen;
  for (const plan::CaseTask& task : model.tasks)
    if ((options.task.empty() || options.task == task.id) && task.query != plan::CaseTask::Query::MinCycle)
      chosen.push_back(&task);
  if (chosen.empty())
    throw UsageError(options.file + " has no " + (options.task.empty() ? "tasks" : "task '" + options.task + "'") +
                     " with an automaton; give a formula, or --model-only");
  const bool one = options.output.writes_model() || !options.output.svg.empty();
  if (one && chosen.size() > 1) throw UsageError("one product at a time in this format: choose by --task");
  const bool alone = chosen.size() == 1;
  return answer_in_parallel(
      chosen.size(), session.stop, options.parallel, [&](std::size_t job, const TextWatch& watch) -> Reply {
        std::ostringstream kept;
        const Session own{watch.token(), session.out};
        return {within(watch, options.parallel.limits,
                       [&] {
                         compose_task(model, *chosen[job], options, own, alone ? std::cout : kept);
                         return ExitCode::Done;
                       }),
                kept.str()};
      });
}

ExitCode compose_any(const ComposeOptions& options, const Session& session) {
  const plan::PlanningCase model = model_of(options, session.stop);
  if (options.model_only) {
    if (gives_formula(options) || !options.automaton.empty())
      throw UsageError("--model-only goes without a formula or automaton");
    if (options.output.is_game()) throw UsageError("--format pgsolver is about a formula: a game has a winner");
    write_model(model, options.output, std::cout);
    return ExitCode::Done;
  }
  if (!options.automaton.empty()) {
    if (options.output.is_game()) throw UsageError("--format pgsolver takes a formula");
    const plan::GivenAutomaton given =
        plan::read_given_automaton(read_file(options.automaton), source_name(options.automaton));
    const auto automaton = plan::task_automaton(given, plan::CaseTask::Query::MaxProbability, {.stop = session.stop});
    if (!automaton) throw GaveUp("no automaton for decision processes within the limits");
    write_product(model, *automaton, {}, options.output, session.stop, std::cout);
    return ExitCode::Done;
  }
  if (!options.file.empty() && !gives_formula(options)) return compose_tasks(model, options, session);
  TextReader texts(options.text, "formula");
  if (texts.is_batch() && !options.output.out.empty()) throw UsageError("--out is for a single formula");
  if (texts.is_batch() && !options.output.svg.empty()) throw UsageError("--svg is for a single formula");
  return answer_each(
      texts, session, options.parallel,
      [&](const Text& text, const Session& own, const TextStreams& streams) {
        ltl::Arena arena = arena_of(model);
        const ltl::Formula formula = parse_formula(text, arena, parse_options(options.notation, ltl::Unknown::Reject));
        if (options.output.is_game()) {
          write_game(model, formula, options.output, own.stop, streams.out);
          return ExitCode::Done;
        }
        const plan::TaskAutomaton dfa = translate(formula, own.stop);
        write_product(model, dfa, {"", ltl::print(formula)}, options.output, own.stop, streams.out);
        return ExitCode::Done;
      },
      options.output.format == "json");
}

ExitCode run_compose(const ComposeOptions& options, const Session& session) {
  if (!options.automaton.empty() && gives_formula(options)) throw UsageError("give a formula or --automaton, not both");
  if (!options.output.out.empty() && !options.output.writes_model())
    throw UsageError("--out goes with --format prism, explicit, jani and pgsolver");
  if (!options.output.svg.empty() && options.model_only)
    throw UsageError("--svg draws a product; --format dot a model");
  if (!options.task.empty() && options.file.empty()) throw UsageError("--task goes with --case");
  if (!options.file.empty() || options.model_only || options.output.graph || options.output.writes_model())
    return compose_any(options, session);
  const plan::Map map = read_map(options.map);
  const auto starts = start_poses(options.start, map);
  if (!options.automaton.empty()) {
    const automata::Dfa dfa = automata::read_hoa(read_file(options.automaton), source_name(options.automaton));
    answer(composed(map, dfa, starts, session), std::nullopt, options, session, std::cout);
    return ExitCode::Done;
  }
  TextReader texts(options.text, "formula");
  if (texts.is_batch() && !options.output.svg.empty()) throw UsageError("--svg is for a single formula");
  return answer_each(
      texts, session, options.parallel,
      [&](const Text& text, const Session& own, const TextStreams& streams) {
        ltl::Arena arena(map.vocabulary());
        const ltl::Formula formula = parse_on_map(text, arena, options.notation, options.map.map);
        const automata::Dfa dfa = translate(formula, own.stop);
        answer(composed(map, dfa, starts, own), formula, options, own, streams.out);
        return ExitCode::Done;
      },
      options.output.format == "json");
}

}  // namespace

Runner setup_compose(Command command) {
  const auto options = std::make_shared<ComposeOptions>();
  add_text_options(command, options->text, "formula");
  command.add_option("--automaton", options->automaton, "an automaton in HOA instead of a formula; - is standard input")
      .type_name("FILE");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  command
      .add_option("--case,--model", options->file,
                  "another model instead of a map: a planning case with its tasks, roads (FILE.osm, FILE.geojson, "
                  "FILE.graphml), a street graph (JSON), PRISM's FILE.nm or FILE.tra, a transition system (YAML)")
      .type_name("FILE");
  command.add_option("--task", options->task, "with --case: this task only").type_name("ID");
  command.add_flag("--model-only", options->model_only, "the map or model itself, without a task");
  command
      .add_option("--format", options->output.format,
                  "sizes for people, sizes as JSON, or the graph: for Graphviz, in PRISM's language, as PRISM's "
                  "explicit files, as JANI; as the parity game of infinite words")
      .one_of({"text", "json", "dot", "prism", "explicit", "jani", "dimacs", "pgsolver"})
      .show_default();
  command.add_flag("--graph", options->output.graph, "with --format json: states and choices as well");
  command
      .add_option(
          "--out", options->output.out,
          "write PREFIX.nm (prism), PREFIX.jani, PREFIX.pg, or PREFIX.tra, .sta, .lab and .srew or .trew (explicit)")
      .type_name("PREFIX");
  command.add_option("--svg", options->output.svg, "draw the product: by states of the automaton where it is large")
      .type_name("FILE");
  add_work_limits(command, options->parallel.limits, "a formula or task");
  command.add_option("--threads", options->parallel.threads, "formulas or tasks composed at a time (0: all cores)")
      .type_name("N")
      .show_default();
  command.add_flag_callback(
      "--json", [options] { options->output.format = "json"; }, "the same as --format json");
  return [options](const Session& session) { return run_compose(*options, session); };
}

}  // namespace waymark::tools
