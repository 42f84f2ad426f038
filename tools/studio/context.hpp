// What every answer of the studio may use: the reader of instructions, the maps, and when to stop.
#pragma once
#include <stop_token>

#include "libparser/decode/grounder.hpp"
#include "tools/studio/worlds.hpp"

namespace waymark::studio {

struct Context {
  const parser::Grounder& reader;
  Worlds& worlds;
  std::stop_token stop;  // the time limit of the request
};

}  // namespace waymark::studio
