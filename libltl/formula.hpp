// LTL formulas as immutable, shared nodes.
//
// A Formula is one pointer. Within an Arena, equal structure means equal pointer, so == and hashing are O(1) and a
// formula can be the state of an automaton. Constructors apply propositional identities only (φ ∧ φ = φ, φ ∧ ¬φ =
// false, ¬¬φ = φ, units, flattening). These hold on finite and infinite words and for both next operators. simplify.hpp
// rewrites temporal operators under a given semantics.
//
// Thirteen operators are stored. The others are replaced by definitions that the printer recognises:
//   F φ = true U φ    G φ = false R φ    φ W ψ = ψ R (φ ∨ ψ)    φ M ψ = ψ U (φ ∧ ψ)    φ → ψ = ¬φ ∨ ψ
//   O φ = true S φ    H φ = ¬O ¬φ        Z φ = ¬Y ¬φ            φ T ψ = ¬(¬φ S ¬ψ)
// Grammar, both semantics: docs/conventions.md. Sources: [BK08, Def. 5.1], [DV13, Sec. 2], past: [LPZ85, Sec. 2].
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "libltl/vocabulary.hpp"

namespace waymark::ltl {

class Arena;
// The operators that are stored.
enum class Op : std::uint8_t { False, True, Atom, Not, And, Or, Iff, Next, WeakNext, Until, Release, Yesterday, Since };

class Formula {  // a value: copy it, compare it, put it in a map. Valid as long as its arena.
 public:
  Op op() const;                              // the outermost operator
  std::span<const Formula> operands() const;  // sorted by id and unique under And, Or; sorted under Iff
  Formula operator[](std::size_t i) const;    // operand i, unchecked
  Proposition proposition() const;            // of an Atom
  Arena& arena() const;                       // where the formula lives
  std::uint32_t id() const;                   // position in the arena: operands have smaller ids
  friend bool operator==(Formula, Formula) = default;
  friend bool operator<(Formula a, Formula b) { return a.id() < b.id(); }  // creation order, for canonical output

 private:
  struct Node;
  friend class Arena;
  friend struct std::hash<Formula>;
  explicit Formula(const Node* node) : node_(node) {}
  const Node* node_;
};

struct Formula::Node {
  Op op;
  std::uint32_t id;
  Proposition proposition;
  std::uint32_t arity;
  std::size_t hash;
  Arena* arena;
  const Formula* operands;
};

inline Op Formula::op() const { return node_->op; }
inline std::span<const Formula> Formula::operands() const { return {node_->operands, node_->arity}; }
inline Formula Formula::operator[](std::size_t i) const { return node_->operands[i]; }
inline Proposition Formula::proposition() const { return node_->proposition; }
inline Arena& Formula::arena() const { return *node_->arena; }
inline std::uint32_t Formula::id() const { return node_->id; }

// Owns formulas over one vocabulary. Not for two threads at once; any number of arenas on any number of threads.
class Arena {
 public:
  explicit Arena(Vocabulary vocabulary = {});
  ~Arena();
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  const Vocabulary& vocabulary() const { return vocabulary_; }  // the propositions of the formulas
  Proposition add_proposition(std::string_view name) { return vocabulary_.add(name); }  // found or added

  Formula constant(bool value);             // true or false
  Formula atom(Proposition p);              // throws std::out_of_range when p is not of this vocabulary
  Formula atom(std::string_view name);      // adds the proposition when it is new
  std::size_t size() const;                 // formulas made so far
  Formula formula(std::uint32_t id) const;  // the formula of that id, id < size()

 private:
  friend Formula negate(Formula);
  friend Formula conjunction(Arena&, std::span<const Formula>);
  friend Formula disjunction(Arena&, std::span<const Formula>);
  friend Formula iff(Formula, Formula);
  friend Formula next(Formula);
  friend Formula weak_next(Formula);
  friend Formula until(Formula, Formula);
  friend Formula release(Formula, Formula);
  friend Formula yesterday(Formula);
  friend Formula since(Formula, Formula);
  Formula make(Op op, std::span<const Formula> operands, Proposition p = {});
  Formula junction(Op op, std::span<const Formula> operands);
  void grow();

  struct Store;
  Vocabulary vocabulary_;
  std::unique_ptr<Store> store_;
};

// All operands of one call come from one arena (asserted). Cost: O(operands), O(n log n) for conjunction and
// disjunction.
Formula negate(Formula f);                                             // ¬φ, with ¬¬φ = φ and constants folded
Formula conjunction(Arena& arena, std::span<const Formula> operands);  // ∧; true when empty
Formula disjunction(Arena& arena, std::span<const Formula> operands);  // ∨; false when empty
Formula conjunction(Formula a, Formula b);
Formula disjunction(Formula a, Formula b);
Formula implies(Formula a, Formula b);         // ¬φ ∨ ψ
Formula iff(Formula a, Formula b);             // φ ↔ ψ; negations are pulled out: ¬φ ↔ ψ is ¬(φ ↔ ψ)
Formula exclusive_or(Formula a, Formula b);    // ¬(φ ↔ ψ)
Formula next(Formula f);                       // X φ: there is a next letter, and φ holds there
Formula weak_next(Formula f);                  // N φ: if there is a next letter, φ holds there
Formula until(Formula left, Formula right);    // φ U ψ
Formula release(Formula left, Formula right);  // φ R ψ
Formula eventually(Formula f);                 // F φ  is stored as  true U φ
Formula always(Formula f);                     // G φ  is stored as  false R φ
inline bool is_eventually(Formula f) { return f.op() == Op::Until && f[0].op() == Op::True; }
inline bool is_always(Formula f) { return f.op() == Op::Release && f[0].op() == Op::False; }
Formula weak_until(Formula left, Formula right);      // φ W ψ  is stored as  ψ R (φ ∨ ψ)
Formula strong_release(Formula left, Formula right);  // φ M ψ  is stored as  ψ U (φ ∧ ψ)
Formula eventually_within(std::size_t k, Formula f);  // F<=k φ = φ ∨ X(φ ∨ X(…)), k strong nexts
Formula always_within(std::size_t k, Formula f);      // G<=k φ = φ ∧ N(φ ∧ N(…)), k weak nexts
// Past, which is finite and begins at the first letter: Y false, φ S false and Z true fold, as do false S φ, φ S true.
Formula yesterday(Formula f);                    // Y φ: there is a letter before, and φ holds there
Formula since(Formula left, Formula right);      // φ S ψ: ψ held, now or before, and φ ever after that
Formula weak_yesterday(Formula f);               // Z φ: if there is a letter before, φ holds there
Formula once(Formula f);                         // O φ: φ holds now or held before
Formula historically(Formula f);                 // H φ: φ holds now and always held before
Formula triggered(Formula left, Formula right);  // φ T ψ, the dual of S
inline bool is_past(Op op) { return op == Op::Yesterday || op == Op::Since; }

// The same formula in another arena, whose vocabulary gains the names it lacks. O(DAG).
Formula transfer(Formula f, Arena& to);

// Every distinct subformula once, operands before operators, f last. O(DAG).
std::vector<Formula> subformulas(Formula f);
bool has_past(Formula f);  // does a past operator occur? O(DAG)
// The propositions that occur, ascending. O(DAG).
std::vector<Proposition> propositions(Formula f);
// Nodes of the syntax tree (not of the DAG), saturating at SIZE_MAX. O(DAG).
std::size_t tree_size(Formula f);

}  // namespace waymark::ltl

template <>
struct std::hash<waymark::ltl::Formula> {
  std::size_t operator()(waymark::ltl::Formula f) const noexcept {
    return std::hash<const void*>{}(f.node_) * 0x9E3779B97F4A7C15ULL >> 3U;
  }
};
