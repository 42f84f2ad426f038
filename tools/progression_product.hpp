// A referee of planners on models: the pairs of a state and what remains of a formula, without an automaton.
//
// A pair is a goal where the prefix that led to it settles the task: over finite words where it satisfies the formula,
// over infinite words where what remains is valid. Of a co-safe formula the latter is decided by progression alone: a
// word satisfies it exactly if progression along the word comes to `true` [KV01], so what remains is valid exactly if
// no cycle of progressions over all letters avoids `true`.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libplan/model/formats/read_case.hpp"

namespace waymark::tools {

struct ProgressionProduct {
  struct Choice {
    double cost = 0;
    std::vector<std::pair<std::uint32_t, double>> outcomes = {};  // pair, probability
  };
  std::vector<std::vector<Choice>> choices;  // by pair, the start is 0; of goals and where all is lost: none
  std::vector<bool> goal;
};

// Over infinite words the formula must be co-safe, and without past operators. Nothing: more pairs than the limit, a
// remainder that grows without end or reads too many propositions, or stopped.
std::optional<ProgressionProduct> product_by_progression(const plan::PlanningCase& model, ltl::Formula formula,
                                                         ltl::Semantics semantics, const ltl::Limits& limits);

// Of a model whose choices have one outcome: the least cost to a goal; infinite where there is no way.
double least_cost(const ProgressionProduct& product);

// The walks to a goal, which none passes before its end, that cost less than `below`; those within a billionth of it do
// not count. Nothing: more than `most` entries of the count, a choice that costs nothing.
std::optional<double> count_walks(const ProgressionProduct& product, double below, std::size_t most);
// All of them; infinite where one can go in circles on its way.
double count_walks(const ProgressionProduct& product);

// Does some finite word satisfy the formula, over all letters? Nothing: as above.
std::optional<bool> has_finite_word(ltl::Formula formula, const ltl::Limits& limits);

}  // namespace waymark::tools
