// The exchange of border rows between neighbouring bands: a star forest of PETSc, whose roots are the places of a rank
// and whose leaves are the copies of them in the halos of its neighbours.
//
// An array holds a plane of places for every state of the automaton, one after the other, halo included: an exchange
// moves 2 · planes · width values for a rank with two neighbours. All functions are collective.
#pragma once
#include <petscsf.h>

#include <cstddef>
#include <cstdint>

#include "tools/distributed/grid_band.hpp"
#include "tools/distributed/ranks.hpp"

namespace waymark::tools {

class Halo {
 public:
  Halo(const Ranks& ranks, const GridBand& band, std::uint32_t planes);
  ~Halo();
  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  // The halos become what their owners have.
  void fetch(double* planes) const;
  void fetch(std::uint8_t* planes) const;
  // The owners' border rows become the greatest of what they and the halos of the neighbours have.
  void offer(std::uint8_t* planes) const;
  std::size_t values() const { return values_; }  // that this rank is sent by one fetch

 private:
  PetscSF forest_ = nullptr;
  std::size_t values_ = 0;
};

}  // namespace waymark::tools
