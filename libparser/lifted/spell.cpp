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
  Speller(ltl::Arena& arena, const std::function<std::optional<LiftedSymbol>(ltl::Proposition)>& symbol)
      : arena_(&arena), symbol_(symbol) {
    bindings_.arena = arena_;
    bindings_.literal = [this](LiftedSymbol direction, LiftedSymbol thing) -> std::optional<Formula> {
      const auto at = atoms_.find(thing);
      if (direction != End || at == atoms_.end()) return std::nullopt;
      return at->second;
    };
  }

  Lifted spell(Formula f) {
    for (const ltl::Proposition p : ltl::propositions(f)) atoms_.insert_or_assign(symbol_of(p), arena_->atom(p));
    return formula(f);
  }

 private:
  LiftedSymbol symbol_of(ltl::Proposition p) const {
    const auto s = symbol_(p);
    if (!s) throw NoSymbol();
    return *s;
  }

  bool means(const Lifted& lifted, Formula f) const { return formula_of(lifted, bindings_) == f; }

  Lifted formula(Formula f) {
    if (f.op() == Op::Atom) return {symbol_of(f.proposition())};
    if (f.op() == Op::True) return {True};
    if (f.op() == Op::False) return {Not, True};
    if (auto found = macro(f)) return std::move(*found);
    return viewed(ltl::view(f, {.bounds = false}));
  }

  // The places of f in ascending order of their symbols.
  std::vector<LiftedSymbol> places(Formula f) const {
    std::vector<LiftedSymbol> all;
    for (const ltl::Proposition p : ltl::propositions(f)) all.push_back(symbol_of(p));
    std::sort(all.begin(), all.end());
    return all;
  }

  std::optional<Lifted> macro(Formula f) const {
    const std::vector<LiftedSymbol> all = places(f);
    if (all.empty()) return std::nullopt;
    if (all.size() == 1) return over_one(f, all.front());
    if (all.size() <= most_places) return over_many(f, all);
    return std::nullopt;
  }

  std::optional<Lifted> over_one(Formula f, LiftedSymbol a) const {
    for (const LiftedSymbol s : {Visit, Patrol, Never})
      if (Lifted candidate = s == Visit ? Lifted{Eventually, a} : Lifted{s, a, End}; means(candidate, f))
        return candidate;
    for (std::size_t n = 1; n <= most_visits; ++n)
      for (const LiftedSymbol s : {Exactly, AtMost, AtLeast})
        if (Lifted candidate{s, number(n), a}; means(candidate, f)) return candidate;
    return std::nullopt;
  }

  std::optional<Lifted> over_many(Formula f, std::vector<LiftedSymbol> order) const {
    do {
      for (const LiftedSymbol s : {Visit, Patrol, Never, Sequence, Ordered, Strict, Alternate}) {
        const bool any_order = s == Visit || s == Patrol || s == Never;
        if (any_order && !std::is_sorted(order.begin(), order.end())) continue;
        Lifted candidate{s};
        candidate.insert(candidate.end(), order.begin(), order.end());
        candidate.push_back(End);
        if (means(candidate, f)) return candidate;
      }
      if (order.size() == 2)
        for (const LiftedSymbol s : {React, Follow, After})
          if (Lifted candidate{s, order[0], order[1]}; means(candidate, f)) return candidate;
    } while (std::next_permutation(order.begin(), order.end()));
    return std::nullopt;
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
        out = {Not, Next, Not};
        break;
      case ltl::Symbol::Yesterday:  // lifted formulas have no past
      case ltl::Symbol::WeakYesterday:
      case ltl::Symbol::Once:
      case ltl::Symbol::Historically:
      case ltl::Symbol::Since:
      case ltl::Symbol::Triggered: throw NoSymbol();
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
  const std::function<std::optional<LiftedSymbol>(ltl::Proposition)>& symbol_;
  std::map<LiftedSymbol, Formula> atoms_;
  Bindings bindings_;
};

}  // namespace

std::optional<Lifted> spell(Formula f, const std::function<std::optional<LiftedSymbol>(ltl::Proposition)>& symbol) {
  try {
    return canonical(Speller(f.arena(), symbol).spell(f));
  } catch (const NoSymbol&) {
    return std::nullopt;
  }
}

}  // namespace waymark::parser
