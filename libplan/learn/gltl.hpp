// Geometric linear temporal logic: a task in which every operator may expire, as one more reward for learners.
//
// After each letter a pending φ U ψ (F too) expires with probability 1 − μ and is then false, a pending φ R ψ (G too)
// likewise, and is then true. So Pr(⊨ φ) discounts by itself, even G can be fulfilled, and a longer way is a more
// dangerous one. [LTDI+17, Sec. 3]; X does not expire. Tasks are those of infinite words: there is no last letter.
//
// Every operator of φ has one coin, tossed with each letter: letters become pairs (letter of the model, coins), and the
// task a deterministic table again, so that all learners and the exact values work on it unchanged. States are
// progressed formulas in a canonical form: the minimal sets of pending subformulas that would do.
#pragma once
#include <optional>

#include "libltl/formula.hpp"
#include "libplan/learn/task_rows.hpp"

namespace waymark::plan {

struct Gltl {
  double keep = 0.98;          // μ
  std::size_t most_coins = 8;  // letters are 2^coins times as many
  std::size_t most_states = 4096;
};

// nullopt beyond a limit. Throws ltl::FormatError naming a proposition that the model lacks.
std::optional<TaskRows> gltl_tasks(ltl::Formula phi, const Letters& letters, const Gltl& options = {});

// The same states where nothing ever expires: what a policy learnt under expiry is worth in earnest.
TaskRows without_expiry(TaskRows table);

}  // namespace waymark::plan
