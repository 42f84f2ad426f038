#include "libparser/training/training_instance.hpp"

#include <cmath>

namespace waymark::parser {

bool explores(const TrainOptions& options, int epoch) {
  return epoch >= options.explore_from && (epoch - options.explore_from) % 2 == 0;
}

double prior_weight(const TrainOptions& options, bool same_route, double lexical_overlap_penalty) {
  return (same_route ? 1.0 : options.other_route) * std::exp(-options.wording * lexical_overlap_penalty);
}

bool names_other_place(const Program& program, std::span<const std::size_t> place_numbers,
                       const std::vector<bool>& places) {
  for (const Step& step : program)
    for (const std::uint16_t p : step.literals())
      if (const std::size_t n = place_numbers[p]; n > 0 && (n >= places.size() || !places[n])) return true;
  return false;
}

}  // namespace waymark::parser
