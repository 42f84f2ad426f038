// Classes are refined by one proposition at a time: two letters stay together while the propositions so far agree on
// them. No hashing, any number of propositions.
#include "libplan/product/alphabet_classes.hpp"

#include <array>
#include <optional>
#include <utility>

namespace waymark::plan {

AlphabetClasses::AlphabetClasses(const Letters& letters, const ltl::Vocabulary& vocabulary,
                                 const std::vector<ltl::Proposition>& reads, UnknownProposition unknown,
                                 const std::string& owner)
    : class_(letters.size(), 0), representatives_(1) {
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::array<std::uint32_t, 2>> refined;  // class so far × (in the letter or not) → class
  for (const ltl::Proposition p : reads) {
    const auto ours = letters.vocabulary().find(vocabulary.name(p));
    if (!ours && unknown == UnknownProposition::NeverHolds) continue;
    if (!ours) throw unknown_proposition(owner, letters.vocabulary(), vocabulary.name(p));
    refined.assign(representatives_.size(), {none, none});
    std::vector<ltl::Letter> representatives;
    for (std::size_t i = 0; i < class_.size(); ++i) {
      const bool carried = letters.all()[i].contains(*ours);
      std::uint32_t& target = refined[class_[i]][carried ? 1 : 0];
      if (target == none) {
        target = static_cast<std::uint32_t>(representatives.size());
        representatives.push_back(representatives_[class_[i]]);
        if (carried) representatives.back().insert(p);
      }
      class_[i] = target;
    }
    representatives_ = std::move(representatives);
  }
}

std::vector<ltl::Letter> as_read(const std::vector<ltl::Letter>& letters, const ltl::Vocabulary& from,
                                 const ltl::Vocabulary& to, const std::vector<ltl::Proposition>& reads) {
  std::vector<std::optional<ltl::Proposition>> theirs;
  for (const ltl::Proposition p : reads) theirs.push_back(from.find(to.name(p)));
  std::vector<ltl::Letter> out;
  for (const ltl::Letter& letter : letters) {
    ltl::Letter& read = out.emplace_back();
    for (std::size_t v = 0; v < reads.size(); ++v)
      if (theirs[v] && letter.contains(*theirs[v])) read.insert(reads[v]);
  }
  return out;
}

}  // namespace waymark::plan
