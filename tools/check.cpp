// waymark check: does this trajectory, or this word, satisfy this formula? By the definition of ⊨.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libltl/text/print.hpp"
#include "libltl/text/read_word.hpp"
#include "libplan/world/letter_source.hpp"
#include "tools/answer.hpp"
#include "tools/check_model.hpp"
#include "tools/judged_word.hpp"
#include "tools/picture.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct CheckOptions {
  TextOptions text;
  NotationOptions notation;
  MapOptions map;
  std::string trajectory, trace, word, format = "auto", semantics, svg;
  double time_unit = 0;  // 0: rows are steps
  bool progress = false, json = false;
  CheckModelOptions model;
};

// A word that formulas are checked on, and the names that they may use.
struct Checked {
  ltl::AnyWord word;
  ltl::Vocabulary vocabulary;
  ltl::Unknown unknown = ltl::Unknown::Reject;
  std::optional<plan::Map> map = {};
  plan::Walk walk = {};  // on the map

  std::size_t letters() const {
    return std::visit([](const auto& some) { return some.size(); }, word);
  }
  const ltl::Letter& letter(std::size_t i) const {
    return std::visit([&](const auto& some) -> const ltl::Letter& { return some[i]; }, word);
  }
  bool goes_on() const { return std::holds_alternative<ltl::Lasso>(word); }
  bool begins_cycle(std::size_t i) const {
    const auto* lasso = std::get_if<ltl::Lasso>(&word);
    return lasso != nullptr && lasso->loop_start() == i;
  }
};

// The words that formulas are checked on: one, or the traces of a file.
struct Given {
  std::vector<Checked> words;
  std::string text = {};          // of a trace file, read again for conditions on its columns
  plan::NoTruths no_truths = {};  // names that are no propositions
};

// What is said in front of a verdict where there are several.
struct Label {
  std::string text;                  // for people
  std::string formula;               // as it was typed
  std::optional<std::size_t> line;   // of the formula, in a batch
  std::optional<std::size_t> trace;  // from 1, of several
};

// Letters as far as the formula reads them: a map says twenty things of every pose.
ltl::Letter read_by(ltl::Formula formula, const ltl::Letter& letter) {
  ltl::Letter out;
  for (const ltl::Proposition p : ltl::propositions(formula))
    if (letter.contains(p)) out.insert(p);
  return out;
}

const char* word_for(LetterVerdict verdict) {
  if (verdict == LetterVerdict::Open) return "open";
  return verdict == LetterVerdict::Lost ? "lost" : "satisfied";
}

JsonObject step_json(std::size_t i, const JudgedLetter& judged, const Checked& checked) {
  JsonObject step;
  if (checked.map) {
    const plan::Pose pose = checked.map->pose(checked.walk.trajectory.poses[i]);
    step.add("pose", JsonArray().add(pose.x).add(pose.y).add(pose.heading))
        .add("action", i == 0 ? Json() : Json(plan::name(checked.walk.trajectory.actions[i - 1])));
  }
  JsonArray letter;
  for (const ltl::Proposition p : checked.letter(i).members()) letter.add(checked.vocabulary.name(p));
  step.add("letter", letter).add("remains", ltl::print(judged.remains));
  return step.add("verdict", judged.verdict ? Json(word_for(*judged.verdict)) : Json());
}

void print_json(const Label& label, const JudgedWord& judged, const Checked& checked, ltl::Semantics semantics,
                const CheckOptions& options) {
  JsonObject json;
  if (label.line) json.add("line", *label.line);
  json.add("formula", label.formula);
  if (label.trace) json.add("trace", *label.trace);
  if (checked.map) json.add("map", checked.map->name());
  json.add("letters", checked.letters()).add("satisfied", judged.satisfied.value_or(false));
  if (semantics == ltl::Semantics::Infinite)
    json.add("semantics", "infinite").add("decided", judged.satisfied.has_value());
  if (judged.knows_loss) json.add("lost_at", judged.lost ? Json(*judged.lost + 1) : Json());
  if (options.progress) {
    JsonArray formulas, steps;
    for (std::size_t i = 0; i < judged.letters.size(); ++i) {
      formulas.add(ltl::print(judged.letters[i].remains));
      steps.add(step_json(i, judged.letters[i], checked));
    }
    json.add("progress", formulas).add("steps", steps);
  }
  std::cout << json.text() << '\n';
}

// Columns as wide as their widest cell, two blanks between them.
void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], ltl::utf8_length(row[i]));
  for (const auto& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      std::cout << row[i] << std::string(widths[i] + 2 - ltl::utf8_length(row[i]), ' ');
    std::cout << row.back() << '\n';
  }
}

void print_progress(ltl::Formula formula, const JudgedWord& judged, const Checked& checked, const Session& session) {
  std::vector<std::vector<std::string>> rows{{"", "letter", "so far", "what remains"}};
  if (checked.map) rows[0].insert(rows[0].begin() + 1, {"action", "pose"});
  for (std::size_t i = 0; i < judged.letters.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    std::vector<std::string> row{checked.begins_cycle(i) ? number + " for ever:" : number};
    if (checked.map) {
      row.push_back(i == 0 ? "start" : std::string(plan::name(checked.walk.trajectory.actions[i - 1])));
      row.push_back(plan::show(checked.map->pose(checked.walk.trajectory.poses[i])));
    }
    row.push_back(ltl::show(read_by(formula, checked.letter(i)), checked.vocabulary));
    row.emplace_back(judged.letters[i].verdict ? word_for(*judged.letters[i].verdict) : "?");
    row.push_back(shown(judged.letters[i].remains, session.out));
    rows.push_back(std::move(row));
  }
  print_table(rows);
}

// "letter 4, FORWARD to (1,7,0)", "letter 4, {a}"
std::string place_of(std::size_t i, ltl::Formula formula, const Checked& checked) {
  const std::string letter = "letter " + std::to_string(i + 1) + ", ";
  if (!checked.map) return letter + ltl::show(read_by(formula, checked.letter(i)), checked.vocabulary);
  const std::string pose = plan::show(checked.map->pose(checked.walk.trajectory.poses[i]));
  if (i == 0) return letter + "the start at " + pose;
  return letter + std::string(plan::name(checked.walk.trajectory.actions[i - 1])) + " to " + pose;
}

std::string reason(ltl::Formula formula, const JudgedWord& judged, const Checked& checked) {
  if (judged.lost) return ": after " + place_of(*judged.lost, formula, checked) + " no continuation satisfies it";
  if (!judged.knows_loss) return "";
  return checked.goes_on() ? ": no single letter is at fault, the cycle is" : ": it ends too early";
}

void print_verdict(const std::string& label, ltl::Formula formula, const JudgedWord& judged, const Checked& checked,
                   ltl::Semantics semantics, const Session& session) {
  std::cout << label;
  const bool foreseen = semantics == ltl::Semantics::Infinite && !checked.goes_on();
  if (!judged.satisfied && !judged.is_known_satisfiable)
    std::cout << "open: whether some continuation satisfies it is not known\n";
  else if (!judged.satisfied)
    std::cout << "open: some continuations satisfy it, others do not\n";
  else if (*judged.satisfied)
    std::cout << session.out.paint(Paint::Green, "satisfied") << (foreseen ? ", however it goes on" : "") << '\n';
  else
    std::cout << session.out.paint(Paint::Red, "not satisfied") << reason(formula, judged, checked) << '\n';
}

ExitCode check_one(const Label& label, ltl::Formula formula, const Checked& checked, const CheckOptions& options,
                   const Session& session) {
  const bool infinite = options.semantics.empty() ? checked.goes_on() : options.semantics == "infinite";
  const auto semantics = infinite ? ltl::Semantics::Infinite : ltl::Semantics::Finite;
  const JudgedWord judged = judge(formula, checked.word, semantics, options.progress, session.stop);
  if (options.json) {
    print_json(label, judged, checked, semantics, options);
  } else {
    if (options.progress && !label.text.empty()) std::cout << label.text.substr(0, label.text.size() - 1) << '\n';
    if (options.progress) print_progress(formula, judged, checked, session);
    print_verdict(options.progress ? "" : label.text, formula, judged, checked, semantics, session);
  }
  if (!options.svg.empty())
    draw({.map = &*checked.map, .formula = formula, .route = checked.walk, .lost = judged.lost}, options.svg);
  return judged.satisfied.value_or(false) ? ExitCode::Done : ExitCode::No;
}

Given given_by(const plan::NamedTraces& read, ltl::Unknown unknown) {
  Given out;
  for (const ltl::Trace& word : read.words) out.words.push_back({word, read.vocabulary, unknown});
  out.no_truths = read.no_truths;
  return out;
}

plan::NamedTraces read_traces(const std::string& text, const CheckOptions& options, ltl::Vocabulary wanted) {
  const auto unit = options.time_unit > 0 ? std::optional(options.time_unit) : std::nullopt;
  return plan::read_traces(text,
                           {.format = letter_format(options.format), .time_unit = unit, .wanted = std::move(wanted)},
                           source_name(options.trace));
}

Given read_given(const CheckOptions& options) {
  if (!options.word.empty()) {
    ltl::Vocabulary names;
    ltl::AnyWord word = ltl::read_word(options.word, names);
    return {.words = {{std::move(word), std::move(names), ltl::Unknown::Add}}};
  }
  if (!options.trace.empty()) {
    std::string text = read_file(options.trace);
    const plan::NamedTraces read = read_traces(text, options, {});
    if (read.has_time && options.time_unit == 0) std::cerr << note_of_time;
    Given out = given_by(read, read.names_all ? ltl::Unknown::Reject : ltl::Unknown::Add);
    out.text = std::move(text);
    return out;
  }
  plan::Map map = read_map(options.map);
  plan::Walk walk = plan::parse_walk(read_file(options.trajectory), map, source_name(options.trajectory));
  ltl::AnyWord word =
      walk.repeated > 0 ? ltl::AnyWord(plan::lasso_of(walk, map)) : ltl::AnyWord(plan::word_of(walk.trajectory, map));
  ltl::Vocabulary vocabulary = map.vocabulary();
  return {.words = {{std::move(word), std::move(vocabulary), ltl::Unknown::Reject, std::move(map), std::move(walk)}}};
}

// Where the formula compares columns, or uses one that has no truth values: the traces read again, for its names. The
// reader then says what is wrong with a value, or makes propositions of the conditions.
std::optional<Given> with_conditions(const Text& text, const Given& given, const CheckOptions& options) {
  const ltl::Vocabulary& known = given.words.front().vocabulary;
  ltl::Arena scratch;
  const ltl::ParseOptions parsed = parse_options(options.notation, ltl::Unknown::Add);
  ltl::Vocabulary names = known, used;
  bool again = false;
  for (const ltl::Proposition p : ltl::propositions(parse_formula(text, scratch, parsed, false))) {
    const std::string& name = scratch.vocabulary().name(p);
    const bool compares = !known.find(name) && plan::condition_of(name);
    again = again || compares || given.no_truths.contains(name);
    if (compares) names.add(name);
    used.add(name);
  }
  if (!again) return std::nullopt;
  if (given.text.empty())
    throw ltl::FormatError("", 0, 0, "there is no table with values to compare: give one with --trace");
  ltl::Arena arena(names);
  parse_formula(text, arena, parse_options(options.notation, given.words.front().unknown));  // throws on other names
  return given_by(read_traces(given.text, options, used), ltl::Unknown::Add);
}

ExitCode check_all(const Text& text, bool batch, const Given& given, const CheckOptions& options,
                   const Session& session) {
  const bool may_compare = !given.words.front().map.has_value();
  const std::optional<Given> again = may_compare ? with_conditions(text, given, options) : std::nullopt;
  const std::vector<Checked>& words = again ? again->words : given.words;
  ltl::Arena arena(words.front().vocabulary);
  const ltl::Formula formula = parse_formula(text, arena, parse_options(options.notation, words.front().unknown));
  const std::string typed = as_typed(text, formula, options.notation);
  ExitCode worst = ExitCode::Done;
  for (std::size_t i = 0; i < words.size(); ++i) {
    Label label{.text = "", .formula = typed, .line = {}, .trace = {}};
    if (batch && !text.source.empty()) label.text += text.source + ":" + std::to_string(text.line) + ": ";
    if (batch) label.text += typed + ": ";
    if (batch) label.line = text.line;
    if (words.size() > 1) label.trace = i + 1;
    if (words.size() > 1) label.text += "trace " + std::to_string(i + 1) + ": ";
    worst = worse(worst, check_one(label, formula, words[i], options, session));
  }
  return worst;
}

// Model checking, where no word is given.
ExitCode run_check_on_model(const CheckOptions& options, const Session& session) {
  if (!(options.trajectory + options.trace + options.word + options.svg).empty() || options.progress)
    throw UsageError("--model asks about all runs: --trajectory, --trace, --word, --progress and --svg are about one");
  if (options.semantics == "finite") throw UsageError("runs of a model have no end: --semantics infinite");
  CheckModelOptions model = options.model;
  model.json = options.json;
  const bool asks = !options.text.arguments.empty() || !options.text.file.empty();
  if (!model.automaton.empty() && asks) throw UsageError("give formulas or --automaton, not both");
  if (!model.automaton.empty()) return check_automaton_on_model(model, session);
  TextReader formulas(options.text, "formula");
  return check_on_model(model, formulas, session);
}

ExitCode run_check(const CheckOptions& options, const Session& session) {
  if (!options.model.model.empty()) return run_check_on_model(options, session);
  if (!(options.model.automaton + options.model.rewards).empty())
    throw UsageError("--automaton and --rewards go with --model");
  const int given =
      (options.trajectory.empty() ? 0 : 1) + (options.trace.empty() ? 0 : 1) + (options.word.empty() ? 0 : 1);
  if (given != 1) throw UsageError("give one of --trajectory, --trace, --word and --model; see waymark check --help");
  if (options.time_unit < 0) throw UsageError("--time-unit is a positive number");
  if (options.time_unit > 0 && options.trace.empty()) throw UsageError("--time-unit counts the column time of --trace");
  if (!options.svg.empty() && options.trajectory.empty()) throw UsageError("--svg draws a trajectory on its map");
  const bool formula_from_stdin = options.text.arguments.empty() ? options.text.file.empty() || options.text.file == "-"
                                                                 : options.text.arguments[0] == "-";
  if ((options.trajectory == "-" || options.trace == "-") && formula_from_stdin)
    throw UsageError("formula and trajectory cannot both come from standard input");
  TextReader texts(options.text, "formula");
  if (!options.svg.empty() && texts.is_batch()) throw UsageError("--svg is for a single formula given as an argument");
  const Given read = read_given(options);
  if (read.words.front().goes_on() && options.semantics == "finite")
    throw UsageError("a lasso has no end: it is an infinite word");
  return answer_each(
      texts, session.stop, [&](const Text& text) { return check_all(text, texts.is_batch(), read, options, session); },
      options.json);
}

}  // namespace

Runner setup_check(Command command) {
  const auto options = std::make_shared<CheckOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  command
      .add_option("--trajectory", options->trajectory,
                  "poses or actions, or an answer of plan (docs/formats); - is standard input")
      .type_name("FILE");
  command.add_option("--trace", options->trace, "a word without a map, letters line by line; - is standard input")
      .type_name("FILE");
  add_letter_format_option(command, options->format);
  add_time_unit_option(command, options->time_unit);
  command.add_option("--word", options->word, "a word without a map: '{a}; {b}', or a lasso: '{a}; ({b})w'")
      .type_name("WORD");
  command
      .add_option("--semantics", options->semantics,
                  "over what words the formula is read (else infinite for a lasso, finite for a word that ends)")
      .one_of({"finite", "infinite"});
  command.add_flag("--progress", options->progress, "print what remains of the formula after every letter");
  command.add_option("--svg", options->svg, "draw the trajectory on its map").type_name("FILE");
  command.add_flag("--json", options->json, "one JSON object a line");
  add_check_model_options(command, options->model);
  command.add_option("--start", options->model.start, "the landmark of a street graph where runs begin")
      .type_name("LANDMARK");
  return [options](const Session& session) { return run_check(*options, session); };
}

}  // namespace waymark::tools
