#include "libparser/lifted/lifted_formula.hpp"

#include <stdexcept>

namespace waymark::parser {
namespace {

using ltl::Formula;
using enum LiftedSymbol;

// One of these is thrown where a literal is missing: the only way out of the recursion, caught in formula_of alone.
struct NoSuchLiteral {};

class Denotation {
 public:
  Denotation(std::span<const LiftedSymbol> lifted, const Bindings& bindings) : lifted_(lifted), bindings_(bindings) {}

  Formula whole() {
    const Formula f = formula();
    if (at_ != lifted_.size()) throw std::invalid_argument("symbols follow a complete lifted formula");
    return f;
  }

 private:
  LiftedSymbol take() {
    if (at_ == lifted_.size()) throw std::invalid_argument("the lifted formula is incomplete");
    return lifted_[at_++];
  }
  LiftedSymbol peek() const {
    if (at_ == lifted_.size()) throw std::invalid_argument("the lifted formula is incomplete");
    return lifted_[at_];
  }
  Formula literal(LiftedSymbol direction, LiftedSymbol thing) const {
    const auto f = bindings_.literal(direction, thing);
    if (!f) throw NoSuchLiteral();
    return *f;
  }
  std::vector<Formula> operands() {
    std::vector<Formula> all;
    while (peek() != End) all.push_back(formula());
    take();
    return all;
  }
  std::vector<Formula> places() {
    std::vector<Formula> all = operands();
    if (all.empty()) throw std::invalid_argument("an order of no places");
    return all;
  }
  template <class Each>
  Formula all_of(const Each& each) {
    std::vector<Formula> parts;
    for (const Formula f : operands()) parts.push_back(each(f));
    return ltl::conjunction(*bindings_.arena, parts);
  }

  Formula formula() {
    const LiftedSymbol s = take();
    if (is_thing(s) || is_event(s)) return literal(End, s);
    if (is_direction(s)) return literal(s, take());
    switch (s) {
      case True: return bindings_.arena->constant(true);
      case Not: return ltl::negate(formula());
      case And: return ltl::conjunction(*bindings_.arena, operands());
      case Or: return ltl::disjunction(*bindings_.arena, operands());
      case Next: return ltl::next(formula());
      case Eventually: return ltl::eventually(formula());
      case Always: return ltl::always(formula());
      case Visit: return all_of(ltl::eventually);
      case Patrol: return all_of([](Formula f) { return ltl::always(ltl::eventually(f)); });
      case Never: return all_of([](Formula f) { return ltl::always(ltl::negate(f)); });
      case Sequence: return sequence();
      case Ordered: return ordered(places(), false);
      case Strict: return ordered(places(), true);
      case Alternate: return alternate(operands());
      case Exactly:
      case AtMost:
      case AtLeast: return counted(s);
      case StayOn: return stay_on();
      case IfElse: return if_else();
      default: return binary(s);
    }
  }

  Formula binary(LiftedSymbol s) {
    const Formula a = formula(), b = formula();
    switch (s) {
      case Implies: return ltl::implies(a, b);
      case Iff: return ltl::iff(a, b);
      case Until: return ltl::until(a, b);
      case WeakUntil: return ltl::weak_until(a, b);
      case Release: return ltl::release(a, b);
      case React: return ltl::always(ltl::implies(a, ltl::eventually(b)));
      case Follow: return ltl::always(ltl::iff(a, ltl::next(b)));
      case After: return ltl::always(ltl::implies(a, ltl::next(ltl::always(ltl::negate(b)))));
      default: throw std::invalid_argument("'" + name(s) + "' is no formula");
    }
  }

  // Items: formulas to be reached one after another, and actions done at once.
  Formula sequence() {
    std::optional<Formula> rest;
    if (peek() != End) {
      if (is_action(peek())) {
        const LiftedSymbol action = take();
        const std::size_t count = action == Steps || action == Nth ? number_of(take()) : 1;
        if (action == Nth) {
          const Formula passed = formula();
          return straight_to(count, passed, sequence_rest());
        }
        rest = sequence_rest();
        return act(action, count, rest);
      }
      const Formula goal = formula();
      rest = sequence_rest();
      return ltl::eventually(rest ? ltl::conjunction(goal, *rest) : goal);
    }
    throw std::invalid_argument("an empty sequence");
  }
  std::optional<Formula> sequence_rest() {
    if (peek() == End) {
      take();
      return std::nullopt;
    }
    return sequence();
  }
  // Straight on, past all but the nth place where a holds.
  Formula straight_to(std::size_t n, Formula a, std::optional<Formula> rest) const {
    const Formula moved = literal(End, Moved);
    for (; n > 0; --n) {
      Formula met = ltl::conjunction(moved, a);
      if (rest) met = ltl::conjunction(met, *rest);
      rest = ltl::next(ltl::until(ltl::conjunction(moved, ltl::negate(a)), met));
    }
    return *rest;
  }
  Formula act(LiftedSymbol action, std::size_t count, const std::optional<Formula>& rest) const {
    const auto times = [&](LiftedSymbol event, std::size_t n) {
      std::optional<Formula> f = rest;
      for (std::size_t i = 0; i < n; ++i) {
        const Formula now = literal(End, event);
        f = ltl::next(f ? ltl::conjunction(now, *f) : now);
      }
      return *f;
    };
    switch (action) {
      case TurnLeft: return times(TurnedLeft, 1);
      case TurnRight: return times(TurnedRight, 1);
      case TurnAround: {
        const Formula by_right = times(TurnedRight, 2);
        return ltl::disjunction(times(TurnedLeft, 2), by_right);
      }
      default: return times(Moved, count);
    }
  }

  Formula ordered(const std::vector<Formula>& a, bool strict) const {
    std::vector<Formula> parts;
    for (std::size_t i = 0; i + 1 < a.size(); ++i) parts.push_back(ltl::until(ltl::negate(a[i + 1]), a[i]));
    parts.push_back(ltl::eventually(a.back()));
    for (std::size_t i = 0; strict && i + 1 < a.size(); ++i) {
      const Formula not_a = ltl::negate(a[i]);
      parts.push_back(ltl::until(not_a, ltl::until(a[i], ltl::until(not_a, a[i + 1]))));
    }
    return ltl::conjunction(*bindings_.arena, parts);
  }

  // Each again and again, and after each the next one before it comes again.
  Formula alternate(const std::vector<Formula>& a) const {
    std::vector<Formula> parts;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Formula not_a = ltl::negate(a[i]);
      parts.push_back(ltl::always(ltl::eventually(a[i])));
      parts.push_back(ltl::always(ltl::implies(a[i], ltl::until(a[i], ltl::until(not_a, a[(i + 1) % a.size()])))));
    }
    return ltl::conjunction(*bindings_.arena, parts);
  }

  Formula counted(LiftedSymbol s) {
    const std::size_t n = number_of(take());
    const bool event = is_event(peek()) || (peek() == Or && at_ + 1 < lifted_.size() && is_event(lifted_[at_ + 1]));
    const Formula a = formula();
    if (s == AtLeast) return at_least(n, a, event);
    if (s == AtMost) return ltl::negate(at_least(n + 1, a, event));
    return event ? ltl::conjunction(at_least(n, a, event), ltl::negate(at_least(n + 1, a, event))) : exactly(n, a);
  }
  static Formula at_least(std::size_t n, Formula a, bool event) {
    if (n == 1) return ltl::eventually(a);
    const Formula rest = at_least(n - 1, a, event);
    if (event) return ltl::eventually(ltl::conjunction(a, ltl::next(rest)));
    const Formula leave = ltl::conjunction(ltl::negate(a), ltl::until(ltl::negate(a), rest));
    return ltl::eventually(ltl::conjunction(a, ltl::until(a, leave)));
  }
  static Formula exactly(std::size_t n, Formula a) {
    const Formula not_a = ltl::negate(a);
    Formula visits = a, stays = ltl::always(not_a);
    for (std::size_t i = 0; i < n; ++i) {
      if (i > 0) visits = ltl::conjunction(a, ltl::eventually(ltl::conjunction(not_a, ltl::eventually(visits))));
      stays =
          ltl::disjunction(not_a, ltl::always(ltl::disjunction(a, i == 0 ? ltl::always(not_a) : ltl::always(stays))));
    }
    return ltl::strong_release(visits, stays);
  }

  // Where one can move along the thing: moving along it only. Else: it holds always.
  Formula stay_on() {
    if (is_thing(peek()) && bindings_.literal(Along, peek()))
      if (const auto behind = bindings_.literal(Behind, peek())) {
        take();
        return ltl::always(ltl::implies(literal(End, Moved), *behind));
      }
    return ltl::always(formula());
  }

  Formula if_else() {
    const Formula condition = formula(), then = formula(), otherwise = formula();
    const Formula without = ltl::conjunction(ltl::negate(condition), otherwise);
    return ltl::disjunction(ltl::conjunction(condition, then), without);
  }

  std::span<const LiftedSymbol> lifted_;
  const Bindings& bindings_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Formula> formula_of(std::span<const LiftedSymbol> lifted, const Bindings& bindings) {
  try {
    return Denotation(lifted, bindings).whole();
  } catch (const NoSuchLiteral&) {
    return std::nullopt;
  }
}

}  // namespace waymark::parser
