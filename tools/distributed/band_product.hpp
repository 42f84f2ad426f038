// The product of a band and a task: pairs of place and automaton state, those of the halo included. A rank generates
// the pairs of its own places; nothing is stored, successors are computed when asked for.
//
// A pair has the number task · places + place: one plane of places for every state of the automaton.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "libplan/product/task_table.hpp"
#include "tools/distributed/grid_band.hpp"

namespace waymark::tools {

class BandProduct {
 public:
  static constexpr std::uint32_t trap = UINT32_MAX;  // the task cannot be met any more

  // Both must outlive it. Throws GaveUp when the pairs of the band are more than PETSc's numbers.
  BandProduct(const GridBand& band, const plan::TaskTable& task);

  const GridBand& band() const { return *band_; }
  const plan::TaskTable& task() const { return *task_; }
  std::uint32_t pairs() const { return task_->states() * band_->places(); }
  std::uint32_t number(std::uint32_t place, std::uint32_t q) const { return q * band_->places() + place; }
  std::uint32_t place(std::uint32_t pair) const { return pair % band_->places(); }
  std::uint32_t state(std::uint32_t pair) const { return pair / band_->places(); }
  bool is_goal(std::uint32_t pair) const { return task_->is_goal(state(pair)); }

  struct Around {                       // of a pair
    std::array<std::uint32_t, 4> to{};  // by direction: the pair that a move leads to, or trap
    std::uint32_t marked = 0;           // bit d: that step of the automaton is marked
  };
  Around around(std::uint32_t pair) const;                                    // of an own pair that is no goal
  std::uint32_t directions(std::uint32_t k) const { return directions_[k]; }  // bit d: choice k may lead there
  std::uint32_t all_directions() const { return all_directions_; }            // of all choices
  std::span<const std::uint32_t> jumps(std::uint32_t pair) const { return task_->jumps(state(pair)); }
  template <class Visit>  // visit(pair): among others every own pair with an outcome into this one
  void for_each_predecessor(std::uint32_t pair, Visit&& visit) const {
    const std::uint32_t here = place(pair), q = state(pair);
    for (const std::uint32_t from : task_->sources(q)) {
      if (band_->is_own(here) && band_->has_barred_move(here)) visit(number(here, from));
      for (std::uint32_t d = 0; d < 4; ++d)
        if (const std::uint32_t there = band_->behind(here, d); band_->is_own(there) && band_->is_open(there, d))
          visit(number(there, from));
    }
    if (!band_->is_own(here)) return;
    for (const std::uint32_t from : task_->jump_sources(q)) visit(number(here, from));
  }
  template <class Visit>  // visit(pair): the own pairs, by state and place
  void for_each_own(Visit&& visit) const {
    for (std::uint32_t q = 0; q < task_->states(); ++q)
      for (std::uint32_t p = band_->first_own(); p < band_->last_own(); ++p) visit(number(p, q));
  }
  template <class Visit>  // visit(pair): the pairs of the halo
  void for_each_copy(Visit&& visit) const {
    for (std::uint32_t q = 0; q < task_->states(); ++q)
      for (std::uint32_t x = 0; x < band_->width(); ++x) {
        visit(number(x, q));
        visit(number(band_->last_own() + x, q));
      }
  }

 private:
  const GridBand* band_;
  const plan::TaskTable* task_;
  std::array<std::uint32_t, 4> directions_{};
  std::uint32_t all_directions_ = 0;
};

}  // namespace waymark::tools
