#include "libltl/vocabulary.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libltl/printable_name.hpp"

namespace waymark::ltl {
namespace {

// Insertions, deletions, substitutions and swaps of neighbours, three rows of the table at a time. O(|a| · |b|).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, substituted});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

Vocabulary::Vocabulary(const std::vector<std::string>& names) {
  for (const std::string& name : names) add(name);
}

Proposition Vocabulary::add(std::string_view name) {
  if (name.empty()) throw std::invalid_argument("a proposition needs a name");
  if (!is_printable_name(name))
    throw FormatError("", 0, 0,
                      "the name of a proposition has a control character or is no UTF-8: " + std::string(name));
  const auto [it, is_new] = index_.try_emplace(std::string(name), static_cast<std::uint32_t>(names_.size()));
  if (is_new) names_.emplace_back(name);
  return Proposition{it->second};
}

std::optional<Proposition> Vocabulary::find(std::string_view name) const {
  const auto it = index_.find(std::string(name));
  if (it == index_.end()) return std::nullopt;
  return Proposition{it->second};
}

std::optional<std::string> Vocabulary::nearest(std::string_view name) const {
  std::optional<std::string> best;
  std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;  // at most a third of the characters wrong
  for (const std::string& known : names_) {
    const std::size_t distance = edit_distance(name, known);
    if (distance < least) {
      least = distance;
      best = known;
    }
  }
  return best;
}

}  // namespace waymark::ltl
