// Motions: refused with a FormatError, or read; and a motion that has a route moves along the map.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libplan/motion/read_motion.hpp"
#include "libplan/world/read_map.hpp"

namespace {

using namespace waymark;

// Two hallways in a corner, a chair at one end.
const plan::Map& corner() {
  static const plan::Map map = plan::parse_map(R"({"name": "corner", "objects": ["chair"], "floors": ["blue"],
    "walls": ["fish"], "nodes": [{"x": 0, "y": 0, "object": null, "place": null}, {"x": 1, "y": 0, "object": null,
    "place": null}, {"x": 1, "y": 1, "object": "chair", "place": null}], "edges": [
    {"a": [0, 0], "b": [1, 0], "floor": "blue", "wall": "fish"}, {"a": [1, 0], "b": [1, 1], "floor": "blue",
     "wall": "fish"}]})");
  return map;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 4'096) return 0;
  static const plan::Workspace workspace(corner());
  try {
    const plan::Motion motion = plan::parse_motion({reinterpret_cast<const char*>(data), size});
    const auto read = plan::route_of(motion, workspace);
    if (const auto* route = std::get_if<plan::Trajectory>(&read))
      for (std::size_t i = 0; i < route->actions.size(); ++i)
        if (corner().successor(route->poses[i], route->actions[i]) != route->poses[i + 1]) std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}
