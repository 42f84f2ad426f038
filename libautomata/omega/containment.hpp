// φ ⇒ ψ over infinite words, decided by emptiness of the tableau of φ ∧ ¬ψ.
//
// A few sample lassos that satisfy φ and not ψ refute most implications. All samples have four letters, so the truth of
// a formula at every position of all samples is one 64-bit word, computed from the words of its operands.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "libautomata/budget.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

class Containment {
 public:
  // reads: at least the propositions of the formulas to come. The budget is shared by all questions; once it has run
  // out, the answer is no.
  Containment(const std::vector<ltl::Proposition>& reads, Budget& budget);
  bool operator()(ltl::Formula from, ltl::Formula to);

 private:
  static constexpr std::size_t letters = 4, lassos = 16;

  std::uint64_t verdict(ltl::Formula f);  // bit 4·i + j: position j of lasso i
  std::uint64_t compute(ltl::Formula f);
  std::uint64_t next(std::uint64_t bits) const;
  bool prove(ltl::Formula from, ltl::Formula to);

  const std::vector<ltl::Proposition>& reads_;
  Budget& budget_;
  std::array<std::uint8_t, lassos * letters> successor_{};  // of every position
  std::unordered_map<ltl::Formula, std::uint64_t> verdicts_;
  std::unordered_map<std::uint64_t, bool> known_;  // by both ids
  std::optional<Satisfiability> satisfiable_;
  bool spent_ = false;
};

}  // namespace waymark::automata
