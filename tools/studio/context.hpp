// What every answer of the studio may use: the reader of instructions, the maps, and when to stop.
#pragma once
#include <cstddef>
#include <stop_token>

#include "libparser/decode/grounder.hpp"
#include "tools/studio/worlds.hpp"

namespace waymark::studio {

// Pictures of automata are small enough to be laid out at once: many may be asked for, and others wait.
constexpr std::size_t most_drawn_edges = 120;
constexpr double most_layout_seconds = 2;

struct Context {
  const parser::Grounder& reader;
  Worlds& worlds;
  std::stop_token stop;  // the time limit of the request
};

}  // namespace waymark::studio
