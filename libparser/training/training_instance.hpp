// Training instances of learners of programs: passes over instances, and the weight of a program.
#pragma once
#include <algorithm>
#include <numeric>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "libparser/training/learn.hpp"

namespace waymark::parser {

// visit(order, epoch) for each epoch, with the instances in an order drawn anew. below(n): a random number less than n.
template <class Below, class Visit>
void each_epoch(std::size_t instances, int epochs, const Below& below, const Visit& visit) {
  std::vector<std::size_t> order(instances);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int epoch = 0; epoch < epochs; ++epoch) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[below(i)]);
    visit(std::span<const std::size_t>(order), epoch);
  }
}

// The same in batches: visit(batch, epoch, begin), where the batch begins in its epoch. Throws Stopped when asked to.
template <class Below, class Visit>
void each_batch(std::size_t instances, std::size_t batch, int epochs, const std::stop_token& stop, const Below& below,
                const Visit& visit) {
  each_epoch(instances, epochs, below, [&](std::span<const std::size_t> order, int epoch) {
    for (std::size_t begin = 0; begin < order.size(); begin += batch) {
      if (stop.stop_requested()) throw Stopped{};
      visit(order.subspan(begin, std::min(batch, order.size() - begin)), epoch, begin);
    }
  });
}

// Does this epoch look for programs in the own beam? Every second one from the first that may.
bool explores(const TrainOptions& options, int epoch);

// Of a consistent program, before the model has a say.
double prior_weight(const TrainOptions& options, bool same_route, double lexical_overlap_penalty);

// Does the program name a place by a number that the sentence does not name? places[n]: it names n.
bool names_other_place(const Program& program, std::span<const std::size_t> place_numbers,
                       const std::vector<bool>& places);

}  // namespace waymark::parser
