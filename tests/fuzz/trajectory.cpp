// Trajectories: refused with a FormatError, or steps of the map that print and read back as themselves.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libplan/world/read_map.hpp"
#include "libplan/world/trajectory.hpp"

namespace {

using namespace waymark;

// A square of hallways, with a dead end at its corner.
const plan::Map& square() {
  static const plan::Map map = plan::parse_map(R"({"name": "square", "objects": ["chair"], "floors": ["blue"],
    "walls": ["fish"], "nodes": [{"x": 0, "y": 0, "object": "chair", "place": 1}, {"x": 1, "y": 0, "object": null,
    "place": null}, {"x": 0, "y": 1, "object": null, "place": null}, {"x": 1, "y": 1, "object": null, "place": null},
    {"x": 2, "y": 1, "object": null, "place": null}], "edges": [
    {"a": [0, 0], "b": [1, 0], "floor": "blue", "wall": "fish"}, {"a": [0, 0], "b": [0, 1], "floor": "blue",
     "wall": "fish"},
    {"a": [1, 0], "b": [1, 1], "floor": "blue", "wall": "fish"}, {"a": [0, 1], "b": [1, 1], "floor": "blue",
     "wall": "fish"},
    {"a": [1, 1], "b": [2, 1], "floor": "blue", "wall": "fish"}]})");
  return map;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const plan::Trajectory trajectory = plan::parse_trajectory(text, square());
    if (trajectory.poses.size() != trajectory.actions.size() + 1) std::abort();
    if (plan::parse_trajectory(plan::show(trajectory, square()), square()) != trajectory) std::abort();
    if (plan::word_of(trajectory, square()).size() != trajectory.poses.size()) std::abort();
  } catch (const ltl::FormatError&) {
  }
  try {
    if (plan::parse_start(text, square()).empty()) std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}
