#include "libplan/world/letters.hpp"

namespace waymark::plan {

LetterId Letters::intern(const ltl::Letter& letter) {
  const auto [at, fresh] = index_.try_emplace(letter.members(), static_cast<std::uint32_t>(letters_.size()));
  if (fresh) letters_.push_back(letter);
  return LetterId{at->second};
}

ltl::FormatError unknown_proposition(const std::string& owner, const ltl::Vocabulary& vocabulary,
                                     const std::string& name) {
  std::string message = owner + " has no proposition '" + name + "'";
  if (const auto meant = vocabulary.nearest(name)) message += " (did you mean '" + *meant + "'?)";
  return ltl::FormatError("", 0, 0, message);
}

}  // namespace waymark::plan
