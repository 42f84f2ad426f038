// waymark check: does this trajectory, or this word, satisfy this formula? By the definition of ⊨.
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libltl/meaning/progress.hpp"
#include "libltl/text/print.hpp"
#include "libltl/text/read_word.hpp"
#include "libplan/world/letter_lines.hpp"
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
  std::string trajectory, trace, word, format = "auto";
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

// The word that formulas are checked on, and the names that they may use.
struct Checked {
  ltl::AnyWord word;
  ltl::Vocabulary vocabulary;
  ltl::Unknown unknown = ltl::Unknown::Reject;
  std::optional<std::string> map = {};
};

void print_json(ltl::Formula formula, const std::vector<ltl::Formula>& rest, const Checked& checked, bool satisfied,
                const CheckOptions& options) {
  JsonObject json;
  json.add("formula", ltl::print(formula));
  if (checked.map) json.add("map", *checked.map);
  json.add("letters", std::visit([](const auto& word) { return word.size(); }, checked.word))
      .add("satisfied", satisfied);
  if (options.progress) {
    JsonArray formulas;
    for (const ltl::Formula f : rest) formulas.add(ltl::print(f));
    json.add("progress", formulas);
  }
  std::cout << json.text() << '\n';
}

ExitCode check_one(const Text& text, const Checked& checked, const CheckOptions& options, const Session& session) {
  ltl::Arena arena(checked.vocabulary);
  const ltl::Formula formula = parse_formula(text, arena, parse_options(options.notation, checked.unknown));
  const bool satisfied = std::visit([&](const auto& word) { return ltl::holds(word, formula); }, checked.word);
  std::vector<ltl::Formula> rest;
  if (options.progress) {
    const auto& word = std::get<ltl::Trace>(checked.word);
    rest = progressed(formula, word);
    if (ltl::accepts_empty(rest.back()) != satisfied)
      throw std::logic_error("progression and definition disagree on " + ltl::print(formula) + " and " +
                             ltl::show(word, checked.vocabulary));
  }
  if (options.json) {
    print_json(formula, rest, checked, satisfied, options);
  } else {
    for (const ltl::Formula f : rest) std::cout << shown(f, session.out) << '\n';
    if (!options.progress)
      std::cout << (satisfied ? session.out.paint(Paint::Green, "satisfied")
                              : session.out.paint(Paint::Red, "not satisfied"))
                << '\n';
  }
  return satisfied ? ExitCode::Done : ExitCode::No;
}

Checked read_checked(const CheckOptions& options) {
  if (!options.word.empty()) {
    ltl::Vocabulary names;
    ltl::AnyWord word = ltl::read_word(options.word, names);
    if (options.progress && !std::holds_alternative<ltl::Trace>(word))
      throw UsageError("--progress is about finite words");
    return {std::move(word), std::move(names), ltl::Unknown::Add};
  }
  if (!options.trace.empty()) {
    const plan::LetterFormat format = letter_format(options.format);
    plan::NamedTrace read = plan::read_letters(read_file(options.trace), format, source_name(options.trace));
    return {std::move(read.word), std::move(read.vocabulary),
            read.names_all ? ltl::Unknown::Reject : ltl::Unknown::Add};
  }
  const plan::Map map = read_map(options.map);
  const plan::Trajectory trajectory =
      plan::parse_trajectory(read_file(options.trajectory), map, source_name(options.trajectory));
  return {plan::word_of(trajectory, map), map.vocabulary(), ltl::Unknown::Reject, map.name()};
}

ExitCode run_check(const CheckOptions& options, const Session& session) {
  const int given =
      (options.trajectory.empty() ? 0 : 1) + (options.trace.empty() ? 0 : 1) + (options.word.empty() ? 0 : 1);
  if (given != 1) throw UsageError("give one of --trajectory, --trace and --word; see waymark check --help");
  const bool formula_from_stdin = options.text.arguments.empty() ? options.text.file.empty() || options.text.file == "-"
                                                                 : options.text.arguments[0] == "-";
  if ((options.trajectory == "-" || options.trace == "-") && formula_from_stdin)
    throw UsageError("formula and trajectory cannot both come from standard input");
  TextReader texts(options.text, "formula");
  const Checked checked = read_checked(options);
  return answer_each(
      texts, session.stop, [&](const Text& text) { return check_one(text, checked, options, session); }, options.json);
}

}  // namespace

Runner setup_check(Command command) {
  const auto options = std::make_shared<CheckOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  command.add_option("--trajectory", options->trajectory, "poses or actions (docs/formats); - is standard input")
      .type_name("FILE");
  command.add_option("--trace", options->trace, "a word without a map, letters line by line; - is standard input")
      .type_name("FILE");
  add_letter_format_option(command, options->format);
  command.add_option("--word", options->word, "a word without a map: '{a}; {b}', or a lasso: '{a}; ({b})w'")
      .type_name("WORD");
  command.add_flag("--progress", options->progress, "print what remains of the formula after every letter");
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) { return run_check(*options, session); };
}

}  // namespace waymark::tools
