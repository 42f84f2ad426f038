#include "libplan/world/letters.hpp"

namespace waymark::plan {

LetterId Letters::intern(const ltl::Letter& letter) {
  const auto [at, fresh] = index_.try_emplace(letter.members(), static_cast<std::uint32_t>(letters_.size()));
  if (fresh) letters_.push_back(letter);
  return LetterId{at->second};
}

}  // namespace waymark::plan
