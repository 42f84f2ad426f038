// Formula → lifted formula: macros are found by building them and comparing; equal formulas are one pointer.
#include <algorithm>
#include <map>

#include "libltl/text/view.hpp"
#include "libparser/lifted/lifted_formula.hpp"

namespace waymark::parser {
namespace {

using ltl::Formula;
using ltl::Op;
using enum LiftedSymbol;

struct NoSymbol {};  // thrown where a proposition or an operator has no symbol, caught in spell alone

constexpr std::size_t most_places = 5, most_visits = 5;

class Speller {
 public:
  Speller(ltl::Arena& arena, const SpelledLiteral& literal) : arena_(&arena), literal_(literal) {
    bindings_.arena = arena_;
    bindings_.literal = [this](LiftedSymbol direction, LiftedSymbol thing) -> std::optional<Formula> {
      if (direction == Along) return along(thing);
      const auto at = atoms_.find(direction == End ? Lifted{thing} : Lifted{direction, thing});
      return at == atoms_.end() ? std::nullopt : std::optional(at->second);
    };
  }

  Lifted spell(Formula f) {
    for (const ltl::Proposition p : ltl::propositions(f)) atoms_.insert_or_assign(literal_of(p), arena_->atom(p));
    return formula(f);
  }

 private:
  Lifted literal_of(ltl::Proposition p) const {
    const auto s = literal_(p);
    if (!s) throw NoSymbol();
    return *s;
  }
  std::optional<Formula> along(LiftedSymbol thing) const {
    const auto moved = atoms_.find({Moved}), behind = atoms_.find({Behind, thing});
    if (moved == atoms_.end() || behind == atoms_.end()) return std::nullopt;
    return ltl::conjunction(moved->second, behind->second);
  }

  bool means(const Lifted& lifted, Formula f) const { return formula_of(lifted, bindings_) == f; }

  Lifted formula(Formula f) {
    if (f.op() == Op::Atom) return literal_of(f.proposition());
    if (f.op() == Op::True) return {True};
    if (f.op() == Op::False) return {Not, True};
    if (auto found = macro(f)) return std::move(*found);
    if (auto found = if_else(f)) return std::move(*found);
    if (const auto found = items(f); found && found->acts) {
      Lifted candidate{Sequence};
      candidate.insert(candidate.end(), found->symbols.begin(), found->symbols.end());
      candidate.push_back(End);
      if (means(candidate, f)) return candidate;
    }
    return viewed(ltl::view(f, {.bounds = false}));
  }

  // The literals of f in ascending order.
  std::vector<Lifted> places(Formula f) const {
    std::vector<Lifted> all;
    for (const ltl::Proposition p : ltl::propositions(f)) all.push_back(literal_of(p));
    std::sort(all.begin(), all.end());
    return all;
  }

  static Lifted with(std::initializer_list<LiftedSymbol> head, std::span<const Lifted> operands, bool ends) {
    Lifted out(head);
    for (const Lifted& o : operands) out.insert(out.end(), o.begin(), o.end());
    if (ends) out.push_back(End);
    return out;
  }

  std::optional<Lifted> macro(Formula f) const {
    const std::vector<Lifted> all = places(f);
    if (all.empty()) return std::nullopt;
    if (all.size() == 1) return over_one(f, all);
    if (all.size() <= most_places) return over_many(f, all);
    return std::nullopt;
  }

  std::optional<Lifted> over_one(Formula f, const std::vector<Lifted>& a) const {
    for (const LiftedSymbol s : {Visit, Patrol, Never})
      if (Lifted candidate = s == Visit ? with({Eventually}, a, false) : with({s}, a, true); means(candidate, f))
        return candidate;
    return counted(f, a.front());
  }
  std::optional<Lifted> counted(Formula f, const Lifted& a) const {
    for (std::size_t n = 1; n <= most_visits; ++n)
      for (const LiftedSymbol s : {Exactly, AtMost, AtLeast})
        if (Lifted candidate = with({s, number(n)}, {&a, 1}, false); means(candidate, f)) return candidate;
    return std::nullopt;
  }

  std::optional<Lifted> over_many(Formula f, std::vector<Lifted> order) const {
    if (order.size() == 2) {
      if (auto found = counted(f, with({Or}, order, true))) return found;
      if (ltl::is_always(f))
        for (const Lifted& behind : order)
          if (behind.size() == 2 && behind[0] == Behind)
            if (Lifted candidate{StayOn, behind[1]}; means(candidate, f)) return candidate;
    }
    do {
      for (const LiftedSymbol s : {Visit, Patrol, Never, Sequence, Ordered, Strict, Alternate}) {
        const bool any_order = s == Visit || s == Patrol || s == Never;
        if (any_order && !std::is_sorted(order.begin(), order.end())) continue;
        if (Lifted candidate = with({s}, order, true); means(candidate, f)) return candidate;
      }
      if (order.size() == 2)
        for (const LiftedSymbol s : {React, Follow, After})
          if (Lifted candidate = with({s}, order, false); means(candidate, f)) return candidate;
    } while (std::next_permutation(order.begin(), order.end()));
    return std::nullopt;
  }

  // (c ∧ a) ∨ (¬c ∧ b).
  std::optional<Lifted> if_else(Formula f) {
    if (f.op() != Op::Or || f.operands().size() != 2) return std::nullopt;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const std::vector<Formula> then = parts_of(f[i]), otherwise = parts_of(f[1 - i]);
      for (const Formula condition : then) {
        const Formula opposite = ltl::negate(condition);
        if (condition.op() == Op::Not || std::find(otherwise.begin(), otherwise.end(), opposite) == otherwise.end())
          continue;
        Lifted candidate{IfElse};
        for (const Lifted& part :
             {formula(condition), formula(without(then, condition)), formula(without(otherwise, opposite))})
          candidate.insert(candidate.end(), part.begin(), part.end());
        if (means(candidate, f)) return candidate;
      }
    }
    return std::nullopt;
  }
  static std::vector<Formula> parts_of(Formula f) {
    if (f.op() != Op::And) return {f};
    return {f.operands().begin(), f.operands().end()};
  }
  Formula without(std::vector<Formula> parts, Formula part) const {
    std::erase(parts, part);
    return ltl::conjunction(*arena_, parts);
  }

  // What is done and reached one after another: the inside of a sequence.
  struct Items {
    Lifted symbols;
    bool acts = false;  // some of it is an action
  };
  std::optional<Items> items(Formula f) {
    if (f.op() == Op::Next) return f[0].op() == Op::Until ? straight_to(f[0]) : action(parts_of(f[0]));
    if (ltl::is_eventually(f)) return goal(parts_of(f[1]));
    if (f.op() == Op::Or && f.operands().size() == 2) return turned_around(f);
    return std::nullopt;
  }
  static bool may_follow(Formula f) {
    return f.op() == Op::Next || ltl::is_eventually(f) ||
           (f.op() == Op::Or && f[0].op() == Op::Next && f[1].op() == Op::Next);
  }
  static Items after(Lifted head, const std::optional<Items>& rest, bool acts) {
    if (rest) head.insert(head.end(), rest->symbols.begin(), rest->symbols.end());
    return {std::move(head), acts || (rest && rest->acts)};
  }
  // The rest of a sequence, when parts are just one formula that may be it. None: they are no rest.
  std::optional<std::optional<Items>> rest_of(const std::vector<Formula>& parts) {
    if (parts.empty()) return std::optional<Items>();
    if (parts.size() > 1 || !may_follow(parts.front())) return std::nullopt;
    const auto found = items(parts.front());
    return found ? std::optional(found) : std::nullopt;
  }

  std::optional<Items> action(std::vector<Formula> parts) {
    const auto event = std::find_if(parts.begin(), parts.end(), [&](Formula f) {
      if (f.op() != Op::Atom) return false;
      const Lifted l = literal_of(f.proposition());
      return l == Lifted{Moved} || l == Lifted{TurnedLeft} || l == Lifted{TurnedRight};
    });
    if (event == parts.end()) return std::nullopt;
    const LiftedSymbol done = literal_of(event->proposition()).front();
    parts.erase(event);
    const auto rest = rest_of(parts);
    if (!rest) return std::nullopt;
    if (done != Moved) return after({done == TurnedLeft ? TurnLeft : TurnRight}, *rest, true);
    Items out = after({}, *rest, true);
    if (out.symbols.size() > 1 && out.symbols[0] == Steps && number_of(out.symbols[1]) < 9)
      out.symbols[1] = number(number_of(out.symbols[1]) + 1);
    else
      out.symbols.insert(out.symbols.begin(), {Steps, number(1)});
    return out;
  }

  // (moved ∧ ¬a) U (moved ∧ a ∧ rest), after X.
  std::optional<Items> straight_to(Formula f) {
    std::vector<Formula> passing = parts_of(f[0]), met = parts_of(f[1]);
    const auto moved = atoms_.find({Moved});
    if (moved == atoms_.end() || passing.size() != 2 || std::erase(passing, moved->second) == 0) return std::nullopt;
    const Formula a = ltl::negate(passing.front());
    if (std::erase(met, moved->second) == 0 || std::erase(met, a) == 0) return std::nullopt;
    const auto rest = rest_of(met);
    if (!rest) return std::nullopt;
    const Lifted place = formula(a);
    Items out = after({}, *rest, true);
    const bool again = out.symbols.size() > place.size() + 1 && out.symbols[0] == Nth &&
                       number_of(out.symbols[1]) < 9 && std::equal(place.begin(), place.end(), out.symbols.begin() + 2);
    if (again) {
      out.symbols[1] = number(number_of(out.symbols[1]) + 1);
      return out;
    }
    Lifted head{Nth, number(1)};
    head.insert(head.end(), place.begin(), place.end());
    return after(std::move(head), out, true);
  }

  std::optional<Items> goal(const std::vector<Formula>& parts) {
    std::vector<Formula> here, later;
    for (const Formula part : parts) (may_follow(part) ? later : here).push_back(part);
    if (here.empty()) return std::nullopt;
    if (later.size() == 1)
      if (const auto rest = rest_of(later); rest) return after(formula(ltl::conjunction(*arena_, here)), *rest, false);
    return after(formula(ltl::conjunction(*arena_, parts)), std::nullopt, false);
  }

  std::optional<Items> turned_around(Formula f) {
    if (f[0].op() != Op::Next || f[1].op() != Op::Next) return std::nullopt;
    auto one = items(f[0]), other = items(f[1]);
    if (!one || !other || one->symbols.size() < 2 || other->symbols.size() < 2) return std::nullopt;
    if (one->symbols[0] == TurnRight) std::swap(one, other);
    const auto rest = [](const Items& i) { return Lifted(i.symbols.begin() + 2, i.symbols.end()); };
    if (one->symbols[0] != TurnLeft || one->symbols[1] != TurnLeft || other->symbols[0] != TurnRight ||
        other->symbols[1] != TurnRight || rest(*one) != rest(*other))
      return std::nullopt;
    return after({TurnAround}, Items{rest(*one), false}, true);
  }

  // A conjunction is visits, patrols and avoidances, each together, and the rest by itself.
  Lifted conjunction(std::span<const Formula> parts) {
    std::map<LiftedSymbol, Lifted> groups;
    std::vector<Lifted> rest;
    for (const Formula part : parts) {
      Lifted spelled = formula(part);
      if (spelled.size() == 2 && spelled[0] == Eventually && is_thing(spelled[1]))
        groups[Visit].push_back(spelled[1]);
      else if (spelled.size() == 3 && (spelled[0] == Never || spelled[0] == Patrol))
        groups[spelled[0]].push_back(spelled[1]);
      else
        rest.push_back(std::move(spelled));
    }
    for (auto& [s, members] : groups) {
      std::sort(members.begin(), members.end());
      if (s == Visit && members.size() == 1) {
        rest.push_back({Eventually, members.front()});
        continue;
      }
      members.insert(members.begin(), s);
      members.push_back(End);
      rest.push_back(members);
    }
    return joined(And, std::move(rest));
  }

  static Lifted joined(LiftedSymbol s, std::vector<Lifted> parts) {
    if (parts.size() == 1) return parts.front();
    std::sort(parts.begin(), parts.end());
    Lifted out{s};
    for (const Lifted& part : parts) out.insert(out.end(), part.begin(), part.end());
    out.push_back(End);
    return out;
  }

  Lifted operand(const ltl::ViewOperand& o) {
    if (o.parts.size() == 1) return formula(o.parts.front());
    const std::vector<Formula>& p = o.parts;
    return formula(o.junction == Op::And ? ltl::conjunction(*arena_, p) : ltl::disjunction(*arena_, p));
  }

  Lifted viewed(const ltl::View& view) {
    if (view.symbol == ltl::Symbol::And) {
      std::vector<Formula> parts;
      for (const ltl::ViewOperand& o : view.operands) parts.insert(parts.end(), o.parts.begin(), o.parts.end());
      return conjunction(parts);
    }
    if (view.symbol == ltl::Symbol::Or) {
      std::vector<Lifted> parts;
      for (const ltl::ViewOperand& o : view.operands) parts.push_back(operand(o));
      return joined(Or, std::move(parts));
    }
    Lifted out{};
    std::vector<Lifted> operands;
    for (const ltl::ViewOperand& o : view.operands) operands.push_back(operand(o));
    switch (view.symbol) {
      case ltl::Symbol::Not: out = {Not}; break;
      case ltl::Symbol::Next: out = {Next}; break;
      case ltl::Symbol::Eventually: out = {Eventually}; break;
      case ltl::Symbol::Always: out = {Always}; break;
      case ltl::Symbol::Implies: out = {Implies}; break;
      case ltl::Symbol::Iff: out = {Iff}; break;
      case ltl::Symbol::ExclusiveOr: out = {Not, Iff}; break;
      case ltl::Symbol::Until: out = {Until}; break;
      case ltl::Symbol::WeakUntil: out = {WeakUntil}; break;
      case ltl::Symbol::Release: out = {Release}; break;
      case ltl::Symbol::StrongRelease:  // φ M ψ = ψ U (φ ∧ ψ)
        return spelled_strong_release(operands);
      case ltl::Symbol::WeakNext:  // N φ = !X !φ
        out = {Not, Next};
        if (operands.front().front() == Not)
          operands.front().erase(operands.front().begin());
        else
          out.push_back(Not);
        break;
      case ltl::Symbol::Yesterday:
      case ltl::Symbol::WeakYesterday:
      case ltl::Symbol::Once:
      case ltl::Symbol::Historically:
      case ltl::Symbol::Since:
      case ltl::Symbol::Triggered: throw NoSymbol{};  // commands do not speak of the past
      case ltl::Symbol::And:
      case ltl::Symbol::Or: break;  // above
    }
    for (const Lifted& o : operands) out.insert(out.end(), o.begin(), o.end());
    return out;
  }

  static Lifted spelled_strong_release(const std::vector<Lifted>& o) {
    Lifted out{Until};
    out.insert(out.end(), o[1].begin(), o[1].end());
    out.push_back(And);
    out.insert(out.end(), o[0].begin(), o[0].end());
    out.insert(out.end(), o[1].begin(), o[1].end());
    out.push_back(End);
    return out;
  }

  ltl::Arena* arena_;
  const SpelledLiteral& literal_;
  std::map<Lifted, Formula> atoms_;
  Bindings bindings_;
};

}  // namespace

std::optional<Lifted> spell(Formula f, const SpelledLiteral& literal) {
  try {
    return canonical(Speller(f.arena(), literal).spell(f));
  } catch (const NoSymbol&) {
    return std::nullopt;
  }
}

}  // namespace waymark::parser
