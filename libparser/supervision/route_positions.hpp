// Where on a route a program can be done: the positions at which its steps end, as a bit set.
#pragma once
#include <cstdint>
#include <vector>

#include "libparser/programs/execute.hpp"
#include "libparser/supervision/search.hpp"

namespace waymark::parser {

using Positions = std::uint64_t;  // bit i: after i actions

class RoutePositions {
 public:
  static constexpr std::size_t most = 63;  // actions of a route; must not be more
  RoutePositions(const Executor& executor, const GoldRoute& route);

  static Positions first() { return 1; }  // the start alone
  // Is the end of the route among them?
  bool ends(Positions at) const { return (at >> (letters_.size() - 1) & 1U) != 0; }
  Positions where(Positions at, std::uint16_t proposition) const;  // those at which the proposition holds
  // Of a step (not a function) that is owed at one of these positions; guard: `without` or `keep`, of `reach`.
  Positions after(Positions at, const Step& step, const Step* guard = nullptr) const;

 private:
  bool holds(const Step& step, std::size_t i) const;
  Positions advance(Positions at, const Step& step) const;

  const Executor& executor_;
  std::vector<Arrival> letters_;
};

}  // namespace waymark::parser
