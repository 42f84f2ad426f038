// waymark explain: what a formula means, in English and by examples.
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "libltl/limits.hpp"
#include "tools/answer.hpp"
#include "tools/explanation.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct ExplainOptions {
  TextOptions text;
  NotationOptions notation;
  std::string semantics = "finite", map, data;
  std::size_t states = ltl::Limits{}.states;
  bool json = false;
};

ltl::Semantics semantics_of(const ExplainOptions& options) {
  return options.semantics == "finite" ? ltl::Semantics::Finite : ltl::Semantics::Infinite;
}

void print_explained(const Explanation& e) {
  const auto shown = [](const std::optional<Example>& word) {
    return word ? word->letters + "   " + word->english : "none";
  };
  std::cout << e.english << '\n';
  if (e.pattern) std::cout << "pattern     " << *e.pattern << '\n';
  std::cout << "hierarchy   " << e.hierarchy << '\n'
            << "satisfying  " << shown(e.satisfying) << '\n'
            << "violating   " << shown(e.violating) << '\n';
}

ExitCode explain_one(const Text& text, const std::optional<plan::Map>& map, const ExplainOptions& options,
                     const Session& session) {
  ltl::Arena arena(map ? map->vocabulary() : ltl::Vocabulary());
  const ltl::Formula f = map ? parse_on_map(text, arena, options.notation, options.map)
                             : parse_formula(text, arena, parse_options(options.notation, ltl::Unknown::Add));
  const ltl::Limits limits{.states = options.states, .stop = session.stop};
  try {
    const Explanation e = explain(f, semantics_of(options), map.has_value(), limits);
    if (options.json)
      std::cout << json_of(e, as_typed(text, f, options.notation), semantics_of(options)).text() << '\n';
    else
      print_explained(e);
    return e.satisfying ? ExitCode::Done : ExitCode::No;  // no word satisfies it
  } catch (const ExplanationLimit&) {
    if (options.json)
      std::cout << JsonObject().add("line", text.line).add("status", "limit").text() << '\n';
    else
      std::cout << "gave up: more than " << counted(options.states, "state") << " before minimisation\n";
    return ExitCode::GaveUp;
  }
  return ExitCode::Done;
}

ExitCode run_explain(const ExplainOptions& options, const Session& session) {
  TextReader texts(options.text, "formula");
  std::optional<plan::Map> map;
  if (!options.map.empty()) map = read_map({options.map, options.data});
  return answer_each(
      texts, session.stop, [&](const Text& text) { return explain_one(text, map, options, session); }, options.json);
}

}  // namespace

Runner setup_explain(Command command) {
  const auto options = std::make_shared<ExplainOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  command.add_option("--semantics", options->semantics, "what words the formula is read on")
      .one_of({"finite", "infinite"})
      .show_default();
  command.add_option("--map", options->map, "hallway map whose propositions the formula speaks of").type_name("MAP");
  add_data_option(command, options->data);
  command.add_option("--limit-states", options->states, "give up beyond so many states before minimisation")
      .type_name("N")
      .show_default();
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) { return run_explain(*options, session); };
}

}  // namespace waymark::tools
