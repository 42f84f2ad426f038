#include "libltl/formula.hpp"

#include <algorithm>
#include <cassert>
#include <memory_resource>

namespace waymark::ltl {

// Nodes and operand lists live in one growing buffer; the unique table is open-addressed over node pointers.
struct Arena::Store {
  std::pmr::monotonic_buffer_resource memory{1024};
  std::vector<const Formula::Node*> nodes;                                                   // by id
  std::vector<const Formula::Node*> table = std::vector<const Formula::Node*>(64, nullptr);  // a power of two
};

Arena::Arena(Vocabulary vocabulary) : vocabulary_(std::move(vocabulary)), store_(std::make_unique<Store>()) {}
Arena::~Arena() = default;

std::size_t Arena::size() const { return store_->nodes.size(); }
Formula Arena::formula(std::uint32_t id) const { return Formula(store_->nodes.at(id)); }

void Arena::grow() {
  std::vector<const Formula::Node*> table(2 * store_->table.size(), nullptr);
  for (const Formula::Node* node : store_->nodes) {
    std::size_t slot = node->hash & (table.size() - 1);
    while (table[slot] != nullptr) slot = (slot + 1) & (table.size() - 1);
    table[slot] = node;
  }
  store_->table = std::move(table);
}

Formula Arena::make(Op op, std::span<const Formula> operands, Proposition p) {
  std::size_t hash = static_cast<std::size_t>(op) * 0x9E3779B97F4A7C15ULL + p.index;
  for (Formula f : operands) {
    assert(&f.arena() == this);
    hash = (hash ^ (hash >> 29U)) * 0xBF58476D1CE4E5B9ULL + f.id();
  }
  hash = (hash ^ (hash >> 32U)) * 0x94D049BB133111EBULL;
  hash ^= hash >> 31U;

  auto& table = store_->table;
  std::size_t slot = hash & (table.size() - 1);
  for (; table[slot] != nullptr; slot = (slot + 1) & (table.size() - 1)) {
    const Formula::Node& node = *table[slot];
    if (node.hash == hash && node.op == op && node.proposition == p &&
        std::equal(operands.begin(), operands.end(), node.operands, node.operands + node.arity))
      return Formula(&node);
  }
  Formula* stored = nullptr;
  if (!operands.empty()) {
    stored = static_cast<Formula*>(store_->memory.allocate(operands.size_bytes(), alignof(Formula)));
    std::uninitialized_copy(operands.begin(), operands.end(), stored);
  }
  void* const place = store_->memory.allocate(sizeof(Formula::Node), alignof(Formula::Node));
  const auto id = static_cast<std::uint32_t>(store_->nodes.size());
  const auto* node =
      new (place) Formula::Node{op, id, p, static_cast<std::uint32_t>(operands.size()), hash, this, stored};
  table[slot] = node;
  store_->nodes.push_back(node);
  if (2 * store_->nodes.size() > table.size()) grow();
  return Formula(node);
}

Formula Arena::constant(bool value) { return make(value ? Op::True : Op::False, {}); }

Formula Arena::atom(Proposition p) {
  static_cast<void>(vocabulary_.name(p));  // throws when p is unknown
  return make(Op::Atom, {}, p);
}

Formula Arena::atom(std::string_view name) { return atom(vocabulary_.add(name)); }

Formula negate(Formula f) {
  switch (f.op()) {
    case Op::False: return f.arena().constant(true);
    case Op::True: return f.arena().constant(false);
    case Op::Not: return f[0];
    case Op::Atom:
    case Op::And:
    case Op::Or:
    case Op::Iff:
    case Op::Next:
    case Op::WeakNext:
    case Op::Until:
    case Op::Release:
    case Op::Yesterday:
    case Op::Since: break;
  }
  return f.arena().make(Op::Not, {&f, 1});
}

// And and Or in one: flatten, drop units, sort, unique; the absorbing constant when it or a pair φ, ¬φ occurs.
Formula Arena::junction(Op op, std::span<const Formula> operands) {
  const Op absorbing = op == Op::And ? Op::False : Op::True;
  const Op unit = op == Op::And ? Op::True : Op::False;
  std::vector<Formula> flat;
  flat.reserve(operands.size());
  for (Formula f : operands) {
    if (f.op() == absorbing) return f;
    if (f.op() == unit) continue;
    if (f.op() == op)
      flat.insert(flat.end(), f.operands().begin(), f.operands().end());
    else
      flat.push_back(f);
  }
  std::sort(flat.begin(), flat.end());
  flat.erase(std::unique(flat.begin(), flat.end()), flat.end());
  for (Formula f : flat)
    if (f.op() == Op::Not && std::binary_search(flat.begin(), flat.end(), f[0])) return constant(op == Op::Or);
  if (flat.empty()) return constant(op == Op::And);
  if (flat.size() == 1) return flat.front();
  return make(op, flat);
}

Formula conjunction(Arena& arena, std::span<const Formula> operands) { return arena.junction(Op::And, operands); }
Formula disjunction(Arena& arena, std::span<const Formula> operands) { return arena.junction(Op::Or, operands); }

Formula conjunction(Formula a, Formula b) {
  const Formula both[] = {a, b};
  return conjunction(a.arena(), both);
}

Formula disjunction(Formula a, Formula b) {
  const Formula both[] = {a, b};
  return disjunction(a.arena(), both);
}

Formula implies(Formula a, Formula b) { return disjunction(negate(a), b); }

Formula iff(Formula a, Formula b) {
  if (a == b) return a.arena().constant(true);
  if (a == negate(b)) return a.arena().constant(false);
  bool negated = false;
  Formula sides[] = {a, b};
  for (Formula& side : sides) {
    if (side.op() == Op::Not) {
      side = side[0];
      negated = !negated;
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const Formula other = sides[1 - i];
    if (sides[i].op() == Op::True) return negated ? negate(other) : other;
    if (sides[i].op() == Op::False) return negated ? other : negate(other);
  }
  if (sides[1] < sides[0]) std::swap(sides[0], sides[1]);
  const Formula f = a.arena().make(Op::Iff, sides);
  return negated ? negate(f) : f;
}

Formula exclusive_or(Formula a, Formula b) { return negate(iff(a, b)); }
Formula next(Formula f) { return f.arena().make(Op::Next, {&f, 1}); }
Formula weak_next(Formula f) { return f.arena().make(Op::WeakNext, {&f, 1}); }

Formula until(Formula left, Formula right) {
  const Formula sides[] = {left, right};
  return left.arena().make(Op::Until, sides);
}

Formula release(Formula left, Formula right) {
  const Formula sides[] = {left, right};
  return left.arena().make(Op::Release, sides);
}

Formula eventually(Formula f) { return until(f.arena().constant(true), f); }
Formula always(Formula f) { return release(f.arena().constant(false), f); }
Formula weak_until(Formula left, Formula right) { return release(right, disjunction(left, right)); }
Formula strong_release(Formula left, Formula right) { return until(right, conjunction(left, right)); }

Formula eventually_within(std::size_t k, Formula f) {
  Formula out = f;
  for (std::size_t i = 0; i < k; ++i) out = disjunction(f, next(out));
  return out;
}

Formula always_within(std::size_t k, Formula f) {
  Formula out = f;
  for (std::size_t i = 0; i < k; ++i) out = conjunction(f, weak_next(out));
  return out;
}

Formula yesterday(Formula f) { return f.op() == Op::False ? f : f.arena().make(Op::Yesterday, {&f, 1}); }

Formula since(Formula left, Formula right) {
  if (left.op() == Op::False || right.op() == Op::False || right.op() == Op::True) return right;
  const Formula sides[] = {left, right};
  return left.arena().make(Op::Since, sides);
}

Formula weak_yesterday(Formula f) { return negate(yesterday(negate(f))); }
Formula once(Formula f) { return since(f.arena().constant(true), f); }
Formula historically(Formula f) { return negate(once(negate(f))); }
Formula triggered(Formula left, Formula right) {
  const Formula not_right = negate(right);
  return negate(since(negate(left), not_right));
}

}  // namespace waymark::ltl
