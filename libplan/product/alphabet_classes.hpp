// The letters of a model as an automaton sees them: letters that differ only in what it does not read are one class.
#pragma once
#include <cstdint>
#include <vector>

#include "libplan/world/letters.hpp"

namespace waymark::plan {

struct LetterClasses {
  std::vector<std::uint32_t> of;             // by letter of the model
  std::vector<ltl::Letter> representatives;  // by class, over the automaton's vocabulary
};

// Propositions are matched by name; those that the model does not know never hold. O(letters · |reads|).
LetterClasses letter_classes(const Letters& letters, const ltl::Vocabulary& vocabulary,
                             const std::vector<ltl::Proposition>& reads);

// Letters over one vocabulary as an automaton over another one reads them.
std::vector<ltl::Letter> as_read(const std::vector<ltl::Letter>& letters, const ltl::Vocabulary& from,
                                 const ltl::Vocabulary& to, const std::vector<ltl::Proposition>& reads);

}  // namespace waymark::plan
