// Does every run of a model satisfy a formula over infinite words, or an automaton? If not, a counterexample.
//
// Where every choice has one outcome, all walks are asked about, and the counterexample is a lasso, certified by the
// definition of ⊨. Where chance decides, the formula holds if every strategy satisfies it with probability 1; the
// counterexample is a strategy, the only one of a Markov chain, and paths that it takes: after each of them the formula
// is violated with probability 1. The likeliest come first [HKD09], and none is a beginning of another one, so that
// their probabilities add up.
#pragma once
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "libplan/solve/case_task.hpp"

namespace waymark::plan {

struct LikelyPath {                  // of a strategy
  std::vector<std::string> places;   // the start first
  std::vector<std::string> actions;  // between them
  double probability = 0;            // of the outcomes on it
};

struct ModelCheck {                        // what was found of one formula
  bool holds = true;                       // on all runs
  Bounds probability{1, 1};                // of the formula, under the worst strategy; where chance decides
  std::optional<CaseAnswer::Lasso> lasso;  // on which the formula does not hold
  std::vector<LikelyPath> paths;           // on which it does not hold
  double probability_of_paths = 0;         // together
  bool is_chain = false;                   // no strategy has a choice
};

struct ModelCheckOptions {             // what may be spent and told
  std::size_t paths = 10;              // at most
  double tolerance = 1e-6;             // of the probability
  std::size_t states = 4'000'000'000;  // of the product
  std::stop_token stop = {};           // polled
};

// nullopt: a limit was met, or stopped. Throws ltl::SyntaxError for a formula that cannot be read.
std::optional<ModelCheck> check_model(const PlanningCase& model, const std::string& formula,
                                      const ModelCheckOptions& options = {});
// Does it accept every run? A lasso is certified by its complement. Throws std::invalid_argument for an automaton about
// finite words.
std::optional<ModelCheck> check_model(const PlanningCase& model, const GivenAutomaton& specification,
                                      const ModelCheckOptions& options = {});

}  // namespace waymark::plan
