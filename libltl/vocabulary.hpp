// The vocabulary: the set AP of atomic propositions, in a fixed order, shared by map, formula and automaton.
//
// A proposition is its position in the vocabulary. A name is any non-empty text; identifiers are printed bare, other
// names in double quotes.
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace waymark::ltl {

struct Proposition {        // an atomic proposition
  std::uint32_t index = 0;  // its position in the vocabulary
  friend auto operator<=>(const Proposition&, const Proposition&) = default;
};

class Vocabulary {
 public:
  Vocabulary() = default;
  explicit Vocabulary(const std::vector<std::string>& names);  // duplicates are kept once

  Proposition add(std::string_view name);  // the proposition of that name, new or not; throws on an empty name
  std::optional<Proposition> find(std::string_view name) const;                // nothing when the name is unknown
  const std::string& name(Proposition p) const { return names_.at(p.index); }  // throws std::out_of_range
  const std::vector<std::string>& names() const { return names_; }             // in the order of the positions
  std::size_t size() const { return names_.size(); }

  // The known name with the least edit distance, if it is close enough to be what was meant. O(|AP| · length²).
  std::optional<std::string> nearest(std::string_view name) const;

  friend bool operator==(const Vocabulary& a, const Vocabulary& b) { return a.names_ == b.names_; }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> index_;
};

}  // namespace waymark::ltl
