// Map files: refused with a FormatError, or a map whose every pose has a label and whose moves stay on it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libplan/world/read_map.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const plan::Map map = plan::parse_map(text);
    for (std::uint32_t p = 0; p < map.poses(); ++p)
      for (plan::Action action : plan::all_actions) {
        const auto next = map.successor({p}, action);
        if (next && next->index >= map.poses()) std::abort();
        if (next && !map.letter(*next, action).includes(map.label(*next))) std::abort();
      }
  } catch (const ltl::FormatError&) {
  }
  return 0;
}
