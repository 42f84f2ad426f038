// The mission patterns, and patterns by name. [MTP+21, Tables 2 to 4]
#include <array>
#include <charconv>
#include <initializer_list>
#include <span>
#include <stdexcept>

#include "libltl/patterns/patterns.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

namespace waymark::ltl {
namespace {

using Places = std::span<const Formula>;

struct MissionRow {
  const char* name;
  const char* parameters;
  const char* sentence;
};

constexpr std::array<MissionRow, 22> mission_rows{{
    {"visit", "l..", "Visit all places, in any order."},
    {"sequenced-visit", "l..", "Visit the places, each some time after the one before."},
    {"ordered-visit", "l..", "Visit the places in this order, none before its predecessor."},
    {"strict-ordered-visit", "l..", "Visit the places in this order, and none a second time before its successor."},
    {"fair-visit", "l..", "Visit all places, none ever two times more often than another."},
    {"patrolling", "l..", "Keep visiting all places, in any order."},
    {"sequenced-patrolling", "l..", "Keep visiting the places, each some time after the one before."},
    {"ordered-patrolling", "l..", "Keep visiting the places in this order, none before its predecessor."},
    {"strict-ordered-patrolling", "l..",
     "Keep visiting the places in this order, and none a second time before its successor."},
    {"fair-patrolling", "l..", "Keep visiting all places, none ever two times more often than another."},
    {"global-avoidance", "l", "Never be at l."},
    {"past-avoidance", "l p", "Do not be at l until p holds, which it will."},
    {"future-avoidance", "l c", "Once c held, never be at l."},
    {"upper-restricted-avoidance", "n l", "Be at l at most n times."},
    {"lower-restricted-avoidance", "n l", "Be at l at least n times."},
    {"exact-restricted-avoidance", "n l", "Be at l exactly n times."},
    {"instantaneous-reaction", "p s", "Whenever p holds, s holds at once."},
    {"delayed-reaction", "p s", "Whenever p holds, s holds then or later."},
    {"prompt-reaction", "p s", "Whenever p holds, s holds at the next instant."},
    {"bound-reaction", "p s", "s holds when p does, and only then."},
    {"bound-delay", "p s", "s holds at the next instant when p holds, and only then."},
    {"wait", "l p", "Stay at l until p holds, which it will."},
}};

const MissionRow& row_of(Mission mission) { return mission_rows[static_cast<std::size_t>(mission)]; }

bool counts(const MissionRow& row) { return std::string_view(row.parameters) == "n l"; }

// How many arguments it takes; 0: one or more.
std::size_t arity(const MissionRow& row) {
  const std::string_view names = row.parameters;
  return names == "l.." ? 0 : (names.size() + 1) / 2;
}

Formula sequence(Places places) {  // F (l₁ ∧ F (l₂ ∧ …))
  Formula rest = eventually(places.back());
  for (std::size_t i = places.size() - 1; i-- > 0;) rest = eventually(conjunction(places[i], rest));
  return rest;
}

Formula in_order(Places places) {  // ⋀ ¬lᵢ₊₁ U lᵢ
  std::vector<Formula> all;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) all.push_back(until(negate(places[i + 1]), places[i]));
  return conjunction(places.front().arena(), all);
}

Formula for_all(Places places, Formula (*claim)(Places, std::size_t), std::size_t count) {
  std::vector<Formula> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(claim(places, i));
  return conjunction(places.front().arena(), all);
}

Formula visited(Places l, std::size_t i) { return eventually(l[i]); }
Formula patrolled(Places l, std::size_t i) { return always(eventually(l[i])); }
Formula after(Places l, std::size_t i) { return l[(i + 1) % l.size()]; }
// lᵢ is not left behind: not again before its successor.
Formula successor_first(Places l, std::size_t i) {
  return until(negate(l[i]), conjunction(l[i], next(until(negate(l[i]), l[i + 1]))));
}
Formula predecessor_again(Places l, std::size_t i) {
  return always(implies(after(l, i), next(until(negate(after(l, i)), l[i]))));
}
Formula successor_again(Places l, std::size_t i) {
  return always(implies(l[i], next(until(negate(l[i]), after(l, i)))));
}

// The visits of two places, counted along the word, never differ by more than one. An instant at both counts for both
// and is passed over. Visits of a alone (x) and of b alone (y) alternate, but for two of one kind in a row, after which
// they alternate until two of the other kind stand in a row; so they do after the first visit.
// [MTP+21] has l → X(¬l W l′) for the next place l′ of the list only: that refuses fair words, such as (a b c)(b c a),
// and its own example (tests/libltl/patterns).
void balance(std::vector<Formula>& all, Formula a, Formula b) {
  const Formula x = conjunction(a, negate(b)), y = conjunction(b, negate(a)), none = iff(a, b);
  // At a visit: the next one is of the other kind, until that kind has two in a row.
  const auto alternating = [&](Formula visit, Formula other) {
    const Formula turns = implies(visit, weak_next(weak_until(none, other)));
    return conjunction(visit, weak_until(turns, conjunction(other, next(until(none, other)))));
  };
  const Formula from_x = alternating(x, y), from_y = alternating(y, x);
  all.push_back(always(implies(x, weak_next(weak_until(none, disjunction(y, from_x))))));
  all.push_back(always(implies(y, weak_next(weak_until(none, disjunction(x, from_y))))));
  all.push_back(weak_until(none, disjunction(from_x, from_y)));
}

Formula balanced(Places l) {
  std::vector<Formula> all;
  for (std::size_t i = 0; i < l.size(); ++i)
    for (std::size_t k = i + 1; k < l.size(); ++k) balance(all, l[i], l[k]);
  return conjunction(l.front().arena(), all);
}

// Braces make the parts from left to right with every compiler; arguments of a call would not be.
Formula all_of(std::initializer_list<Formula> parts) {
  return conjunction(parts.begin()->arena(), std::span<const Formula>(parts.begin(), parts.size()));
}

Formula ordered_patrolling(Places l) {
  return all_of({always(sequence(l)), in_order(l), for_all(l, predecessor_again, l.size())});
}

Formula over_places(Mission mission, Places l) {
  const std::size_t n = l.size();
  switch (mission) {
    case Mission::Visit: return for_all(l, visited, n);
    case Mission::SequencedVisit: return sequence(l);
    case Mission::OrderedVisit: return all_of({sequence(l), in_order(l)});
    case Mission::StrictOrderedVisit: return all_of({sequence(l), in_order(l), for_all(l, successor_first, n - 1)});
    case Mission::FairVisit: return all_of({for_all(l, visited, n), balanced(l)});
    case Mission::Patrolling: return for_all(l, patrolled, n);
    case Mission::SequencedPatrolling: return always(sequence(l));
    case Mission::OrderedPatrolling: return ordered_patrolling(l);
    case Mission::StrictOrderedPatrolling: return all_of({ordered_patrolling(l), for_all(l, successor_again, n - 1)});
    case Mission::FairPatrolling: return all_of({for_all(l, patrolled, n), balanced(l)});
    case Mission::GlobalAvoidance: return always(negate(l[0]));
    case Mission::PastAvoidance: return until(negate(l[0]), l[1]);
    case Mission::FutureAvoidance: return always(implies(l[1], always(negate(l[0]))));
    case Mission::InstantaneousReaction: return always(implies(l[0], l[1]));
    case Mission::DelayedReaction: return always(implies(l[0], eventually(l[1])));
    case Mission::PromptReaction: return always(implies(l[0], next(l[1])));
    case Mission::BoundReaction: return always(iff(l[0], l[1]));
    case Mission::BoundDelay: return always(iff(l[0], next(l[1])));
    case Mission::Wait: return until(l[0], l[1]);
    case Mission::UpperRestrictedAvoidance:
    case Mission::LowerRestrictedAvoidance:
    case Mission::ExactRestrictedAvoidance: break;
  }
  throw std::invalid_argument(std::string(row_of(mission).name) + " takes a number and a place");
}

Formula at_least(std::size_t times, Formula place) {  // F (l ∧ X F (l ∧ …))
  Formula rest = eventually(place);
  for (; times > 1; --times) rest = eventually(conjunction(place, next(rest)));
  return rest;
}

// After the last time there may be no next instant: the weak next, where [MTP+21] has X for infinite words.
Formula exactly(std::size_t times, Formula place) {
  Formula rest = until(negate(place), conjunction(place, weak_next(always(negate(place)))));
  for (; times > 1; --times) rest = until(negate(place), conjunction(place, next(rest)));
  return rest;
}

std::size_t number(const std::string& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  constexpr std::size_t most = most_levels / 4;  // each time adds a few levels
  if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > most)
    throw std::invalid_argument("expected a number from 1 to " + std::to_string(most) + ", not '" + text + "'");
  return value;
}

Formula instantiate_mission(Mission mission_, std::span<const std::string> arguments, Arena& arena) {
  const MissionRow& row = row_of(mission_);
  if (counts(row)) {
    if (arguments.size() != 2) throw std::invalid_argument(std::string(row.name) + " takes a number and a place");
    return restricted_avoidance(mission_, number(arguments[0]), parse(arguments[1], arena));
  }
  std::vector<Formula> places;
  for (const std::string& text : arguments) places.push_back(parse(text, arena));
  return mission(mission_, places);
}

}  // namespace

Formula mission(Mission mission, std::span<const Formula> places) {
  const MissionRow& row = row_of(mission);
  const std::size_t wanted = arity(row);
  if (places.empty() || (wanted != 0 && places.size() != wanted))
    throw std::invalid_argument(std::string(row.name) + " takes " +
                                (wanted == 0 ? "one or more" : std::to_string(wanted)) + " arguments (" +
                                row.parameters + "), not " + std::to_string(places.size()));
  return over_places(mission, places);
}

Formula restricted_avoidance(Mission mission, std::size_t times, Formula place) {
  if (times < 1) throw std::invalid_argument("restricted avoidance: at least one time");
  if (mission == Mission::UpperRestrictedAvoidance) return negate(at_least(times + 1, place));
  if (mission == Mission::LowerRestrictedAvoidance) return at_least(times, place);
  if (mission == Mission::ExactRestrictedAvoidance) return exactly(times, place);
  throw std::invalid_argument(std::string(row_of(mission).name) + " does not count");
}

std::vector<Pattern> mission_patterns() {
  std::vector<Pattern> out;
  for (std::size_t i = 0; i < mission_rows.size(); ++i) {
    const MissionRow& row = mission_rows[i];
    std::vector<std::string> arguments;
    for (std::size_t k = 0; k < arity(row); ++k) arguments.emplace_back(1, row.parameters[2 * k]);
    if (counts(row)) arguments[0] = "2";
    if (arity(row) == 0) arguments = {"l1", "l2", "l3"};
    Arena arena;
    out.push_back({.name = row.name,
                   .parameters = row.parameters,
                   .sentence = row.sentence,
                   .source = "MTP+21",
                   .formula = print(instantiate_mission(static_cast<Mission>(i), arguments, arena))});
  }
  return out;
}

Formula instantiate(std::string_view name, std::span<const std::string> arguments, Arena& arena) {
  Vocabulary names;
  for (std::size_t i = 0; i < mission_rows.size(); ++i) {
    if (mission_rows[i].name == name) return instantiate_mission(static_cast<Mission>(i), arguments, arena);
    names.add(mission_rows[i].name);
  }
  const std::vector<Pattern> properties = property_patterns();
  for (std::size_t i = 0; i < properties.size(); ++i) {
    names.add(properties[i].name);
    if (properties[i].name.ends_with("-globally"))
      names.add(properties[i].name.substr(0, properties[i].name.size() - std::string_view("-globally").size()));
    if (properties[i].name != name) continue;
    std::vector<Formula> formulas;
    for (const std::string& text : arguments) formulas.push_back(parse(text, arena));
    return property(static_cast<Body>(i / 5), static_cast<Scope>(i % 5), formulas);
  }
  const std::string unscoped = std::string(name) + "-globally";
  const auto known = [&](const std::string& pattern) {
    return std::any_of(mission_rows.begin(), mission_rows.end(),
                       [&](const auto& row) { return row.name == pattern; }) ||
           std::any_of(properties.begin(), properties.end(), [&](const Pattern& p) { return p.name == pattern; });
  };
  auto nearest = known(unscoped) ? std::optional(unscoped) : names.nearest(name);
  if (nearest && !known(*nearest)) *nearest += "-globally";  // a slip in the name of the body
  throw std::invalid_argument("there is no pattern '" + std::string(name) + "'" +
                              (nearest ? " (did you mean '" + *nearest + "'?)" : ""));
}

}  // namespace waymark::ltl
