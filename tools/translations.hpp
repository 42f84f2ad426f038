// The translations that `waymark translate` offers, one row each: semantics, target, function.
#pragma once
#include <span>
#include <string_view>
#include <variant>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"

namespace waymark::tools {

using Translated = std::variant<automata::Dfa, automata::Translated, automata::TranslatedForMdps, automata::Exhausted>;

struct Translation {
  std::string_view semantics;  // "finite" or "infinite"
  std::string_view target;     // --to
  Translated (*run)(ltl::Formula, const ltl::Limits&);
};

std::span<const Translation> translations();

// The row of these names; an empty name is settled by the other one: dfa goes with finite words, finite words with dfa,
// all else is about infinite words, which go with tgba. Throws UsageError naming the targets that there are.
const Translation& find_translation(std::string_view semantics, std::string_view target);

}  // namespace waymark::tools
