// waymark explain: what a formula means, in English and by examples.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libautomata/finite/run.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libltl/english/verbalise.hpp"
#include "libltl/patterns/patterns.hpp"
#include "libltl/structure/fragment.hpp"
#include "libltl/text/print.hpp"
#include "libplan/world/observable_english.hpp"
#include "tools/answer.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/translations.hpp"

namespace waymark::tools {
namespace {

struct ExplainOptions {
  TextOptions text;
  NotationOptions notation;
  std::string semantics = "finite", map, data;
  std::size_t states = automata::TranslationLimits{}.states;
  bool json = false;
};

ltl::Semantics semantics_of(const ExplainOptions& options) {
  return options.semantics == "finite" ? ltl::Semantics::Finite : ltl::Semantics::Infinite;
}

// The mission over these places that the formula is.
std::optional<std::string> mission_over(ltl::Formula f, std::span<const ltl::Formula> places) {
  const auto rows = ltl::mission_patterns();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto mission = static_cast<ltl::Mission>(i);
    const std::string& parameters = rows[i].parameters;
    if (parameters == "n l") {
      const std::size_t size = ltl::tree_size(f);
      for (std::size_t n = 1; places.size() == 1 && n <= size; ++n)
        if (ltl::restricted_avoidance(mission, n, places[0]) == f) return rows[i].name;
    } else if (parameters == "l.." || (parameters.size() + 1) / 2 == places.size()) {
      if (ltl::mission(mission, places) == f) return rows[i].name;
    }
  }
  return std::nullopt;
}

std::optional<std::string> property_over(ltl::Formula f, std::span<const ltl::Formula> arguments) {
  const auto rows = ltl::property_patterns();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if ((rows[i].parameters.size() + 1) / 2 == arguments.size() &&
        ltl::property(static_cast<ltl::Body>(i / 5), static_cast<ltl::Scope>(i % 5), arguments) == f)
      return rows[i].name;
  return std::nullopt;
}

// The name of the catalogue, if f is a pattern over propositions.
std::optional<std::string> pattern_of(ltl::Formula formula) {
  constexpr std::size_t most = 5;
  ltl::Arena arena;
  const ltl::Formula f = ltl::transfer(formula, arena);
  std::vector<ltl::Formula> arguments;
  for (const ltl::Proposition p : ltl::propositions(f)) arguments.push_back(arena.atom(p));
  if (arguments.empty() || arguments.size() > most) return std::nullopt;
  std::sort(arguments.begin(), arguments.end());
  do
    if (auto found = mission_over(f, arguments)) return found;
  while (std::next_permutation(arguments.begin(), arguments.end()));
  do
    if (auto found = property_over(f, arguments)) return found;
  while (std::next_permutation(arguments.begin(), arguments.end()));
  return std::nullopt;
}

// The least class that the syntax proves.
std::string hierarchy(ltl::Formula f, ltl::Semantics semantics) {
  const ltl::Fragments in = ltl::fragments(f, semantics);
  if (in.propositional) return "propositional";
  if (in.safety && in.cosafety) return "safety and guarantee";
  if (in.safety) return "safety";
  if (in.cosafety) return "guarantee";
  if (semantics == ltl::Semantics::Finite) return "neither safety nor guarantee";
  if (in.obligation) return "obligation";
  if (in.recurrence) return "recurrence";
  return in.persistence ? "persistence" : "reactivity";
}

// A word as letters and in English.
struct Example {
  std::string letters, english;
};

std::string in_english(const ltl::Letter& letter, const std::vector<ltl::Described>& words) {
  std::string out;
  for (const ltl::Proposition p : letter.members())
    out += (out.empty() ? "" : " and ") + words[p.index].holds;
  return out.empty() ? "nothing" : out;
}

Example example(const ltl::Trace& word, const ltl::Vocabulary& names,
                const std::vector<ltl::Described>& words) {
  Example out{ltl::show(word, names), ""};
  for (const ltl::Letter& letter : word)
    out.english += (out.english.empty() ? "" : "; then ") + in_english(letter, words);
  return out;
}

Example example(const ltl::Lasso& word, const ltl::Vocabulary& names,
                const std::vector<ltl::Described>& words) {
  Example out{ltl::show(word, names), ""};
  for (std::size_t i = 0; i < word.size(); ++i)
    out.english += (i == 0 ? "" : "; then ") + std::string(i == word.loop_start() ? "for ever: " : "") +
                   in_english(word[i], words);
  return out;
}

// Thrown when a limit is met.
struct LimitMet {};

std::optional<Example> word_of(ltl::Formula f, const ExplainOptions& options,
                               const automata::TranslationLimits& limits,
                               const std::vector<ltl::Described>& words) {
  const Translated made = find_translation(options.semantics, "").run(f, limits);
  const auto shown = [&](const auto& word, const ltl::Vocabulary& names) {
    return word ? std::optional(example(*word, names, words)) : std::nullopt;
  };
  if (const auto* dfa = std::get_if<automata::Dfa>(&made))
    return shown(automata::shortest_word(*dfa), dfa->vocabulary());
  if (const auto* omega = std::get_if<automata::Translated>(&made))
    return shown(automata::find_lasso(omega->automaton), omega->automaton.vocabulary());
  throw LimitMet();
}

void print_explained_as_json(ltl::Formula f, const std::string& english,
                             const std::optional<std::string>& pattern, const std::optional<Example>& yes,
                             const std::optional<Example>& no, const ExplainOptions& options) {
  const auto shown = [](const std::optional<Example>& word) {
    return word ? Json(JsonObject().add("word", word->letters).add("english", word->english)) : Json();
  };
  std::cout << JsonObject()
                   .add("formula", ltl::print(f))
                   .add("english", english)
                   .add("pattern", pattern ? Json(*pattern) : Json())
                   .add("semantics", options.semantics)
                   .add("hierarchy", hierarchy(f, semantics_of(options)))
                   .add("satisfying", shown(yes))
                   .add("violating", shown(no))
                   .text()
            << '\n';
}

void print_explained(ltl::Formula f, const std::string& english, const std::optional<std::string>& pattern,
                     const std::optional<Example>& yes, const std::optional<Example>& no,
                     const ExplainOptions& options) {
  const auto shown = [](const std::optional<Example>& word) {
    return word ? word->letters + "   " + word->english : "none";
  };
  std::cout << english << '\n';
  if (pattern) std::cout << "pattern     " << *pattern << '\n';
  std::cout << "hierarchy   " << hierarchy(f, semantics_of(options)) << '\n'
            << "satisfying  " << shown(yes) << '\n'
            << "violating   " << shown(no) << '\n';
}

ExitCode explain_one(const Text& text, const std::optional<plan::Map>& map, const ExplainOptions& options,
                     const Session& session) {
  ltl::Arena arena(map ? map->vocabulary() : ltl::Vocabulary());
  const auto unknown = map ? ltl::Unknown::Reject : ltl::Unknown::Add;
  const ltl::Formula f = parse_formula(text, arena, parse_options(options.notation, unknown));
  ltl::VerbaliseOptions english{.semantics = semantics_of(options)};
  if (map) english.describe = plan::hallway_english(arena.vocabulary());
  const auto words = ltl::described(arena.vocabulary(), english);
  const automata::TranslationLimits limits{.states = options.states, .stop = session.stop};
  const std::string sentence = ltl::verbalise(f, english);
  try {
    const auto yes = word_of(f, options, limits, words), no = word_of(ltl::negate(f), options, limits, words);
    const auto print = options.json ? print_explained_as_json : print_explained;
    print(f, sentence, pattern_of(f), yes, no, options);
  } catch (const LimitMet&) {
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
      texts, session.stop, [&](const Text& text) { return explain_one(text, map, options, session); },
      options.json);
}

}  // namespace

Runner setup_explain(Command command) {
  const auto options = std::make_shared<ExplainOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  command.add_option("--semantics", options->semantics, "what words the formula is read on")
      .one_of({"finite", "infinite"})
      .show_default();
  command.add_option("--map", options->map, "hallway map whose propositions the formula speaks of")
      .type_name("MAP");
  add_data_option(command, options->data);
  command.add_option("--limit-states", options->states, "give up beyond so many states before minimisation")
      .type_name("N")
      .show_default();
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) { return run_explain(*options, session); };
}

}  // namespace waymark::tools
