#include "tests/support/zielonka.hpp"

#include <algorithm>
#include <iterator>

namespace waymark::test {
namespace {

using Player = automata::ParityGame::Player;

// Within `area`: from where `player` forces a visit to `target`.
Vertices attractor(const automata::ParityGame& game, const Vertices& area, Vertices target, Player player) {
  for (bool grew = true; grew;) {
    grew = false;
    for (std::uint32_t v : area) {
      if (target.contains(v)) continue;
      bool any = false, all = true;
      for (std::uint32_t w : game.vertices[v].successors) {
        if (!area.contains(w)) continue;
        (target.contains(w) ? any : all) = target.contains(w);
      }
      if (game.vertices[v].owner == player ? any : all && any) grew = target.insert(v).second;
    }
  }
  return target;
}

Vertices without(const Vertices& all, const Vertices& taken) {
  Vertices out;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(), std::inserter(out, out.end()));
  return out;
}

}  // namespace

Vertices won_by_system(const automata::ParityGame& game, const Vertices& area) {
  if (area.empty()) return {};
  std::uint32_t top = 0;
  for (std::uint32_t v : area) top = std::max(top, game.vertices[v].priority);
  const Player better = top % 2 == 0 ? Player::System : Player::Environment;
  const Player worse = better == Player::System ? Player::Environment : Player::System;
  Vertices highest;
  for (std::uint32_t v : area)
    if (game.vertices[v].priority == top) highest.insert(v);
  const Vertices rest = without(area, attractor(game, area, highest, better));
  const Vertices system = won_by_system(game, rest);
  const Vertices lost = worse == Player::System ? system : without(rest, system);
  if (lost.empty()) return better == Player::System ? area : Vertices{};
  const Vertices forced = attractor(game, area, lost, worse);
  Vertices inner = won_by_system(game, without(area, forced));
  if (worse == Player::System) inner.insert(forced.begin(), forced.end());
  return inner;
}

}  // namespace waymark::test
