// The product of a model with the automata of several formulas, as a model whose choices earn a reward for each
// objective; and its quotient, in which every run can end.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/solve/pareto.hpp"
#include "libplan/solve/state_model.hpp"

namespace waymark::plan {

struct ParetoProduct {
  Mdp mdp;                                   // "goal 0", …: the formula of the objective is decided, and holds
  std::vector<std::uint32_t> first;          // by state: its first choice among all
  std::vector<std::vector<double>> rewards;  // by objective and choice; more is better
  std::vector<std::uint32_t> origin;         // by state: that of the model
  std::vector<std::string> memory;           // by state: what the automata remember
  std::vector<bool> complemented;            // by objective: the reward is −P(¬φ)
};

// Throws as pareto, but for costs that may be infinite. nullopt: stopped.
std::optional<ParetoProduct> pareto_product(const Mdp& model, const std::vector<Objective>& objectives,
                                            const ltl::Limits& limits);

// May a run earn the objective, a cost that is to be great, for ever?
bool earns_for_ever(const ParetoProduct& product, const std::vector<Objective>& objectives, std::size_t objective);

// As pareto of a model, which the product is of.
std::optional<Pareto> pareto(const ParetoProduct& product, const std::vector<Objective>& objectives, double precision,
                             const std::stop_token& stop);

// End components whose choices earn nothing are one state, which may end. Only states from which a strategy ends almost
// surely are kept, and only choices that stay among them.
struct EndingQuotient {
  struct Choice {                                                 // of a state of the quotient
    std::uint32_t state = 0, choice = 0;                          // of the product
    bool ends = false;                                            // instead
    std::vector<std::pair<std::uint32_t, double>> outcomes = {};  // states of the quotient
  };
  std::vector<std::vector<Choice>> choices;  // by state; those that are not kept have none
  std::vector<std::uint32_t> proper;         // by state: a choice, such that all of them end almost surely
  std::vector<std::uint32_t> of;             // by state of the product
  EndComponents free;                        // of the product: they earn nothing
  std::uint32_t start = 0;                   // its first state
};
EndingQuotient ending_quotient(  // of the reachable product
    const ParetoProduct& product);

}  // namespace waymark::plan
