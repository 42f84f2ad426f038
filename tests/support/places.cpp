#include "tests/support/places.hpp"

#include <cstdlib>

namespace waymark::testing {

std::filesystem::path source_root() { return WAYMARK_SOURCE_DIR; }

std::filesystem::path shared() {
  if (const char* place = std::getenv("WAYMARK_SHARED")) return place;
  return source_root().parent_path() / "shared";
}

}  // namespace waymark::testing
