// Several descriptions of one route, read as one: where one text leaves a landmark out, another may name it.
//
// Each text t gives p_t(route) over its own candidates. A text may be heedless, about no route at all, with probability ε
// (people were paid by the text); texts are taken for independent given the route:
//
//   p(route | texts)  ∝  Π_t ((1 − ε) p_t(route) + ε / n)        n: distinct routes among all candidates
//
// What p_t knows of routes before any text is counted once a text: it hardly matters beside what they say.
#pragma once
#include <span>
#include <vector>

#include "libparser/domain/streets/street_model.hpp"

namespace waymark::streets {

// Best first, probabilities that sum to 1; of equals, in the order of the first text's readings, then the second's, …
// Empty when no text has a reading. O(r log r) for r readings in all. Requires 0 < heedless <= 1.
std::vector<StreetReading> read_together(std::span<const std::vector<StreetReading>> texts,
                                         double heedless = 0.1);

}  // namespace waymark::streets
