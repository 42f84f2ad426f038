// The page of the studio: its files, embedded when the studio is built (embed.cmake writes the definition).
#pragma once
#include <span>
#include <string_view>

namespace waymark::studio {

struct Asset {
  std::string_view path, type, text;  // type: of the contents, "text/css"
};
std::span<const Asset> assets();

}  // namespace waymark::studio
