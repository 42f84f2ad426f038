#include "libltl/rewriting/implication.hpp"

#include <algorithm>

namespace waymark::ltl {

bool Implication::follows(Formula from, Formula to, std::size_t depth) {
  if (from == to || from.op() == Op::False || to.op() == Op::True) return true;
  if (depth == 0 || (is_literal(from) && is_literal(to))) return false;
  if (steps_ >= most_steps) return false;  // not even what is known, which costs a cache miss for each of many pairs
  if (const bool* known = known_.find(from.id(), to.id())) return *known;
  ++steps_;
  const bool answer = bounds_.implies(from, to) || by_junctions(from, to, depth - 1) ||
                      by_temporal(from, to, depth - 1) || by_expansion(from, to, depth - 1);
  known_.store(from.id(), to.id(), answer);
  return answer;
}

bool Implication::by_junctions(Formula from, Formula to, std::size_t depth) {
  const auto into = [&](Formula g) { return follows(from, g, depth); };
  const auto out_of = [&](Formula g) { return follows(g, to, depth); };
  const auto source = from.operands(), target = to.operands();
  if (to.op() == Op::And) return std::all_of(target.begin(), target.end(), into);
  if (from.op() == Op::Or) return std::all_of(source.begin(), source.end(), out_of);
  if (to.op() == Op::Or && std::any_of(target.begin(), target.end(), into)) return true;
  return from.op() == Op::And && std::any_of(source.begin(), source.end(), out_of);
}

// The same operator on both sides is monotone, or antitone for ¬; and X φ ⇒ N φ.
bool Implication::by_temporal(Formula from, Formula to, std::size_t depth) {
  const bool both_next = (from.op() == Op::Next || from.op() == Op::WeakNext) && to.op() == Op::WeakNext;
  if (both_next || (from.op() == Op::Next && to.op() == Op::Next)) return follows(from[0], to[0], depth);
  if (from.op() == Op::Not && to.op() == Op::Not) return follows(to[0], from[0], depth);
  if (from.op() != to.op() || (from.op() != Op::Until && from.op() != Op::Release)) return false;
  return follows(from[0], to[0], depth) && follows(from[1], to[1], depth);
}

// ψ ⇒ φ U ψ ⇒ φ ∨ ψ, and φ ∧ ψ ⇒ φ R ψ ⇒ ψ; X F ψ ⇒ F ψ, and G ψ ⇒ N G ψ.
bool Implication::by_expansion(Formula from, Formula to, std::size_t depth) {
  if (to.op() == Op::Until && follows(from, to[1], depth)) return true;
  if (from.op() == Op::Release && follows(from[1], to, depth)) return true;
  const bool to_eventually = to.op() == Op::Until && to[0].op() == Op::True;
  if (to_eventually && from.op() == Op::Next && follows(from[0], to, depth)) return true;
  const bool from_always = from.op() == Op::Release && from[0].op() == Op::False;
  if (from_always && to.op() == Op::WeakNext && follows(from, to[0], depth)) return true;
  if (to.op() == Op::Release && follows(from, to[0], depth) && follows(from, to[1], depth)) return true;
  return from.op() == Op::Until && follows(from[0], to, depth) && follows(from[1], to, depth);
}

}  // namespace waymark::ltl
