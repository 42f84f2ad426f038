// waymark check: does this trajectory satisfy this formula? By the definition of ⊨.
#include <iostream>
#include <memory>

#include "libltl/meaning/progress.hpp"
#include "libltl/text/print.hpp"
#include "tools/answer.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct CheckOptions {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string trajectory;
  bool progress = false, json = false;
};

// What remains of φ after each letter.
std::vector<ltl::Formula> progressed(ltl::Formula formula, const ltl::Trace& word) {
  std::vector<ltl::Formula> rest;
  for (const ltl::Letter& letter : word) {
    formula = ltl::progress(formula, letter);
    rest.push_back(formula);
  }
  return rest;
}

void print_json(ltl::Formula formula, const std::vector<ltl::Formula>& rest, const ltl::Trace& word,
                bool satisfied, const CheckOptions& options, const plan::Map& map) {
  JsonObject json;
  json.add("formula", ltl::print(formula))
      .add("map", map.name())
      .add("letters", word.size())
      .add("satisfied", satisfied);
  if (options.progress) {
    JsonArray formulas;
    for (const ltl::Formula f : rest) formulas.add(ltl::print(f));
    json.add("progress", formulas);
  }
  std::cout << json.text() << '\n';
}

ExitCode check_one(const Text& text, const ltl::Trace& word, const plan::Map& map,
                   const CheckOptions& options, const Session& session) {
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula formula =
      parse_formula(text, arena, parse_options(options.notation, ltl::Unknown::Reject));
  const bool satisfied = ltl::holds(word, formula);
  const auto rest = options.progress ? progressed(formula, word) : std::vector<ltl::Formula>{};
  if (options.progress && ltl::accepts_empty(rest.back()) != satisfied)
    throw std::logic_error("progression and definition disagree on " + ltl::print(formula) + " and " +
                           ltl::show(word, map.vocabulary()));
  if (options.json) {
    print_json(formula, rest, word, satisfied, options, map);
  } else {
    for (const ltl::Formula f : rest) std::cout << shown(f, session.out) << '\n';
    if (!options.progress)
      std::cout << (satisfied ? session.out.paint(Paint::Green, "satisfied")
                              : session.out.paint(Paint::Red, "not satisfied"))
                << '\n';
  }
  return satisfied ? ExitCode::Done : ExitCode::No;
}

ExitCode run_check(const CheckOptions& options, const Session& session) {
  const bool formula_from_stdin = options.text.arguments.empty()
                                      ? options.text.file.empty() || options.text.file == "-"
                                      : options.text.arguments[0] == "-";
  if (options.trajectory == "-" && formula_from_stdin)
    throw UsageError("formula and trajectory cannot both come from standard input");
  TextReader texts(options.text, "formula");
  const plan::Map map = read_map(options.map);
  const plan::Trajectory trajectory =
      plan::parse_trajectory(read_file(options.trajectory), map, source_name(options.trajectory));
  const ltl::Trace word = plan::word_of(trajectory, map);
  return answer_each(
      texts, session.stop, [&](const Text& text) { return check_one(text, word, map, options, session); },
      options.json);
}

}  // namespace

Runner setup_check(Command command) {
  const auto options = std::make_shared<CheckOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  command
      .add_option("--trajectory", options->trajectory, "poses or actions (docs/formats); - is standard input")
      .type_name("FILE")
      .required();
  command.add_flag("--progress", options->progress, "print what remains of the formula after every letter");
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) { return run_check(*options, session); };
}

}  // namespace waymark::tools
