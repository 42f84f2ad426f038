#include "libautomata/finite/residual.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_set>

namespace waymark::automata {
namespace {

constexpr std::size_t few_letters = 1U << 14U;  // nodes that are not worth collecting

using ltl::Formula;
using ltl::Op;

// The operator that a temporal operator distributes over in its right operand, φ U (ψ₁ ∨ ψ₂) = φ U ψ₁ ∨ φ U ψ₂ and
// dually: the parts have small diagrams where the whole may have a huge one.
bool is_split(Formula g) {
  return (g.op() == Op::Until && g[1].op() == Op::Or) || (g.op() == Op::Release && g[1].op() == Op::And);
}

// Subformulas whose diagrams are asked for, operands before operators: all but the operands that are split.
std::vector<Formula> needed(Formula f) {
  std::vector<Formula> all = ltl::subformulas(f), out;
  std::unordered_set<Formula> asked{f};
  for (std::size_t i = all.size(); i-- > 0;) {
    const Formula g = all[i];
    if (!asked.contains(g)) continue;
    out.push_back(g);
    const std::size_t whole = is_split(g) ? 1 : g.operands().size();
    for (std::size_t j = 0; j < whole; ++j) asked.insert(g[j]);
    if (is_split(g)) asked.insert(g[1].operands().begin(), g[1].operands().end());
  }
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace

Residuals::Residuals(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget)
    : reads_(reads), logic_(residuals_), ite_(letters_.operation()), budget_(budget) {
  payload(ChainedBoolean::constant(false), false);  // trap
  payload(ChainedBoolean::constant(true), true);    // anything
  initial_ = payload(residual_of(f, reads), false);
  listed_.resize(leaves_.size(), false);
  listed_[initial_] = true;
}

Residuals::Node Residuals::successors(std::uint32_t payload) {
  if (letters_.live() > 4 * kept_ + few_letters) collect();
  return progress(leaves_[payload].residual);
}

void Residuals::collect() {
  std::vector<Node> roots = elementary_successors_;
  for (const auto& [residual, successors] : progressed_) roots.push_back(successors);
  letters_.collect(roots);
  kept_ = letters_.live();
  walked_.assign(walked_.size(), false);  // ids are used again
}

std::vector<std::uint32_t> Residuals::fresh_leaves(Node successors) {
  walked_.resize(letters_.size(), false);
  listed_.resize(leaves_.size(), false);
  std::vector<std::uint32_t> out;
  std::vector<Node> stack{successors};
  while (!stack.empty()) {
    const Node n = stack.back();
    stack.pop_back();
    const bool terminal = Mtbdd::is_terminal(n);
    std::vector<bool>::reference known = terminal ? listed_[Mtbdd::payload(n)] : walked_[n.id];
    if (known) continue;
    known = true;
    if (terminal) {
      out.push_back(Mtbdd::payload(n));
    } else {
      stack.push_back(letters_.high(n));
      stack.push_back(letters_.low(n));
    }
  }
  return out;
}

Residuals::Node Residuals::residual_of(ltl::Formula f, const std::vector<ltl::Proposition>& reads) {
  std::unordered_map<Formula, Node> image;
  const auto combine = [&](Formula g, bool unit, auto operation) {
    Node all = ChainedBoolean::constant(unit);
    for (std::size_t i = g.operands().size(); i-- > 0;) all = operation(image.at(g[i]), all);
    return all;
  };
  const auto split = [&](Formula g, auto operation) {  // over the parts of the right operand
    if (!is_split(g)) return operation(g[1]);
    const bool release = g.op() == Op::Release;
    Node all = ChainedBoolean::constant(release);
    for (std::size_t i = g[1].operands().size(); i-- > 0;) {
      const Node part = operation(g[1][i]);
      all = release ? logic_.conjunction(part, all) : logic_.disjunction(part, all);
    }
    return all;
  };
  const auto spell = [&](Formula g) {
    switch (g.op()) {
      case Op::False: return ChainedBoolean::constant(false);
      case Op::True: return ChainedBoolean::constant(true);
      case Op::Atom: {
        const auto at = std::lower_bound(reads.begin(), reads.end(), g.proposition());
        return elementary(Kind::Proposition, {}, Mtbdd::terminal(static_cast<std::uint32_t>(at - reads.begin())));
      }
      case Op::Not: return logic_.negate(image.at(g[0]));
      case Op::And: return combine(g, true, [&](Node a, Node b) { return logic_.conjunction(a, b); });
      case Op::Or: return combine(g, false, [&](Node a, Node b) { return logic_.disjunction(a, b); });
      case Op::Iff: return logic_.iff(image.at(g[0]), image.at(g[1]));
      case Op::Next: return next(image.at(g[0]), chain_of(g, image));
      case Op::WeakNext: return logic_.negate(next(logic_.negate(image.at(g[0])), chain_of(g, image)));
      case Op::Until: return split(g, [&](Formula h) { return until(image.at(g[0]), image.at(h)); });
      case Op::Release:
        return split(g, [&](Formula h) {
          const Node not_h = logic_.negate(image.at(h));
          return logic_.negate(until(logic_.negate(image.at(g[0])), not_h));
        });
      case Op::Yesterday:
      case Op::Since: break;  // without_past comes first
    }
    throw std::logic_error("operator without a residual");
  };
  for (Formula g : needed(f)) image.emplace(g, spell(g));
  return image.at(f);
}

Residuals::Node Residuals::elementary(Kind kind, Node left, Node right) {
  if (elementary_.size() >= Mtbdd::max_variables) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
  const auto e = static_cast<Mtbdd::Variable>(elementary_.size());
  elementary_.push_back({kind, left, right});
  const Node self = logic_.variable(e);
  elementary_successors_.push_back(progress_elementary(elementary_.back(), self));
  return self;
}

Residuals::Node Residuals::next(Node operand, std::optional<ChainedBoolean::Chain> chain) {
  if (operand == ChainedBoolean::constant(false)) return operand;  // X false = false
  const auto known = next_.find(operand.id);
  if (known != next_.end()) return logic_.variable(known->second);
  const auto made = static_cast<Mtbdd::Variable>(elementary_.size());
  next_.emplace(operand.id, made);
  if (chain) logic_.append(*chain, made);
  return elementary(Kind::Next, {}, operand);
}

// The chain of X F<=k φ, or of N G<=k φ, and so on, that the variable of this formula continues, if it is not there
// yet. A variable stands for X ψ or, where the formula is N ψ, for X ¬ψ.
std::optional<ChainedBoolean::Chain> Residuals::chain_of(Formula next, const std::unordered_map<Formula, Node>& image) {
  const std::optional<ltl::Bound> bound = bounds_.of(next[0]);
  if (!bound) return std::nullopt;
  std::vector<BoundedNexts>& some = bounded_nexts_[bound->body.id()];
  for (BoundedNexts& b : some) {
    if (b.next != next.op() || !b.first.is_of(*bound)) continue;
    if (bound->steps <= b.steps) return std::nullopt;
    b.steps = bound->steps;
    return b.chain;
  }
  // With X, F<=1 φ ⇒ F<=2 φ: a true variable makes the later ones true. The dual, and what is negated, the other way.
  const bool forcing = (bound->junction == Op::Or) == (next.op() == Op::Next);
  some.push_back({next.op(), *bound, bound->steps, logic_.add_chain(forcing)});
  if (const auto body = image.find(bound->body); body != image.end()) {  // F<=0 φ is φ
    const Node operand = next.op() == Op::Next ? body->second : logic_.negate(body->second);
    const auto known = next_.find(operand.id);
    if (known != next_.end()) logic_.append(some.back().chain, known->second);
  }
  return some.back().chain;
}

Residuals::Node Residuals::until(Node left, Node right) {
  if (logic_.implies(left, right)) return right;  // false U ψ = ψ U ψ = ψ, φ U true = true
  left = logic_.disjunction(left, right);         // φ U ψ = (φ ∨ ψ) U ψ: one spelling
  const std::uint64_t key = std::uint64_t{left.id} << 32U | right.id;
  const auto known = until_.find(key);
  if (known != until_.end()) return logic_.variable(known->second);
  until_.emplace(key, static_cast<Mtbdd::Variable>(elementary_.size()));
  return elementary(Kind::Until, left, right);
}

Residuals::Node Residuals::progress_elementary(const Elementary& e, Node self) {
  switch (e.kind) {
    case Kind::Proposition:
      return letters_.make(Mtbdd::payload(e.right), Mtbdd::terminal(trap), Mtbdd::terminal(anything));
    case Kind::Next: return Mtbdd::terminal(payload(e.right, false));
    case Kind::Until: {
      const Node later = Mtbdd::terminal(payload(self, false));
      const Node on = if_then_else(progress(e.left), later, Mtbdd::terminal(trap));
      return if_then_else(progress(e.right), Mtbdd::terminal(anything), on);
    }
  }
  throw std::logic_error("elementary formula without successors");
}

// Shannon's expansion over elementary formulas: δ(if e then g else h) = if δ(e) then δ(g) else δ(h).
Residuals::Node Residuals::progress(Node residual) {
  if (Mtbdd::is_terminal(residual))
    return Mtbdd::terminal(residual == ChainedBoolean::constant(true) ? anything : trap);
  const auto known = progressed_.find(residual.id);
  if (known != progressed_.end()) return known->second;
  const Node high = progress(residuals_.high(residual));
  const Node low = progress(residuals_.low(residual));
  const Node all = if_then_else(elementary_successors_[residuals_.variable(residual)], high, low);
  progressed_.emplace(residual.id, all);
  return all;
}

Residuals::Node Residuals::if_then_else(Node f, Node g, Node h) {
  const auto decide = [&](const std::array<Node, 3>& a) -> std::optional<Node> {
    budget_.step();
    if (a[0] == Mtbdd::terminal(anything)) return a[1];
    if (a[0] == Mtbdd::terminal(trap)) return a[2];
    if (a[1] == a[2]) return a[1];
    if (a[1] == Mtbdd::terminal(anything) && a[2] == Mtbdd::terminal(trap)) return a[0];
    for (Node n : a)
      if (!Mtbdd::is_terminal(n)) return std::nullopt;
    return Mtbdd::terminal(choose(Mtbdd::payload(a[0]), Mtbdd::payload(a[1]), Mtbdd::payload(a[2])));
  };
  return letters_.apply(ite_, std::array{f, g, h}, decide);
}

std::uint32_t Residuals::choose(std::uint32_t f, std::uint32_t g, std::uint32_t h) {
  const Leaf a = leaves_[f], b = leaves_[g], c = leaves_[h];
  const std::size_t nodes = residuals_.size();
  const Node residual = logic_.if_then_else(a.residual, b.residual, c.residual);
  budget_.step(residuals_.size() - nodes);  // where residuals are large, most of the work is here
  return payload(residual, a.may_stop ? b.may_stop : c.may_stop);
}

// Shannon's expansion where the function is not monotone in the elementary formula, a shorter form where it is.
ltl::Formula Residuals::formula(Node residual, ltl::Arena& arena) {
  if (Mtbdd::is_terminal(residual)) return arena.constant(residual == ChainedBoolean::constant(true));
  if (const auto known = spelled_.find(residual.id); known != spelled_.end()) return known->second;
  const Node low = residuals_.low(residual), high = residuals_.high(residual);
  const Formula e = spelled(elementary_[residuals_.variable(residual)], arena);
  const Formula on_low = formula(low, arena), on_high = formula(high, arena);
  const Formula with = logic_.implies(high, low) ? on_high : ltl::conjunction(e, on_high);
  const Formula without = logic_.implies(low, high) ? on_low : ltl::conjunction(ltl::negate(e), on_low);
  return spelled_.emplace(residual.id, ltl::disjunction(with, without)).first->second;
}

ltl::Formula Residuals::spelled(const Elementary& e, ltl::Arena& arena) {
  switch (e.kind) {
    case Kind::Proposition: return arena.atom(reads_[Mtbdd::payload(e.right)]);
    case Kind::Next: return ltl::next(formula(e.right, arena));
    case Kind::Until: {
      const Formula left = formula(e.left, arena), right = formula(e.right, arena);
      return ltl::until(left, right);
    }
  }
  throw std::logic_error("elementary formula without a spelling");
}

std::uint32_t Residuals::payload(Node residual, bool may_stop) {
  const std::uint64_t key = std::uint64_t{residual.id} << 1U | (may_stop ? 1U : 0U);
  const auto [at, fresh] = payload_of_.try_emplace(key, static_cast<std::uint32_t>(leaves_.size()));
  if (fresh) {
    leaves_.push_back({residual, may_stop});
    budget_.state();
  }
  return at->second;
}

Transitions close(Residuals& residuals, ltl::Semantics words, std::vector<std::uint32_t>& order, Budget& budget) {
  const bool finite = words == ltl::Semantics::Finite;
  std::unordered_map<std::uint32_t, std::uint32_t> state;  // of a leaf, or of its residual
  const auto state_of = [&](std::uint32_t leaf) {
    const std::uint32_t key = finite ? leaf : residuals.leaf(leaf).residual.id;
    const auto [at, fresh] = state.try_emplace(key, static_cast<std::uint32_t>(order.size()));
    if (fresh) order.push_back(leaf);
    return at->second;
  };
  state_of(residuals.initial());
  std::vector<Mtbdd::Node> roots;
  for (std::size_t i = 0; i < order.size(); ++i) {  // the order doubles as the queue
    budget.step();
    roots.push_back(residuals.successors(order[i]));
    for (const std::uint32_t leaf : residuals.fresh_leaves(roots.back())) state_of(leaf);
  }
  Transitions out;
  out.roots = out.diagram.import(
      residuals.diagram(), roots, [&](std::uint32_t leaf) { return Mtbdd::terminal(state_of(leaf)); },
      [](Mtbdd::Variable v) { return v; }, finite ? Mtbdd::Images::StayApart : Mtbdd::Images::MayMeet);
  for (const std::uint32_t leaf : order) out.accepting.push_back(finite && residuals.leaf(leaf).may_stop);
  return out;
}

}  // namespace waymark::automata
