#include "libplan/product/alphabet_classes.hpp"

#include <map>
#include <optional>

namespace waymark::plan {

std::vector<ltl::Letter> as_read(const std::vector<ltl::Letter>& letters, const ltl::Vocabulary& from,
                                 const ltl::Vocabulary& to, const std::vector<ltl::Proposition>& reads) {
  std::vector<std::optional<ltl::Proposition>> theirs;
  for (ltl::Proposition p : reads) theirs.push_back(from.find(to.name(p)));
  std::vector<ltl::Letter> out;
  for (const ltl::Letter& letter : letters) {
    ltl::Letter& read = out.emplace_back();
    for (std::size_t v = 0; v < reads.size(); ++v)
      if (theirs[v] && letter.contains(*theirs[v])) read.insert(reads[v]);
  }
  return out;
}

LetterClasses letter_classes(const Letters& letters, const ltl::Vocabulary& vocabulary,
                             const std::vector<ltl::Proposition>& reads) {
  std::vector<ltl::Letter> all;
  for (std::uint32_t i = 0; i < letters.size(); ++i) all.push_back(letters[LetterId{i}]);
  std::map<std::vector<ltl::Proposition>, std::uint32_t> seen;
  LetterClasses out;
  for (const ltl::Letter& read : as_read(all, letters.vocabulary(), vocabulary, reads)) {
    const auto [at, fresh] = seen.try_emplace(read.members(), static_cast<std::uint32_t>(seen.size()));
    if (fresh) out.representatives.push_back(read);
    out.of.push_back(at->second);
  }
  return out;
}

}  // namespace waymark::plan
