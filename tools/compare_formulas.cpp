// waymark compare-formulas: how the words of two formulas lie to each other, with a word for every difference.
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libautomata/finite/run.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libltl/limits.hpp"
#include "libltl/text/print.hpp"
#include "tools/answer.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/translations.hpp"

namespace waymark::tools {
namespace {

struct ComparisonOptions {
  std::string first, second, semantics = "finite";
  NotationOptions notation;
  std::size_t states = ltl::Limits{}.states;
  bool json = false;
};

// A shortest word that satisfies f, as text. Throws GaveUp beyond the limits.
std::optional<std::string> word_of(ltl::Formula f, const ComparisonOptions& options, const Session& session) {
  const Translated made =
      find_translation(options.semantics, "").run(f, {.states = options.states, .stop = session.stop});
  if (const auto* dfa = std::get_if<automata::Dfa>(&made)) {
    const auto word = automata::shortest_word(*dfa);
    return word ? std::optional(ltl::show(*word, dfa->vocabulary())) : std::nullopt;
  }
  if (const auto* omega = std::get_if<automata::Translated>(&made)) {
    const auto word = automata::find_lasso(omega->automaton);
    return word ? std::optional(ltl::show(*word, omega->automaton.vocabulary())) : std::nullopt;
  }
  if (session.stop.stop_requested()) throw Interrupted();
  throw GaveUp("more than " + counted(options.states, "state") + " before minimisation");
}

std::string relation(bool only_first, bool only_second) {
  if (only_first && only_second) return "incomparable";
  if (only_second) return "stronger";
  return only_first ? "weaker" : "equivalent";
}

std::string sentence(const std::string& relation) {
  if (relation == "equivalent") return "equivalent: both hold on the same words";
  if (relation == "incomparable") return "incomparable: each holds on a word on which the other does not";
  return "the first is " + relation + " than the second";
}

ExitCode run_comparison(const ComparisonOptions& options, const Session& session) {
  ltl::Arena arena;
  const ltl::ParseOptions how = parse_options(options.notation, ltl::Unknown::Add);
  const ltl::Formula first = ltl::parse(options.first, arena, how), second = ltl::parse(options.second, arena, how);
  const auto of_first = word_of(ltl::conjunction(first, ltl::negate(second)), options, session);
  const auto of_second = word_of(ltl::conjunction(second, ltl::negate(first)), options, session);
  const std::string found = relation(of_first.has_value(), of_second.has_value());
  if (options.json) {
    std::cout << JsonObject()
                     .add("first", ltl::print(first))
                     .add("second", ltl::print(second))
                     .add("semantics", options.semantics)
                     .add("relation", found)
                     .add("only_first", of_first ? Json(*of_first) : Json())
                     .add("only_second", of_second ? Json(*of_second) : Json())
                     .text()
              << '\n';
  } else {
    std::cout << sentence(found) << " (over " << options.semantics << " words)\n";
    if (of_first) std::cout << "only the first holds on   " << *of_first << '\n';
    if (of_second) std::cout << "only the second holds on  " << *of_second << '\n';
  }
  return found == "equivalent" ? ExitCode::Done : ExitCode::No;
}

}  // namespace

Runner setup_compare_formulas(Command command) {
  const auto options = std::make_shared<ComparisonOptions>();
  command.add_option("first", options->first, "a formula").type_name("FORMULA").required();
  command.add_option("second", options->second, "another one").type_name("FORMULA").required();
  add_notation_options(command, options->notation);
  command.add_option("--semantics", options->semantics, "what words the formulas are read on")
      .one_of({"finite", "infinite"})
      .show_default();
  command.add_option("--limit-states", options->states, "give up beyond so many states before minimisation")
      .type_name("N")
      .show_default();
  command.add_flag("--json", options->json, "one JSON object");
  return [options](const Session& session) { return run_comparison(*options, session); };
}

}  // namespace waymark::tools
