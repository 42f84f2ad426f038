#include "libautomata/bdd/chained_boolean.hpp"

#include <algorithm>
#include <cassert>

namespace waymark::automata {

ChainedBoolean::Chain ChainedBoolean::add_chain(bool forcing) {
  chains_.push_back({forcing});
  return static_cast<Chain>(chains_.size() - 1);
}

void ChainedBoolean::append(Chain chain, Mtbdd::Variable v) {
  assert(chain_of(v) == none && v >= chains_[chain].last);
  chain_of_.resize(std::max<std::size_t>(chain_of_.size(), v + 1), none);
  chain_of_[v] = chain;
  chains_[chain].last = v;
}

ChainedBoolean::Node ChainedBoolean::chained(Node f, Node g, Node h) {
  if (Mtbdd::is_terminal(f)) return f == constant(true) ? g : h;
  if (g == h) return g;
  if (g == constant(true) && h == constant(false)) return f;
  const ComputedTable::Arguments key{f.id, g.id, h.id};
  if (const std::uint32_t* known = results_.find(choice, key)) return Node{*known};
  const Mtbdd::Variable top = std::min({diagram_.variable(f), diagram_.variable(g), diagram_.variable(h)});
  const Node low = chained(cofactor(f, top, false), cofactor(g, top, false), cofactor(h, top, false));
  const Node high = chained(cofactor(f, top, true), cofactor(g, top, true), cofactor(h, top, true));
  const Node made = make(top, low, high);
  results_.store(choice, key, made.id, diagram_.live());
  return made;
}

// v stands at the root of f, or above it.
ChainedBoolean::Node ChainedBoolean::cofactor(Node f, Mtbdd::Variable v, bool value) {
  if (diagram_.variable(f) == v) return value ? diagram_.high(f) : diagram_.low(f);
  const Chain chain = chain_of(v);
  return chain != none && chains_[chain].forcing == value ? forced(f, chain) : f;
}

ChainedBoolean::Node ChainedBoolean::forced(Node f, Chain chain) {
  const Mtbdd::Variable v = diagram_.variable(f);
  const Links& links = chains_[chain];
  if (Mtbdd::is_terminal(f) || v > links.last) return f;
  if (chain_of(v) == chain) return links.forcing ? diagram_.high(f) : diagram_.low(f);
  const ComputedTable::Arguments key{f.id, chain, 0};
  if (const std::uint32_t* known = results_.find(forced_later, key)) return Node{*known};
  const Node low = forced(diagram_.low(f), chain), high = forced(diagram_.high(f), chain);
  const Node made = make(v, low, high);
  results_.store(forced_later, key, made.id, diagram_.live());
  return made;
}

ChainedBoolean::Node ChainedBoolean::make(Mtbdd::Variable v, Node low, Node high) {
  if (const Chain chain = chain_of(v); chain != none) {
    const bool forcing = chains_[chain].forcing;
    const Node other = forcing ? low : high;
    if (forced(other, chain) == (forcing ? high : low)) return other;
  }
  return diagram_.make(v, low, high);
}

}  // namespace waymark::automata
