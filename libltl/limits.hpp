// When a construction, a search or a reader gives up, and what it says then. The one type for all of them: seconds and
// bytes are limits too, by the stop token of a Watch (watch.hpp).
#pragma once
#include <cstddef>
#include <stop_token>

namespace waymark::ltl {

struct Limits {
  std::size_t states = 1'000'000;  // made: of automata before minimisation, of intermediate steps, of products, models
  std::stop_token stop = {};       // polled at least every few milliseconds
};

struct Exhausted {         // nothing proved: a limit was met or a stop was requested
  std::size_t states = 0;  // made so far
};

}  // namespace waymark::ltl
