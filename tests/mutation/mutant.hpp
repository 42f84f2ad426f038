// mutant(i): is mutant i the one that this process runs? Every mutated expression of a copy of the sources asks it, so
// one build holds all mutants. The environment names the mutant, or a file that takes down which ones are reached.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <type_traits>

namespace waymark_mutation {

constexpr unsigned most_mutants = 1U << 16U;

inline unsigned chosen() {
  const char* text = std::getenv("WAYMARK_MUTANT");
  return text == nullptr ? 0U : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

// One byte a mutant, in a file of most_mutants bytes that is shared with the process: a crash loses nothing.
inline char* reached_file() {
  const char* path = std::getenv("WAYMARK_MUTANTS_REACHED");
  const int file = path == nullptr ? -1 : open(path, O_RDWR);
  if (file < 0) return nullptr;
  void* bytes = mmap(nullptr, most_mutants, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return bytes == MAP_FAILED ? nullptr : static_cast<char*>(bytes);
}

inline const unsigned active = chosen();
inline char* const reached = reached_file();

inline bool mutant(unsigned i) {
  if (reached != nullptr) reached[i] = 1;
  return i == active;
}

// Inside of constexpr functions. What the compiler evaluates is not mutated.
constexpr bool mutant_of_constexpr(unsigned i) { return !std::is_constant_evaluated() && mutant(i); }

}  // namespace waymark_mutation
