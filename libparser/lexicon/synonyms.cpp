#include "libparser/lexicon/synonyms.hpp"

#include <algorithm>

namespace waymark::parser {
namespace {

std::vector<std::string> phrases_of(const std::string& group) {
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin <= group.size();) {
    const std::size_t end = std::min(group.find(", ", begin), group.size());
    if (end > begin) out.push_back(group.substr(begin, end - begin));
    begin = end + 2;
  }
  return out;
}

}  // namespace

Synonyms::Synonyms(std::vector<std::string> groups) : groups_(std::move(groups)) {
  for (std::size_t i = 0; i < groups_.size(); ++i)
    for (std::string& phrase : phrases_of(groups_[i])) groups_of_.emplace(std::move(phrase), i);
}

std::vector<std::string> Synonyms::of(const std::string& phrase) const {
  std::vector<std::string> out;
  const auto [begin, end] = groups_of_.equal_range(phrase);
  for (auto it = begin; it != end; ++it)
    for (std::string& other : phrases_of(groups_[it->second]))
      if (other != phrase) out.push_back(std::move(other));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace waymark::parser
