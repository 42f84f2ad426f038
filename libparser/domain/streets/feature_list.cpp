#include "libparser/domain/streets/feature_list.hpp"

namespace waymark::streets {

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash ^= value + 0x9E3779B97F4A7C15ULL + (hash << 6U) + (hash >> 2U);
  hash *= 0xFF51AFD7ED558CCDULL;
  return hash ^ (hash >> 33U);
}

std::uint64_t hash_of(std::string_view word) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (char c : word) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  return hash;
}

unsigned bin(double value, std::initializer_list<double> thresholds) {
  unsigned b = 0;
  for (double t : thresholds) b += value >= t ? 1U : 0U;
  return b;
}

}  // namespace waymark::streets
