#include "tools/distributed/ranks.hpp"

#include <petscsys.h>

#include <stdexcept>
#include <string>

namespace waymark::tools {

void check(PetscErrorCode code) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(static_cast<int>(code), &text, nullptr);
  throw std::runtime_error(std::string("PETSc: ") + (text != nullptr ? text : "an error without a name"));
}

PetscLife::PetscLife() {
  static std::string name = "waymark-distributed", no_file = "-skip_petscrc", no_signals = "-no_signal_handler";
  static std::array<char*, 4> arguments{name.data(), no_file.data(), no_signals.data(), nullptr};
  int count = 3;
  char** given = arguments.data();
  check(PetscInitialize(&count, &given, nullptr, nullptr));
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
}

PetscLife::~PetscLife() { PetscFinalize(); }

Ranks::Ranks() : communicator_(PETSC_COMM_WORLD) {
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &count_);
}

bool Ranks::any(bool own) const {
  int all = 0, mine = own ? 1 : 0;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, communicator_);
  return all != 0;
}

double Ranks::greatest(double own) const {
  greatest_in_place(&own, 1);
  return own;
}

double Ranks::least(double own) const { return -greatest(-own); }

std::uint64_t Ranks::sum(std::uint64_t own) const {
  std::uint64_t all = 0;
  MPI_Allreduce(&own, &all, 1, MPI_UINT64_T, MPI_SUM, communicator_);
  return all;
}

void Ranks::greatest_in_place(double* own, std::size_t count) const {
  MPI_Allreduce(MPI_IN_PLACE, own, static_cast<int>(count), MPI_DOUBLE, MPI_MAX, communicator_);
}

}  // namespace waymark::tools
