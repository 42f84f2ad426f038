// waymark translate: formula → automaton.
#include <CLI/App.hpp>
#include <iostream>
#include <memory>

#include "libautomata/dot.hpp"
#include "libautomata/hoa.hpp"
#include "libautomata/ltlf_to_dfa.hpp"
#include "libltl/print.hpp"
#include "tools/answer.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/deadline.hpp"
#include "tools/shell/options.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  TextOptions text;
  NotationOptions notation;
  std::string semantics = "finite", target = "dfa", format = "hoa";
  std::size_t states = automata::TranslationLimits{}.states;
  double timeout = 0;  // seconds a formula; 0: none
};

// One row, tab-separated: line states edges sets deterministic seconds status symbolic_nodes.
void print_row(std::size_t line, const AutomatonSize* size, double seconds, std::string_view status) {
  const auto field = [&](std::size_t AutomatonSize::*member) {
    return size != nullptr ? std::to_string(size->*member) : std::string("-");
  };
  std::cout << line << '\t' << field(&AutomatonSize::states) << '\t' << field(&AutomatonSize::edges) << '\t'
            << (size != nullptr ? "1\tyes" : "-\t-") << '\t' << fixed(seconds, 6) << '\t' << status << '\t'
            << field(&AutomatonSize::symbolic_nodes) << '\n';
}

Json json_of(ltl::Formula formula, const automata::Dfa& dfa, double seconds) {
  JsonArray reads;
  for (const ltl::Proposition p : dfa.reads()) reads.add(dfa.vocabulary().name(p));
  const std::string name = ltl::print(formula);
  return JsonObject()
      .add("formula", name)
      .add("semantics", "finite")
      .add("status", "ok")
      .add("automaton", tools::json_of(size_of(dfa)))
      .add("sets", 1)
      .add("deterministic", true)
      .add("reads", reads)
      .add("seconds", seconds)
      .add("hoa", automata::write_hoa(dfa, {.name = name}));
}

void print_automaton(const Text& text, ltl::Formula formula, const automata::Dfa& dfa, double seconds,
                     const std::string& format) {
  if (format == "stats") {
    const AutomatonSize size = size_of(dfa);
    print_row(text.line, &size, seconds, "ok");
  } else if (format == "json") {
    std::cout << json_of(formula, dfa, seconds).text() << '\n';
  } else if (format == "dot") {
    std::cout << automata::write_dot(dfa, {.name = ltl::print(formula, ltl::Style::Unicode)});
  } else {
    std::cout << automata::write_hoa(dfa, {.name = ltl::print(formula)});
  }
}

ExitCode give_up(const Text& text, double seconds, const Options& options, const std::string& reason) {
  complain("error",
           reason + (text.source.empty() ? "" : "\n  " + text.source + ':' + std::to_string(text.line)));
  if (options.format == "stats") print_row(text.line, nullptr, seconds, "exhausted");
  if (options.format == "json")
    std::cout << JsonObject().add("line", text.line).add("status", "exhausted").add("message", reason).text()
              << '\n';
  return ExitCode::GaveUp;
}

ExitCode translate_one(const Text& text, const Options& options, const Session& session) {
  ltl::Arena arena;
  StopWatch watch;
  const ltl::Formula formula = parse_formula(text, arena, parse_options(options.notation, ltl::Unknown::Add));
  const Deadline deadline(options.timeout, session.stop);
  const auto result = automata::ltlf_to_dfa(formula, {.states = options.states, .stop = deadline.token()});
  const double seconds = watch.lap();
  if (const auto* dfa = std::get_if<automata::Dfa>(&result)) {
    print_automaton(text, formula, *dfa, seconds, options.format);
    return ExitCode::Done;
  }
  if (session.stop.stop_requested()) throw Interrupted();
  const std::size_t made = std::get<automata::Exhausted>(result).states;
  return give_up(text, seconds, options,
                 deadline.passed()
                     ? "gave up after " + fixed(options.timeout, 1) + " s, with " + counted(made, "state")
                     : "gave up: more than " + counted(options.states, "state") + " before minimisation");
}

ExitCode run_translate(const Options& options, const Session& session) {
  if (options.semantics != "finite") throw UsageError("--semantics infinite is not available yet: finite is");
  if (options.target != "dfa") throw UsageError("--to " + options.target + " is not available yet: dfa is");
  TextReader texts(options.text, "formula");
  return answer_each(
      texts, session.stop, [&](const Text& text) { return translate_one(text, options, session); },
      [&](const Text& text, const std::string& message) {
        if (options.format == "stats") print_row(text.line, nullptr, 0, "error");
        if (options.format == "json") std::cout << json_error(text.line, message).text() << '\n';
      });
}

}  // namespace

Runner setup_translate(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  command.add_option("--semantics", options->semantics, "what words formulas are read on")
      ->check(CLI::IsMember({"finite", "infinite"}))
      ->capture_default_str();
  command.add_option("--to", options->target, "kind of automaton")
      ->check(CLI::IsMember({"dfa", "tgba", "buchi", "parity", "rabin", "ldba", "generic"}))
      ->capture_default_str();
  command.add_option("--format", options->format, "HOA, Graphviz DOT, one row of counts, or JSON")
      ->check(CLI::IsMember({"hoa", "dot", "stats", "json"}))
      ->capture_default_str();
  command.add_flag_callback(
      "--json", [options] { options->format = "json"; }, "the same as --format json");
  command.add_option("--max-states", options->states, "give up beyond so many states before minimisation")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--timeout", options->timeout, "give up on a formula after so many seconds (0: never)")
      ->type_name("SECONDS")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  return [options](const Session& session) { return run_translate(*options, session); };
}

}  // namespace waymark::tools
