// What the matcher looks at: features of a lifted text and of a lifted formula, as 64-bit keys.
//
//   of a text      its n-grams of up to four words, pairs with one word between, four letters of a word in a row, the
//                  words after and before each slot up to the next one, the order of its slots
//   of a formula   the whole; the whole without the names of its slots; the order of its slots; its symbols, pairs and
//                  triples of neighbours; each slot with the operators around it
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "libparser/lifted/lifted_network.hpp"
#include "libparser/lifted/lifted_symbol.hpp"

namespace waymark::parser {

// Ascending, each once. O(tokens) apart from sorting.
std::vector<std::uint64_t> matching_features(const LiftedText& text);
// With repetitions: a symbol that occurs twice counts twice. Must be complete. O(symbols)
std::vector<std::uint64_t> matching_features(std::span<const LiftedSymbol> formula);

}  // namespace waymark::parser
