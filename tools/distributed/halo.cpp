#include "tools/distributed/halo.hpp"

#include <vector>

namespace waymark::tools {

Halo::Halo(const Ranks& ranks, const GridBand& band, std::uint32_t planes) {
  std::vector<PetscInt> copies;
  std::vector<PetscSFNode> owners;
  const std::uint32_t w = band.width();
  // The row of the halo whose first place is `own`, and `theirs` of a neighbour's band.
  const auto add = [&](int neighbour, std::uint32_t own, std::uint32_t theirs, std::uint32_t their_places) {
    for (std::uint32_t plane = 0; plane < planes; ++plane)
      for (std::uint32_t x = 0; x < w; ++x) {
        copies.push_back(static_cast<PetscInt>(plane * band.places() + own + x));
        owners.push_back({static_cast<PetscInt>(neighbour), static_cast<PetscInt>(plane * their_places + theirs + x)});
      }
  };
  const auto places = [&](int rank) { return (rows_of(rank, ranks.count(), band.height()).count() + 2) * w; };
  const int rank = ranks.rank();
  if (rank > 0) add(rank - 1, 0, places(rank - 1) - 2 * w, places(rank - 1));
  if (rank + 1 < ranks.count()) add(rank + 1, band.last_own(), w, places(rank + 1));
  values_ = copies.size();
  check(PetscSFCreate(ranks.communicator(), &forest_));
  check(PetscSFSetGraph(forest_, static_cast<PetscInt>(planes * band.places()), static_cast<PetscInt>(copies.size()),
                        copies.data(), PETSC_COPY_VALUES, owners.data(), PETSC_COPY_VALUES));
  check(PetscSFSetUp(forest_));
}

Halo::~Halo() { PetscSFDestroy(&forest_); }

void Halo::fetch(double* planes) const {
  check(PetscSFBcastBegin(forest_, MPIU_SCALAR, planes, planes, MPI_REPLACE));
  check(PetscSFBcastEnd(forest_, MPIU_SCALAR, planes, planes, MPI_REPLACE));
}

void Halo::fetch(std::uint8_t* planes) const {
  check(PetscSFBcastBegin(forest_, MPI_UNSIGNED_CHAR, planes, planes, MPI_REPLACE));
  check(PetscSFBcastEnd(forest_, MPI_UNSIGNED_CHAR, planes, planes, MPI_REPLACE));
}

void Halo::offer(std::uint8_t* planes) const {
  check(PetscSFReduceBegin(forest_, MPI_UNSIGNED_CHAR, planes, planes, MPI_MAX));
  check(PetscSFReduceEnd(forest_, MPI_UNSIGNED_CHAR, planes, planes, MPI_MAX));
}

}  // namespace waymark::tools
