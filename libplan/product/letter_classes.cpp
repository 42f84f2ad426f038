#include "libplan/product/letter_classes.hpp"

#include <map>
#include <optional>

namespace waymark::plan {

LetterClasses letter_classes(const Letters& letters, const ltl::Vocabulary& vocabulary,
                             const std::vector<ltl::Proposition>& reads) {
  std::vector<std::optional<ltl::Proposition>> theirs;
  for (ltl::Proposition p : reads) theirs.push_back(letters.vocabulary().find(vocabulary.name(p)));
  std::map<std::vector<ltl::Proposition>, std::uint32_t> seen;
  LetterClasses out;
  for (std::uint32_t i = 0; i < letters.size(); ++i) {
    ltl::Letter ours;
    for (std::size_t v = 0; v < reads.size(); ++v)
      if (theirs[v] && letters[LetterId{i}].contains(*theirs[v])) ours.insert(reads[v]);
    const auto [at, fresh] = seen.try_emplace(ours.members(), static_cast<std::uint32_t>(seen.size()));
    if (fresh) out.representatives.push_back(ours);
    out.of.push_back(at->second);
  }
  return out;
}

}  // namespace waymark::plan
