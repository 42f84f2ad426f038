#include "tools/help/topics.hpp"

#include <algorithm>

namespace waymark::tools {

std::string title_of(const HelpTopic& topic) {
  const std::string_view page = topic.page;
  const auto from = page.find("# ");
  if (from == std::string_view::npos) return std::string(topic.name);
  return std::string(page.substr(from + 2, page.find('\n', from) - from - 2));
}

const HelpTopic* find_topic(std::string_view name) {
  for (const HelpTopic& topic : help_topics())
    if (topic.name == name) return &topic;
  for (const HelpTopic& topic : help_topics()) {
    std::string_view rest = topic.name;
    while (!rest.empty()) {
      const auto end = std::min(rest.find('-'), rest.size());
      if (const auto word = rest.substr(0, end); word == name && word != "and") return &topic;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return nullptr;
}

}  // namespace waymark::tools
