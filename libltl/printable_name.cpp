#include "libltl/printable_name.hpp"

#include <algorithm>

#include "libltl/diagnostic.hpp"

namespace waymark::ltl {

bool is_printable_name(std::string_view name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c < '\x7F'; });
  return plain || printable(name) == name;
}

}  // namespace waymark::ltl
