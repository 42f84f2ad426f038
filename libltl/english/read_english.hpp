// English → formula: the inverse of verbalise (verbalise.hpp).
//
// Reads what verbalise writes with the same description of the propositions, and returns a formula of the same
// language. Any other text is refused. A text that could mean two formulas is refused as well, so nothing is guessed.
#pragma once
#include <optional>
#include <string_view>

#include "libltl/english/description.hpp"
#include "libltl/formula.hpp"

namespace waymark::ltl {

// The formula is over the vocabulary of the arena as it is. O(|text|² · phrases) at worst for usual texts.
std::optional<Formula> read_english(std::string_view text, Arena& arena, const VerbaliseOptions& options = {});

}  // namespace waymark::ltl
