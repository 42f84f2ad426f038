#include "tools/explanation.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "libautomata/finite/run.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libltl/english/verbalise.hpp"
#include "libltl/patterns/patterns.hpp"
#include "libltl/structure/fragment.hpp"
#include "libltl/text/print.hpp"
#include "libplan/world/observable_english.hpp"
#include "tools/translations.hpp"

namespace waymark::tools {
namespace {

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

// The least class of the safety–progress hierarchy that the syntax proves. The classes above safety and guarantee are
// classes of infinite words [MP90].
std::string hierarchy(ltl::Formula f, ltl::Semantics semantics) {
  const ltl::Fragments in = ltl::fragments(f, semantics);
  if (in.propositional) return "propositional";
  if (in.safety && in.cosafety) return "safety and guarantee";
  if (in.safety) return "safety";
  if (in.cosafety) return "guarantee";
  if (semantics == ltl::Semantics::Finite)
    return "neither safety nor guarantee; over infinite words, " + hierarchy(f, ltl::Semantics::Infinite);
  if (in.obligation) return "obligation";
  if (in.recurrence) return "recurrence";
  return in.persistence ? "persistence" : "reactivity";
}

std::string in_english(const ltl::Letter& letter, const std::vector<ltl::Described>& words) {
  std::string out;
  for (const ltl::Proposition p : letter.members()) out += (out.empty() ? "" : " and ") + words[p.index].holds;
  return out.empty() ? "nothing" : out;
}

Example example(const ltl::Trace& word, const ltl::Vocabulary& names, const std::vector<ltl::Described>& words) {
  Example out{ltl::show(word, names), ""};
  for (const ltl::Letter& letter : word)
    out.english += (out.english.empty() ? "" : "; then ") + in_english(letter, words);
  return out;
}

Example example(const ltl::Lasso& word, const ltl::Vocabulary& names, const std::vector<ltl::Described>& words) {
  Example out{ltl::show(word, names), ""};
  for (std::size_t i = 0; i < word.size(); ++i)
    out.english += (i == 0 ? "" : "; then ") + std::string(i == word.loop_start() ? "for ever: " : "") +
                   in_english(word[i], words);
  return out;
}

std::optional<Example> word_of(ltl::Formula f, ltl::Semantics semantics, const ltl::Limits& limits,
                               const std::vector<ltl::Described>& words) {
  const Translated made =
      find_translation(semantics == ltl::Semantics::Finite ? "finite" : "infinite", "").run(f, limits);
  const auto shown = [&](const auto& word, const ltl::Vocabulary& names) {
    return word ? std::optional(example(*word, names, words)) : std::nullopt;
  };
  if (const auto* dfa = std::get_if<automata::Dfa>(&made))
    return shown(automata::shortest_word(*dfa), dfa->vocabulary());
  if (const auto* omega = std::get_if<automata::Translated>(&made))
    return shown(automata::find_lasso(omega->automaton), omega->automaton.vocabulary());
  throw ExplanationLimit();
}

}  // namespace

Explanation explain(ltl::Formula f, ltl::Semantics semantics, bool on_map, const ltl::Limits& limits) {
  const ltl::Vocabulary& names = f.arena().vocabulary();
  ltl::VerbaliseOptions english{.semantics = semantics};
  if (on_map) english.describe = plan::hallway_english(names);
  const auto words = ltl::described(names, english);
  return {.english = ltl::verbalise(f, english),
          .pattern = pattern_of(f),
          .hierarchy = hierarchy(f, semantics),
          .satisfying = word_of(f, semantics, limits, words),
          .violating = word_of(ltl::negate(f), semantics, limits, words)};
}

JsonObject json_of(const Explanation& explanation, const std::string& formula, ltl::Semantics semantics) {
  const auto shown = [](const std::optional<Example>& word) {
    return word ? Json(JsonObject().add("word", word->letters).add("english", word->english)) : Json();
  };
  return JsonObject()
      .add("formula", formula)
      .add("english", explanation.english)
      .add("pattern", explanation.pattern ? Json(*explanation.pattern) : Json())
      .add("semantics", semantics == ltl::Semantics::Finite ? "finite" : "infinite")
      .add("hierarchy", explanation.hierarchy)
      .add("satisfying", shown(explanation.satisfying))
      .add("violating", shown(explanation.violating));
}

}  // namespace waymark::tools
