#include "libltl/english/phrase.hpp"

#include <algorithm>
#include <vector>

#include "libltl/patterns/patterns.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/view.hpp"

namespace waymark::ltl {
namespace {

constexpr std::pair<std::string_view, std::string_view> table[] = {
    {"{v} where {s}, then {t}", "F (v & s & t)"},
    {"{v} where {s}", "F (v & s)"},
    {"{v}, then {t}", "F (v & t)"},
    {"{v}", "F v"},
    {"{v} again and again", "G F v"},
    {"any number of times {a}, then {t}", "t | X (a U (a & t))"},
    {"{a} so that {s}, then {t}", "X (a & s & t)"},
    {"{a} so that {s}", "X (a & s)"},
    {"{a}, then {t}", "X (a & t)"},
    {"{a}", "X a"},
    {"{a} until {s}, then {t}", "X (a U (a & s & t))"},
    {"{a} until {s}", "X (a U (a & s))"},
    {"while {r}, {a} until {s}, then {t}", "r & X ((a & r) U (a & s & t))"},
    {"while {r}, {a} until {s}", "r & X ((a & r) U (a & s))"},
    {"do not {e} until {s}, then {t}", "!e U (s & t)"},
    {"do not {e} until {s}", "!e U s"},
    {"never {e}", "G !e"},
    {"from the next step on, never {e}", "X G !e"},
    {"whenever {x}, from the next step on, never {e}", "G (x -> X G !e)"},
    {"whenever {x}, {v}", "G (x -> F v)"},
    {"whenever {x}, {r} later or at the same time", "G (x -> F r)"},
    {"whenever {x}, {t}", "G (x -> t)"},
    {"at no time {s}", "G !s"},
    {"again and again {s}", "G F s"},
    {"always {t}", "G t"},
    {"from some time on, always {t}", "F G t"},
    {"eventually {s}, then {t}", "F (s & t)"},
    {"eventually {t}", "F t"},
    {"there is a next step", "X true"},
    {"this is the last step", "N false"},
    {"from the next step on, at no time {s}", "X G !s"},
    {"from the next step on, always {t}", "X G t"},
    {"one step later {t}", "X t"},
    {"one step later, if any, {t}", "N t"},
    {"there is a step before", "Y true"},
    {"this is the first step", "Z false"},
    {"one step before {t}", "Y t"},
    {"one step before, if any, {t}", "Z t"},
    {"at some time up to now {t}", "O t"},
    {"at all times up to now {t}", "H t"},
    {"{x} ever since {y}", "x S y"},
    {"{y} back to and including the time when {x}, if there is one", "x T y"},
    {"before {r}, which happens, {s} in at most one stretch", "!s U (s U (!s U r))"},
    {"{s} until {r}, then {t}", "s U (r & t)"},
    {"{x} until {y}, or always", "x W y"},
    {"{y} up to and including the time when {x}, if that time comes", "x R y"},
    {"{y} up to and including the time when {x}", "x M y"},
    {"{x} until {y}", "x U y"},
    {"if {l}, {c}, otherwise {t}", "(l & c) | (!l & t)"},
    {"if {x}, {t}", "x -> t"},
    {"{x} exactly when {t}", "x <-> t"},
    {"{x} exactly when it is not so that {t}", "!(x <-> t)"},
    {"it is not so that {t}", "!t"},
};

using Counted = std::optional<Bindings>;

Formula times(Formula (*wrap)(Formula), std::size_t n, Formula f) {
  for (; n > 0; --n) f = wrap(f);
  return f;
}

Counted nested(Formula f, Op op) {
  Bindings out;
  for (; f.op() == op; f = f[0]) ++out.n;
  out['t'] = f;
  return out.n < 2 ? std::nullopt : Counted(out);
}

Counted bounded(Formula f, Op junction) {
  if (f.op() != junction) return std::nullopt;
  const View seen = view(f);
  if (!seen.bound) return std::nullopt;
  Bindings out;
  out.n = *seen.bound;
  const auto& body = seen.operands.front();
  out['t'] = junction == Op::Or ? disjunction(f.arena(), body.parts) : conjunction(f.arena(), body.parts);
  return out;
}

// X (a ∧ X (a ∧ … ∧ t)), n times a
Formula repeated(Arena& arena, const Bindings& bound) {
  Formula f = bound['t'].value_or(arena.constant(true));
  for (std::size_t i = 0; i < bound.n; ++i) f = next(conjunction(*bound['a'], f));
  return f;
}

Counted repeated_action(Formula f, bool has_rest) {
  if (f.op() != Op::Next || f[0].op() != Op::And) return std::nullopt;
  for (Formula action : f[0].operands()) {
    Bindings out;
    out['a'] = action;
    Formula level = f;
    while (level.op() == Op::Next) {
      std::vector<Formula> parts = {level[0]};
      if (level[0].op() == Op::And) parts.assign(level[0].operands().begin(), level[0].operands().end());
      if (std::erase(parts, action) == 0) break;
      ++out.n;
      level = conjunction(f.arena(), parts);
    }
    if (out.n < 2 || (level.op() == Op::True) == has_rest) continue;
    if (has_rest) out['t'] = level;
    return out;
  }
  return std::nullopt;
}

// F (s ∧ (s U (¬s ∧ (¬s U F …)))): at least n stretches of time
Formula stretches(std::size_t n, Formula s) {
  Formula f = eventually(s);
  for (; n > 1; --n) f = eventually(conjunction(s, until(s, conjunction(negate(s), until(negate(s), f)))));
  return f;
}

// Exactly n stretches: (s ∧ F (¬s ∧ F …)) M (¬s ∨ G (s ∨ G …)).
Formula exact_stretches(std::size_t n, Formula s) {
  Formula least = s, most = negate(s);
  for (std::size_t i = 1; i < n; ++i) least = conjunction(s, eventually(conjunction(negate(s), eventually(least))));
  for (std::size_t i = 0; i < n; ++i) most = disjunction(negate(s), always(disjunction(s, always(most))));
  return strong_release(least, most);
}

using OfNumber = Formula (*)(Arena&, const Bindings&);

// n and the only proposition of f, where make(n, that) is f.
template <OfNumber make, std::size_t least = 1>
Counted counted(Formula f) {
  if (f.op() != Op::Until && f.op() != Op::Not) return std::nullopt;
  const auto names = propositions(f);
  if (names.size() != 1) return std::nullopt;
  Bindings out;
  out['s'] = f.arena().atom(names.front());
  const std::size_t size = tree_size(f);
  for (out.n = least;; ++out.n) {
    const Formula made = make(f.arena(), out);
    if (made == f) return out;
    if (tree_size(made) > size) return std::nullopt;
  }
}

Formula at_least_stretches(Arena&, const Bindings& b) { return stretches(b.n, *b['s']); }
Formula at_most_stretches(Arena&, const Bindings& b) { return negate(stretches(b.n + 1, *b['s'])); }
Formula exactly_stretches(Arena&, const Bindings& b) { return exact_stretches(b.n, *b['s']); }
Formula at_least_moments(Arena&, const Bindings& b) {
  return restricted_avoidance(Mission::LowerRestrictedAvoidance, b.n, *b['s']);
}
Formula at_most_moments(Arena&, const Bindings& b) {
  return restricted_avoidance(Mission::UpperRestrictedAvoidance, b.n, *b['s']);
}
Formula exactly_moments(Arena&, const Bindings& b) {
  return restricted_avoidance(Mission::ExactRestrictedAvoidance, b.n, *b['s']);
}

constexpr CountedPhrase counted_table[] = {
    {"{a} {n} times, then {t}", repeated, [](Formula f) { return repeated_action(f, true); }},
    {"{a} {n} times", repeated, [](Formula f) { return repeated_action(f, false); }},
    {"{n} steps later {t}", [](Arena&, const Bindings& b) { return times(next, b.n, *b['t']); },
     [](Formula f) { return nested(f, Op::Next); }},
    {"{n} steps later, if any, {t}", [](Arena&, const Bindings& b) { return times(weak_next, b.n, *b['t']); },
     [](Formula f) { return nested(f, Op::WeakNext); }},
    {"within {n} steps {t}", [](Arena&, const Bindings& b) { return eventually_within(b.n, *b['t']); },
     [](Formula f) { return bounded(f, Op::Or); }},
    {"now and for {n} more steps, if any, {t}", [](Arena&, const Bindings& b) { return always_within(b.n, *b['t']); },
     [](Formula f) { return bounded(f, Op::And); }},
    {"the number of stretches in which {s} is at most {n}", at_most_stretches, counted<at_most_stretches>},
    {"the number of stretches in which {s} is exactly {n}", exactly_stretches, counted<exactly_stretches>},
    {"the number of moments at which {s} is at least {n}", at_least_moments, counted<at_least_moments, 2>},
    {"the number of stretches in which {s} is at least {n}", at_least_stretches, counted<at_least_stretches, 2>},
    {"the number of moments at which {s} is at most {n}", at_most_moments, counted<at_most_moments>},
    {"the number of moments at which {s} is exactly {n}", exactly_moments, counted<exactly_moments>},
};

}  // namespace

Slot slot_of(char letter) {
  switch (letter) {
    case 'x':
    case 'y': return Slot::LooseState;
    case 'l': return Slot::Literal;
    case 'v': return Slot::Visit;
    case 'e': return Slot::Enter;
    case 'a': return Slot::Act;
    case 'c': return Slot::Closed;
    case 't': return Slot::Tail;
    default: return Slot::State;
  }
}

std::span<const Phrase> phrases() {
  struct Rows {
    Arena arena;
    std::vector<Phrase> rows;
    Rows() {
      for (char letter = 'a'; letter <= 'z'; ++letter) arena.add_proposition(std::string(1, letter));
      for (const auto& [english, formula] : table) rows.push_back({english, parse(formula, arena)});
    }
  };
  static const Rows parsed;
  return parsed.rows;
}

std::span<const CountedPhrase> counted_phrases() { return counted_table; }

}  // namespace waymark::ltl
