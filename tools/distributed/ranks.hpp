// The ranks of mpirun that solve one task together, and what they agree on. Every function but the trivial ones is
// collective: all ranks call it in the same order.
#pragma once
#include <mpi.h>
#include <petscsystypes.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace waymark::tools {

// Throws std::runtime_error with PETSc's own words when a call of PETSc failed.
void check(PetscErrorCode code);

// PETSc and MPI from the first task to the last; at most one in a process.
class PetscLife {
 public:
  PetscLife();  // no file of options is read; the environment's PETSC_OPTIONS is
  ~PetscLife();
  PetscLife(const PetscLife&) = delete;
  PetscLife& operator=(const PetscLife&) = delete;
};

class Ranks {
 public:
  Ranks();  // all of them

  int rank() const { return rank_; }    // from 0
  int count() const { return count_; }  // of ranks
  MPI_Comm communicator() const { return communicator_; }

  // Of what the ranks bring; O(log count) messages.
  bool any(bool own) const;
  double greatest(double own) const;
  double least(double own) const;
  std::uint64_t sum(std::uint64_t own) const;
  template <std::size_t N>
  void greatest_of_each(std::array<double, N>& own) const {
    greatest_in_place(own.data(), N);
  }

 private:
  void greatest_in_place(double* own, std::size_t count) const;

  MPI_Comm communicator_;
  int rank_ = 0, count_ = 1;
};

}  // namespace waymark::tools
