// --slip and --slip-turn: what the actions of a hallway map may do instead of what was meant.
#pragma once
#include <string>

#include "libplan/model/map_mdp.hpp"
#include "tools/shell/command.hpp"

namespace waymark::tools {

struct NoiseOptions {
  std::string forward, turn;
  bool given() const { return !forward.empty() || !turn.empty(); }
};
void add_noise_options(Command command, NoiseOptions& options);
plan::MapNoise noise_of(const NoiseOptions& options);  // throws UsageError

}  // namespace waymark::tools
