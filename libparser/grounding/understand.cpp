#include "libparser/grounding/understand.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libltl/english/read_english.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/commands/command_reader.hpp"
#include "libparser/domain/hallways/hallway_things.hpp"
#include "libparser/grounding/direct_turns.hpp"
#include "libparser/grounding/renamed_map.hpp"
#include "libplan/plan_of.hpp"
#include "libplan/world/observable_english.hpp"

namespace waymark::parser {
namespace {

using enum LiftedSymbol;

constexpr std::size_t beam = 12;

// Does a formula speak of what happens again and again, or from some moment on for ever? G over F or U, F over G of
// what holds, and whatever is G as a whole.
bool is_ongoing(ltl::Formula f) {
  const auto has = [](ltl::Formula g, const auto& wanted) {
    const auto all = ltl::subformulas(g);
    return std::any_of(all.begin(), all.end(), wanted);
  };
  const auto lasts = [](ltl::Formula g) { return ltl::is_always(g) && g[1].op() != ltl::Op::Not; };
  const auto recurs = [](ltl::Formula g) { return g.op() == ltl::Op::Until; };
  return has(f, [&](ltl::Formula g) {
    return (ltl::is_always(g) && has(g[1], recurs)) || (ltl::is_eventually(g) && has(g[1], lasts));
  });
}
bool is_ongoing(const Lifted& lifted, ltl::Formula f) { return lifted.front() == Always || is_ongoing(f); }

// Words that say what no text of the training said: neither slots, nor known, nor marks.
std::vector<std::string> unknown_words(const LiftedReader& reader, const LiftedText& text) {
  std::vector<std::string> out;
  for (const std::string& token : text.tokens)
    if (token[0] != '#' && !reader.knows(token) && token.find_first_not_of(".,;:!?'\"()-") != std::string::npos)
      out.push_back(token);
  return out;
}

struct Found {
  Reading reading;
  bool ongoing = false;
  bool exact = false;  // said as waymark says it
};

// A text in the words in which waymark says formulas itself has that formula.
constexpr double exactly_said = 0.9;
struct Said {
  ltl::Formula formula;
  bool ongoing = false;
};
std::optional<Said> exact_reading(const std::string& text, const plan::Map& map, ltl::Arena& arena) {
  const auto describe = plan::hallway_english(map.vocabulary());
  for (const ltl::Semantics semantics : {ltl::Semantics::Finite, ltl::Semantics::Infinite})
    if (const auto formula = ltl::read_english(text, arena, {semantics, describe}))
      return Said{*formula, semantics == ltl::Semantics::Infinite};
  return std::nullopt;
}

// People seldom ask for what cannot be done: the likeliest readings without a route are worth less.
constexpr double without_route = 0.1, least_planned = 0.02;
constexpr std::size_t planned = 5;

bool has_no_route(const plan::Map& map, ltl::Formula formula, std::span<const plan::PoseId> starts) {
  return std::holds_alternative<plan::Infeasible>(
      plan::plan_of(map, formula, starts, {.automaton_states = 5'000, .explain = false}));
}

void weigh_by_routes(std::vector<Found>& all, const plan::Map& map, std::span<const plan::PoseId> starts) {
  for (std::size_t i = 0; i < std::min(all.size(), planned); ++i) {
    Found& f = all[i];
    if (f.ongoing || f.exact || f.reading.probability < least_planned) continue;
    if (has_no_route(map, f.reading.formula, starts)) f.reading.probability *= without_route;
  }
}

constexpr std::size_t small = 2'000;  // states, of automata that are compared

// Readings of one language add their probabilities: the likeliest of them keeps them.
void merge_languages(std::vector<Found>& all) {
  std::vector<std::optional<automata::Dfa>> dfas;
  const std::size_t n = std::min(all.size(), planned);
  for (std::size_t i = 0; i < n && all[i].reading.probability >= least_planned; ++i) {
    dfas.emplace_back();
    if (!all[i].ongoing) {
      auto dfa = automata::ltlf_to_dfa(all[i].reading.formula, {.states = small, .stop = {}});
      if (auto* const whole = std::get_if<automata::Dfa>(&dfa)) dfas.back() = std::move(*whole);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const bool same = all[i].ongoing
                            ? all[j].ongoing && same_language(all[i].reading.formula, all[j].reading.formula, small)
                            : dfas[i] && dfas[j] && !automata::difference(*dfas[i], *dfas[j]);
      if (!same) continue;
      all[j].reading.probability += std::exchange(all[i].reading.probability, 0);
      break;
    }
  }
  std::erase_if(all, [](const Found& f) { return f.reading.probability <= 0; });
}

void add(std::vector<Found>& all, Found found) {
  const auto same =
      std::find_if(all.begin(), all.end(), [&](const Found& f) { return f.reading.formula == found.reading.formula; });
  if (same == all.end())
    all.push_back(std::move(found));
  else
    same->reading.probability += found.reading.probability;
}

// Programs are over the names that the model was trained on: on other maps, the text is read in those.
std::vector<Reading> route_readings(const Grounder& grounder, const std::string& text, const Executor& executor,
                                    std::span<const plan::PoseId> starts, ltl::Arena& arena,
                                    const GroundOptions& options) {
  const plan::Map& map = executor.map();
  const ltl::Vocabulary& trained = grounder.ranking->language.vocabulary();
  if (trained == map.vocabulary()) return ground(grounder, text, executor, starts, arena, options);
  const LiftedReader& reader = *grounder.commands;
  const HallwayThings things(map.vocabulary(), reader.mentions().synonyms.get());
  const std::vector<std::string> tokens = tokenize(text);
  const RenamedMap renamed(trained, map, tokens, find_mentions(tokens, things.things(), &reader.vectors()),
                           things.things());
  ltl::Arena in_trained_names(trained);
  std::vector<Reading> readings =
      ground(grounder, renamed.text(), Executor(renamed.map()), starts, in_trained_names, options);
  for (Reading& r : readings) r.formula = renamed.in_own_names(r.formula, arena);
  return readings;
}

}  // namespace

Understanding understand(const Grounder& grounder, const std::string& text, const Executor& executor,
                         std::span<const plan::PoseId> starts, ltl::Arena& arena, const UnderstandOptions& options) {
  Understanding out;
  if (!grounder.commands) {
    out.readings = ground(grounder, text, executor, starts, arena, options.ground);
    return out;
  }
  const LiftedReader& reader = *grounder.commands;
  const HallwayThings things(executor.map().vocabulary(), reader.mentions().synonyms.get());
  const LiftedMentions lifted = things.lift(tokenize(text), &reader.vectors());
  const Bindings bindings = things.bindings(arena, lifted.things, place_number(executor.map(), starts));
  double route = 0, nothing = 0;
  std::vector<Found> found;
  for (const LiftedReading& r : reader.read(lifted.text, beam)) {
    const double p = std::exp(r.log_probability);
    if (r.lifted.front() == Route) {
      route += p;
    } else if (r.lifted.front() == Nothing) {
      nothing += p;
    } else if (const auto formula = formula_of(r.lifted, bindings)) {
      add(found, {{*formula, p, {}}, is_ongoing(r.lifted, *formula)});
    }
  }
  if (const auto said = exact_reading(text, executor.map(), arena)) {
    for (Found& f : found) f.reading.probability *= 1 - exactly_said;
    route *= 1 - exactly_said;
    nothing *= 1 - exactly_said;
    std::erase_if(found, [&](const Found& f) { return f.reading.formula == said->formula; });
    found.push_back({{said->formula, exactly_said, {}}, said->ongoing, true});
  }
  double commands = 0;
  for (const Found& f : found) commands += f.reading.probability;
  out.words_not_understood = unknown_words(reader, lifted.text);
  const double understood = route + commands;
  out.probability = understood + nothing > 0 ? understood / (understood + nothing) : 0;
  if (out.probability < options.least) {
    out.missing = missing_name(reader, lifted.text, things.things());
    return out;
  }
  const auto likelier = [](const Found& a, const Found& b) { return a.reading.probability > b.reading.probability; };
  std::stable_sort(found.begin(), found.end(), likelier);
  merge_languages(found);
  weigh_by_routes(found, executor.map(), starts);
  std::stable_sort(found.begin(), found.end(), likelier);
  std::vector<Found> programs;
  if (route > 0.05 * understood || found.empty())
    for (Reading& r : route_readings(grounder, text, executor, starts, arena, options.ground)) {
      r.probability *= route;
      const ltl::Formula direct = with_direct_turns(r.formula);
      if (programs.size() < planned && direct != r.formula && !has_no_route(executor.map(), direct, starts))
        r.formula = direct;
      programs.push_back({std::move(r), false});
    }
  for (Found& f : programs) add(found, std::move(f));
  std::stable_sort(found.begin(), found.end(), likelier);
  double total = 0;
  for (const Found& f : found) total += f.reading.probability;
  if (!found.empty()) out.ongoing = found.front().ongoing;
  for (Found& f : found) {
    if (total > 0) f.reading.probability /= total;
    out.readings.push_back(std::move(f.reading));
  }
  return out;
}

}  // namespace waymark::parser
