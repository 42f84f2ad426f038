// Acceptance of infinite runs: a positive Boolean combination of Inf(i) and Fin(i), mark i infinitely or finitely
// often.
//
// This is the `Acceptance:` line of HOA [BBD+15]. Every named condition is an instance: Büchi Inf(0), generalised Büchi
// Inf(0)&…&Inf(n−1), co-Büchi Fin(0), Rabin, Streett, parity. Marks are on edges.
#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace waymark::automata {

// A set of acceptance marks.
class Marks {
 public:
  static constexpr std::uint32_t most = 64;  // marks are 0 … 63
  constexpr Marks() = default;
  static constexpr Marks of(std::uint32_t mark) { return Marks(std::uint64_t{1} << mark); }  // {mark}
  static constexpr Marks first(std::uint32_t n) {                                            // 0 … n − 1
    return Marks(n >= most ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1);
  }
  static constexpr Marks from_bits(std::uint64_t bits) { return Marks(bits); }  // bit i is mark i
  constexpr std::uint64_t bits() const { return bits_; }                        // bit i is mark i
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::uint32_t count() const { return static_cast<std::uint32_t>(std::popcount(bits_)); }  // how many
  constexpr bool contains(std::uint32_t mark) const { return ((bits_ >> mark) & 1U) != 0; }           // mark ∈ this
  constexpr bool includes(Marks other) const { return (other.bits_ & ~bits_) == 0; }                  // other ⊆ this
  constexpr Marks without(Marks other) const { return Marks(bits_ & ~other.bits_); }                  // this ∖ other
  std::vector<std::uint32_t> members() const;                                                         // ascending
  friend constexpr Marks operator|(Marks a, Marks b) { return Marks(a.bits_ | b.bits_); }
  friend constexpr Marks operator&(Marks a, Marks b) { return Marks(a.bits_ & b.bits_); }
  friend constexpr auto operator<=>(Marks, Marks) = default;

 private:
  explicit constexpr Marks(std::uint64_t bits) : bits_(bits) {}
  std::uint64_t bits_ = 0;
};

class Condition {  // a value; operands of ∧ and ∨ stay in the order in which they were given
 public:
  enum class Op : std::uint8_t { True, False, Inf, Fin, And, Or };  // the forms of a condition

  // The forms of a condition.
  static Condition constant(bool value);
  static Condition inf(std::uint32_t mark);
  static Condition fin(std::uint32_t mark);
  // Units dropped, the absorbing constant and single operands returned, nested ones of the same kind flattened.
  static Condition all_of(std::vector<Condition> operands);
  static Condition any_of(std::vector<Condition> operands);

  Op op() const { return op_; }                                         // the outermost form
  std::uint32_t mark() const { return mark_; }                          // of Inf and Fin
  const std::vector<Condition>& operands() const { return operands_; }  // of And and Or

  bool holds(Marks infinitely_often) const;  // of a run with these marks infinitely often
  Marks marks() const;                       // that occur
  Marks fin_marks() const;                   // that occur under Fin
  Condition negated() const;                 // Inf and Fin, ∧ and ∨ exchanged
  Condition replaced(std::uint32_t mark,
                     bool seen) const;              // where the mark is seen infinitely often, or is not
  Condition without_fin(std::uint32_t mark) const;  // Fin(mark) is false, Inf(mark) stays
  Condition shifted(std::uint32_t by) const;        // every mark i becomes i + by
  friend bool operator==(const Condition&, const Condition&) = default;

 private:
  static Condition junction(Op op, std::vector<Condition> operands);
  template <class Leaf>
  Condition mapped(const Leaf& leaf, bool exchange) const;

  Op op_ = Op::True;
  std::uint32_t mark_ = 0;
  std::vector<Condition> operands_;
};

struct Acceptance {
  std::uint32_t sets = 0;  // marks are 0 … sets − 1, at most Marks::most
  Condition condition;     // over these marks

  // The named conditions of HOA.
  static Acceptance all() { return {}; }
  static Acceptance none() { return {0, Condition::constant(false)}; }
  static Acceptance buchi() { return generalized_buchi(1); }
  static Acceptance co_buchi() { return {1, Condition::fin(0)}; }
  static Acceptance generalized_buchi(std::uint32_t n);  // Inf(0)&…&Inf(n−1); 0: all
  static Acceptance rabin(std::uint32_t pairs);          // (Fin(0)&Inf(1)) | (Fin(2)&Inf(3)) | …
  static Acceptance streett(std::uint32_t pairs);        // (Fin(0)|Inf(1)) & …
  enum class Extreme : std::uint8_t { Min, Max };        // which colour decides
  enum class Parity : std::uint8_t { Even, Odd };        // which colours accept
  static Acceptance parity(Extreme extreme, Parity parity, std::uint32_t colours);  // as HOA spells it

  // Recognised by shape, as HOA spells them.
  bool is_generalized_buchi() const;  // `all` and `buchi` included
  bool is_buchi() const { return *this == buchi(); }
  bool is_all() const { return sets == 0 && condition.op() == Condition::Op::True; }
  // The line `acc-name:` without its name, where there is one: "Buchi", "parity max odd 3".
  std::optional<std::string> name() const;
  friend bool operator==(const Acceptance&, const Acceptance&) = default;
};

// In HOA's syntax: "Inf(0) & (Fin(1) | Inf(2))", "t", "f".
std::string print(const Condition& condition);

}  // namespace waymark::automata
