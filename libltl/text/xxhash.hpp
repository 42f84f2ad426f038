// XXH64, the 64-bit xxHash with seed 0: the checksum of model files and of road hierarchies. Not cryptographic; it
// finds damage, not malice.
// Specification: github.com/Cyan4973/xxHash, doc/xxhash_spec.md.
#pragma once
#include <cstdint>
#include <string_view>

namespace waymark::ltl {

std::uint64_t xxh64(std::string_view bytes);  // O(|bytes|), several bytes a nanosecond

}  // namespace waymark::ltl
