// Learning the matcher from texts with their lifted formulas: maximum likelihood over the formulas that texts have.
#pragma once
#include <functional>
#include <memory>
#include <span>

#include "libparser/lifted/formula_matcher.hpp"
#include "libparser/lifted/learn_lifted.hpp"

namespace waymark::parser {

struct MatcherTraining {      // by Adam [KB15], the tower of texts by its lazy form: only features that occur move
  neural::Index width = 128;  // of the towers
  std::uint64_t seed = 1;     // of all randomness
  std::size_t draws = 200'000, batch = 64;  // examples that are drawn by weight; of a step
  double rate = 2e-3;                       // falls to 0
  // Shares of features and of signals that are dropped; what the truth gives to all formulas of the scope.
  double feature_dropout = 0.2, dropout = 0.5, smoothing = 0.05;
  std::size_t least_texts = 2;         // that a feature must occur in
  std::size_t most_features = 60'000;  // of texts: the most frequent
  double least_weight = 0.5;           // of all texts of a formula together, or it is none to choose from
};

// The seed fixes the bytes. progress: the share that is done. Throws std::invalid_argument without examples.
std::shared_ptr<const FormulaMatcher> learn_matcher(std::span<const LiftedExample> examples,
                                                    const MatcherTraining& options,
                                                    const std::function<void(double)>& progress = {});

}  // namespace waymark::parser
