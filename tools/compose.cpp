// waymark compose: formula or automaton, and a map → their product, its sizes or its graph.
#include <CLI/App.hpp>
#include <iostream>
#include <memory>

#include "libautomata/hoa.hpp"
#include "libltl/print.hpp"
#include "libplan/product/compose.hpp"
#include "tools/answer.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string start, automaton, format = "text";
};

struct Counts {
  std::size_t accepting = 0, traps = 0;
};

Counts count(const plan::Product& product) {
  Counts counts;
  for (plan::ProductVertex v = 0; v < num_vertices(product.graph); ++v) {
    counts.accepting += product.is_accepting(v) ? 1 : 0;
    counts.traps += product.is_trap(v) ? 1 : 0;
  }
  return counts;
}

Json json_of(const plan::Product& product, std::optional<ltl::Formula> formula) {
  const Counts counts = count(product);
  return JsonObject()
      .add("formula", formula ? Json(ltl::print(*formula)) : Json())
      .add("map", product.map->name())
      .add("automaton", json_of(size_of(*product.dfa)))
      .add("product", JsonObject()
                          .add("states", num_vertices(product.graph))
                          .add("edges", num_edges(product.graph))
                          .add("starts", product.starts.size())
                          .add("accepting", counts.accepting)
                          .add("traps", counts.traps));
}

void print_text(const plan::Product& product, std::optional<ltl::Formula> formula, const Terminal& terminal) {
  const Counts counts = count(product);
  if (formula) std::cout << "formula    " << shown(*formula, terminal) << '\n';
  std::cout << "automaton  " << counted(product.dfa->states(), "state") << '\n'
            << "product    " << counted(num_vertices(product.graph), "state") << " (" << counts.accepting
            << " accepting, " << counts.traps << " without hope), "
            << counted(num_edges(product.graph), "edge") << ", with the map " << product.map->name() << '\n';
}

void print_dot(const plan::Product& product) {
  std::cout << "digraph product {\n  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=11];\n"
            << "  edge [fontname=\"Helvetica\", fontsize=10];\n";
  for (plan::ProductVertex v = 0; v < num_vertices(product.graph); ++v) {
    const plan::ProductState& state = product.graph[v];
    std::cout << "  " << v << " [label=\"" << plan::show(product.map->pose(state.pose)) << " · "
              << state.task.index << '"' << (product.is_accepting(v) ? ", peripheries=2" : "")
              << (product.is_trap(v) ? ", color=gray70" : "") << "];\n";
  }
  for (std::size_t i = 0; i < product.starts.size(); ++i)
    std::cout << "  start" << i << " [shape=point]; start" << i << " -> " << product.starts[i] << ";\n";
  for (const auto edge : boost::make_iterator_range(edges(product.graph)))
    std::cout << "  " << source(edge, product.graph) << " -> " << target(edge, product.graph) << " [label=\""
              << plan::name(product.graph[edge].action) << "\"];\n";
  std::cout << "}\n";
}

void answer(const plan::Product& product, std::optional<ltl::Formula> formula, const Options& options,
            const Session& session) {
  if (options.format == "json")
    std::cout << json_of(product, formula).text() << '\n';
  else if (options.format == "dot")
    print_dot(product);
  else
    print_text(product, formula, session.out);
}

plan::Product composed(const plan::Map& map, const automata::Dfa& dfa, std::span<const plan::PoseId> starts,
                       const Session& session) {
  std::optional<plan::Product> product = plan::compose(map, dfa, starts, {.stop = session.stop});
  if (!product) throw Interrupted();
  return std::move(*product);
}

ExitCode run_compose(const Options& options, const Session& session) {
  const bool given = !options.text.arguments.empty() || !options.text.file.empty();
  if (!options.automaton.empty() && given) throw UsageError("give a formula or --automaton, not both");
  const plan::Map map = read_map(options.map);
  const auto starts = start_poses(options.start, map);
  if (!options.automaton.empty()) {
    const automata::Dfa dfa =
        automata::read_hoa(read_file(options.automaton), source_name(options.automaton));
    answer(composed(map, dfa, starts, session), std::nullopt, options, session);
    return ExitCode::Done;
  }
  TextReader texts(options.text, "formula");
  return answer_each(
      texts, session.stop,
      [&](const Text& text) {
        ltl::Arena arena(map.vocabulary());
        const ltl::Formula formula =
            parse_formula(text, arena, parse_options(options.notation, ltl::Unknown::Reject));
        const automata::Dfa dfa = translate(formula, session.stop);
        answer(composed(map, dfa, starts, session), formula, options, session);
        return ExitCode::Done;
      },
      [&](const Text& text, const std::string& message) {
        if (options.format == "json") std::cout << json_error(text.line, message).text() << '\n';
      });
}

}  // namespace

Runner setup_compose(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  add_text_options(command, options->text, "formula");
  command
      .add_option("--automaton", options->automaton,
                  "an automaton in HOA instead of a formula; - is standard input")
      ->type_name("FILE");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  command.add_option("--format", options->format, "sizes for people, sizes as JSON, or the graph")
      ->check(CLI::IsMember({"text", "json", "dot"}))
      ->capture_default_str();
  command.add_flag_callback(
      "--json", [options] { options->format = "json"; }, "the same as --format json");
  return [options](const Session& session) { return run_compose(*options, session); };
}

}  // namespace waymark::tools
