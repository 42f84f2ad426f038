// The Hanoi omega-automata format, version 1, for DFAs. [BBD+15]
//
// HOA has no finite words. Our convention, stated in the output: `properties: finite-words`, state-based
// `Acceptance: 1 Inf(0)`; the mark {0} on a state says "the word may stop here". Lossless: the initial state never
// carries it. Edge-based files (the mark on edges, as Spot prints DFAs) are read as well.
#pragma once
#include <string>
#include <string_view>

#include "libautomata/dfa.hpp"

namespace waymark::automata {

struct HoaOptions {
  std::string name;  // the `name:` header, usually the formula
};

std::string write_hoa(const Dfa& dfa, const HoaOptions& options = {});

// Throws ltl::FormatError with line and column; `source` names the file in messages.
// Nondeterministic automata are refused with a message that says so.
Dfa read_hoa(std::string_view text, std::string_view source = "");

}  // namespace waymark::automata
