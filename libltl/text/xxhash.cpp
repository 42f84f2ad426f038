#include "libltl/text/xxhash.hpp"

#include <array>
#include <bit>
#include <cstring>

namespace waymark::ltl {
namespace {

static_assert(std::endian::native == std::endian::little, "model files are little endian and read in place");

constexpr std::uint64_t prime1 = 0x9E3779B185EBCA87U, prime2 = 0xC2B2AE3D27D4EB4FU, prime3 = 0x165667B19E3779F9U,
                        prime4 = 0x85EBCA77C2B2AE63U, prime5 = 0x27D4EB2F165667C5U;

template <class Word>
std::uint64_t take(std::string_view& bytes) {
  Word word = 0;
  std::memcpy(&word, bytes.data(), sizeof word);
  bytes.remove_prefix(sizeof word);
  return word;
}

std::uint64_t round(std::uint64_t lane, std::uint64_t word) { return std::rotl(lane + word * prime2, 31) * prime1; }

// Four lanes, of which each reads every fourth word; what is left is shorter than 32 bytes.
std::uint64_t converge(std::string_view& bytes) {
  std::array<std::uint64_t, 4> lanes{prime1 + prime2, prime2, 0, 0 - prime1};
  while (bytes.size() >= 32)
    for (std::uint64_t& lane : lanes) lane = round(lane, take<std::uint64_t>(bytes));
  std::uint64_t hash =
      std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) + std::rotl(lanes[3], 18);
  for (const std::uint64_t lane : lanes) hash = (hash ^ round(0, lane)) * prime1 + prime4;
  return hash;
}

}  // namespace

std::uint64_t xxh64(std::string_view bytes) {
  const std::uint64_t size = bytes.size();
  std::uint64_t hash = size + (size >= 32 ? converge(bytes) : prime5);
  while (bytes.size() >= 8) hash = std::rotl(hash ^ round(0, take<std::uint64_t>(bytes)), 27) * prime1 + prime4;
  if (bytes.size() >= 4) hash = std::rotl(hash ^ take<std::uint32_t>(bytes) * prime1, 23) * prime2 + prime3;
  while (!bytes.empty()) hash = std::rotl(hash ^ take<std::uint8_t>(bytes) * prime5, 11) * prime1;
  hash = (hash ^ hash >> 33U) * prime2;
  hash = (hash ^ hash >> 29U) * prime3;
  return hash ^ hash >> 32U;
}

}  // namespace waymark::ltl
