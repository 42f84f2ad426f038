#include "libparser/programs/recognise.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace waymark::parser {
namespace {

using ltl::Formula;
using ltl::Op;

struct Peeled {  // a unit, and what is owed after it
  Program unit;
  Formula rest;
};

std::vector<Formula> operands_of(Formula f, Op op) {
  if (f.op() != op) return {f};
  return {f.operands().begin(), f.operands().end()};
}

// As the grammar's limit counts them.
std::ptrdiff_t steps_counted(const Program& program) {
  return std::count_if(program.begin(), program.end(), [](const Step& step) {
    return step.kind != StepKind::Orient && step.kind != StepKind::Without && step.kind != StepKind::Keep;
  });
}

class Peeler {
 public:
  Peeler(ltl::Arena& arena, const PostfixGrammar& grammar)
      : arena_(arena),
        grammar_(grammar),
        true_(arena.constant(true)),
        moved_(event("moved")),
        turned_left_(event("turned_left")),
        turned_(ltl::disjunction(turned_left_, event("turned_right"))) {}

  // A program of fewest steps whose formula this is, the first of them.
  std::optional<Program> whole(Formula f) {
    if (f == true_) return Program{};
    const auto [known, is_new] = known_.try_emplace(f);
    if (!is_new) return known->second;
    std::optional<Program> best;
    for (Peeled& first : peel(f)) {
      const auto later = whole(first.rest);
      if (!later) continue;
      first.unit.insert(first.unit.end(), later->begin(), later->end());
      if (!best || steps_counted(first.unit) < steps_counted(*best)) best = std::move(first.unit);
    }
    return known_[f] = std::move(best);
  }

 private:
  Formula event(const char* name) const {
    const auto p = arena_.vocabulary().find(name);
    if (!p) throw std::invalid_argument("programs need the proposition '" + std::string(name) + "'");
    return arena_.atom(*p);
  }

  std::vector<Peeled> peel(Formula f) const {
    std::vector<Peeled> out;
    if (f.op() == Op::Or) {
      if (temporal()) peel_conditions(f, out);
      peel_orient(f, out);
      return out;
    }
    peel_step(f, true_, out);
    if (!temporal()) return out;
    for (const Formula l : operands_of(f, Op::And)) {  // without and keep: l ∧ X…
      if (!is_literal(l) || f.op() != Op::And) continue;
      peel_guarded(l, f, out);
    }
    if (f.op() == Op::Until && f[0] != true_ && is_literal(f[0])) peel_guarded(f[0], f, out);
    return out;
  }

  bool temporal() const { return grammar_.limits().dialect == Dialect::Temporal; }
  bool is_atom(Formula f) const { return f.op() == Op::Atom; }
  bool is_literal(Formula f) const { return is_atom(f) || (f.op() == Op::Not && is_atom(f[0])); }
  static std::uint16_t atom(Formula literal) {
    const Formula a = literal.op() == Op::Not ? literal[0] : literal;
    return static_cast<std::uint16_t>(a.proposition().index);
  }

  // The conjunction without one of its operands; nullopt when it is none of them.
  std::optional<Formula> without(Formula f, Formula part) const {
    std::vector<Formula> parts = operands_of(f, Op::And);
    const auto it = std::find(parts.begin(), parts.end(), part);
    if (it == parts.end()) return std::nullopt;
    parts.erase(it);
    return ltl::conjunction(arena_, parts);
  }

  void peel_guarded(Formula l, Formula f, std::vector<Peeled>& out) const {
    std::vector<Peeled> steps;
    peel_step(f, l, steps);
    const StepKind kind = is_atom(l) ? StepKind::Keep : StepKind::Without;
    for (Peeled& step : steps) {
      step.unit.insert(step.unit.begin(), Step{kind, 0, 1, {atom(l)}});
      out.push_back(std::move(step));
    }
  }

  // Steps S with S(rest) = f and `meanwhile` at every letter before the goal.
  void peel_step(Formula f, Formula meanwhile, std::vector<Peeled>& out) const {
    if (f.op() == Op::Until && f[0] == meanwhile) {
      peel_goal(StepKind::Reach, f[1], out);
      return;
    }
    const auto then = after_next(f, meanwhile);
    if (!then) return;
    peel_forward(f, meanwhile, out);
    if (then->op() == Op::Until) {
      peel_advance(f, meanwhile, 1, {}, out);
      if (const auto g = target(*then, turned_, meanwhile)) peel_goal(StepKind::Face, *g, out);
    }
    if (!without(*then, moved_)) peel_goal(StepKind::Next, *then, out);
  }

  // φ of meanwhile ∧ X φ
  std::optional<Formula> after_next(Formula f, Formula meanwhile) const {
    const auto x = meanwhile == true_ ? f : without(f, meanwhile);
    return x && x->op() == Op::Next ? std::optional((*x)[0]) : std::nullopt;
  }

  // φ of (only ∧ meanwhile) U (only ∧ φ)
  std::optional<Formula> target(Formula f, Formula only, Formula meanwhile) const {
    if (f.op() != Op::Until || f[0] != ltl::conjunction(only, meanwhile)) return std::nullopt;
    return without(f[1], only);
  }

  void peel_forward(Formula f, Formula meanwhile, std::vector<Peeled>& out) const {
    std::vector<Peeled> found;
    for (int k = 1; k <= PostfixGrammar::max_forward; ++k) {
      const auto then = after_next(f, meanwhile);
      const auto rest = then ? without(*then, moved_) : std::nullopt;
      if (!rest) break;
      found.push_back({{{StepKind::Forward, static_cast<std::uint8_t>(k), 0, {}}}, *rest});
      f = *rest;
    }
    out.insert(out.end(), found.rbegin(), found.rend());
  }

  // advance_k with k > `times` first, for the goal of those that went before; then past; then this one.
  void peel_advance(Formula f, Formula meanwhile, int times, const Program& same, std::vector<Peeled>& out) const {
    const auto then = after_next(f, meanwhile);
    const auto g = then ? target(*then, moved_, meanwhile) : std::nullopt;
    if (!g) return;
    std::vector<Peeled> found;
    peel_goal(StepKind::Advance, *g, found);
    for (Peeled& step : found) {
      if (!same.empty() && step.unit != same) continue;
      if (temporal() && times < PostfixGrammar::max_advance)
        peel_advance(step.rest, meanwhile, times + 1, step.unit, out);
      if (temporal() && times == 1) {
        const auto more = after_next(step.rest, meanwhile);
        if (const auto rest = more ? without(*more, moved_) : std::nullopt) {
          out.push_back({step.unit, *rest});
          out.back().unit.front().kind = StepKind::Past;
        }
      }
      if (times > 1) step.unit.front().count = static_cast<std::uint8_t>(times);
      out.push_back(std::move(step));
    }
  }

  // One literal or more of a conjunction as a goal, more first.
  void peel_goal(StepKind kind, Formula f, std::vector<Peeled>& out) const {
    std::vector<Formula> atoms, others;
    for (const Formula part : operands_of(f, Op::And)) (is_atom(part) ? atoms : others).push_back(part);
    std::sort(atoms.begin(), atoms.end(), [](Formula a, Formula b) { return atom(a) < atom(b); });
    const auto with = [&](std::vector<std::size_t> goal) {
      Step step{kind, 0, static_cast<std::uint8_t>(goal.size()), {}};
      std::vector<Formula> rest = others;
      for (std::size_t i = 0; i < atoms.size(); ++i)
        if (std::find(goal.begin(), goal.end(), i) == goal.end()) rest.push_back(atoms[i]);
      for (std::size_t i = 0; i < goal.size(); ++i) {
        step.goal[i] = atom(atoms[goal[i]]);
        if (!grammar_.usable(step.goal[i], kind)) return;
      }
      out.push_back({{step}, ltl::conjunction(arena_, rest)});
    };
    for (std::size_t i = 0; i < atoms.size(); ++i)
      for (std::size_t j = i + 1; j < atoms.size(); ++j) with({i, j});
    for (std::size_t i = 0; i < atoms.size(); ++i) with({i});
  }

  // (l ∧ S(ρ)) ∨ (¬l ∧ ρ), and (l ∧ S₁(ρ)) ∨ (¬l ∧ S₂(ρ))
  void peel_conditions(Formula f, std::vector<Peeled>& out) const {
    if (f.operands().size() != 2) return;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      for (const Formula l : operands_of(f[side], Op::And)) {
        if (!is_atom(l)) continue;
        const auto first = without(f[side], l), second = without(f[1 - side], ltl::negate(l));
        if (!second) continue;
        const Step when{StepKind::When, 0, 1, {atom(l)}}, whether{StepKind::Whether, 0, 1, {atom(l)}};
        const std::vector<Peeled> firsts = steps_of(*first), seconds = steps_of(*second);
        for (const Peeled& a : firsts) {
          if (a.rest == *second) out.push_back({joined({when}, a.unit), a.rest});
          for (const Peeled& b : seconds)
            if (a.rest == b.rest) out.push_back({joined(joined({whether}, a.unit), b.unit), a.rest});
        }
      }
  }

  // Functions take plain steps.
  std::vector<Peeled> steps_of(Formula f) const {
    std::vector<Peeled> out;
    peel_step(f, true_, out);
    return out;
  }

  // ρ ∨ X(turned U (turned ∧ ρ))
  void peel_orient(Formula f, std::vector<Peeled>& out) const {
    const std::vector<Formula> parts = operands_of(f, Op::Or);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto rest = parts[i].op() == Op::Next ? target(parts[i][0], turned_, true_) : std::nullopt;
      if (!rest) continue;
      std::vector<Formula> others = parts;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      if (ltl::disjunction(arena_, others) == *rest) out.push_back({{Step{StepKind::Orient, 0, 0, {}}}, *rest});
    }
  }

  static Program joined(Program a, const Program& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  ltl::Arena& arena_;
  const PostfixGrammar& grammar_;
  Formula true_, moved_, turned_left_, turned_;
  std::unordered_map<Formula, std::optional<Program>> known_;
};

}  // namespace

std::optional<Program> program_of(ltl::Formula formula, const PostfixGrammar& grammar) {
  ltl::Arena& arena = formula.arena();
  auto program = Peeler(arena, grammar).whole(formula);
  if (!program) return std::nullopt;
  if (program->empty()) program->push_back(Step{});
  return grammar.contains(*program) && formula_of(*program, arena) == formula ? program : std::nullopt;
}

}  // namespace waymark::parser
