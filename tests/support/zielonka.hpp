// Zielonka's algorithm on sets, a second opinion about parity games [Zie98].
#pragma once
#include <cstdint>
#include <set>

#include "libautomata/deterministic/parity_game.hpp"

namespace waymark::test {

using Vertices = std::set<std::uint32_t>;

// Within `area`, from where the system wins when plays stay there.
Vertices won_by_system(const automata::ParityGame& game, const Vertices& area);

}  // namespace waymark::test
