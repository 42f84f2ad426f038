// Programs: one to a few steps joined by `then`, the fragment of LTL that route instructions are grounded in.
//
//   step           formula with rest ρ (true after the last step)          g: a conjunction of literals
//   stay           ρ                                                       nothing to do
//   orient         ρ ∨ X(turned U (turned ∧ ρ))                            turn somehow, so that the rest can be done
//   forward k      X(moved ∧ X(moved ∧ … ∧ ρ))                             k moves
//   reach g        F(g ∧ ρ)
//   next g         X(g ∧ ρ)
//   advance g      X(moved U (moved ∧ g ∧ ρ))                              only moves until g
//   advance_k g    the same nested k times: the k-th g straight on
//   face g         X(turned U (turned ∧ g ∧ ρ))                            only turns until g
//   past g         X(moved U (moved ∧ g ∧ X(moved ∧ ρ)))                   only moves until g, and one more
// Functions of steps apply to the one or two steps after them, S(ρ):
//   when l         (l ∧ S(ρ)) ∨ (¬l ∧ ρ)
//   whether l      (l ∧ S₁(ρ)) ∨ (¬l ∧ S₂(ρ))
//   without l      S(ρ), and ¬l at every letter before the one where its goal holds: ¬l U (g ∧ ρ) of `reach g`
//   keep l         S(ρ), and l at these letters: l U (g ∧ ρ) of `reach g`
// with turned = turned_left ∨ turned_right. `then` nests: the rest is owed at the point where the step's goal holds.
// `orient` is ours: in the corpus the heading at the start of a paragraph is unknown, and the turn away from it is
// described by no word. The macros of docs/conventions.md 10 are these lines.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::parser {

enum class StepKind : std::uint8_t {
  Stay,
  Orient,
  Forward,
  Reach,
  Next,
  Advance,
  Face,
  Past,
  Without,
  Keep,
  When,
  Whether
};

struct Step {                                   // one step
  static constexpr std::size_t max_goals = 3;   // literals of one goal
  StepKind kind = StepKind::Stay;               // of the step
  std::uint8_t count = 0;                       // moves of Forward; k of advance_k, k ≥ 2; otherwise 0
  std::uint8_t goals = 0;                       // literals of g, at least one for Reach … Past, one for functions
  std::array<std::uint16_t, max_goals> goal{};  // proposition indices, ascending; unused ones 0

  std::span<const std::uint16_t> literals() const { return {goal.data(), goals}; }  // of the goal
  std::size_t times() const { return count > 1 ? count : 1; }                       // of Advance
  friend auto operator<=>(const Step&, const Step&) = default;
};

using Program = std::vector<Step>;  // steps joined by `then`

// How many steps a function applies to; 0 for every other step.
constexpr std::size_t operands(StepKind kind) {
  return kind < StepKind::Without ? 0 : kind == StepKind::Whether ? 2 : 1;
}

// Has every function the steps that it applies to?
bool is_complete(std::span<const Step> program);
// A step with all that it applies to is [i, unit_end(program, i)). Throws std::invalid_argument when steps are missing.
std::size_t unit_end(std::span<const Step> program, std::size_t i);

// The formula of a program over the arena's vocabulary. O(steps).
ltl::Formula formula_of(const Program& program, ltl::Arena& arena);

// Left and right exchanged in every literal (left_chair ↔ right_chair, turned_left ↔ turned_right).
// `images[p]` is the mirror image of proposition p: see mirror_images.
Program mirror(Program program, std::span<const std::uint16_t> images);
std::vector<std::uint16_t> mirror_images(const ltl::Vocabulary& vocabulary);

}  // namespace waymark::parser
