// The pages of the manual that `waymark help` shows. The build embeds docs/conventions.md and docs/formats/*.md.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace waymark::tools {

struct HelpTopic {
  std::string_view name, page;  // "maps-and-routes"; Markdown
};
std::span<const HelpTopic> help_topics();

std::string title_of(const HelpTopic& topic);  // its first heading
// By its name or by a word of it: maps-and-routes is maps and routes, too. nullptr: there is none.
const HelpTopic* find_topic(std::string_view name);

}  // namespace waymark::tools
