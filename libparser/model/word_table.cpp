#include "libparser/model/word_table.hpp"

namespace waymark::parser {

WordTable::WordTable() {
  add("<unknown>");
  add("<s>");
  add("</s>");
}

WordId WordTable::find(std::string_view word) const {
  const auto it = index_.find(std::string(word));
  return it == index_.end() ? unknown : it->second;
}

WordId WordTable::add(std::string_view word) {
  const auto [it, is_new] = index_.try_emplace(std::string(word), WordId{static_cast<std::uint32_t>(words_.size())});
  if (is_new) words_.emplace_back(word);
  return it->second;
}

}  // namespace waymark::parser
