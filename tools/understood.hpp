// What is said of texts and formulas in English: how a text was understood, and that it was not.
#pragma once
#include <string>

#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libparser/grounding/understand.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

// "go to the chair; never step on blue": from the formula, not from the text.
std::string in_english(ltl::Formula formula, ltl::Semantics semantics, const plan::Map& map);
// Of propositions without a map: by their names.
std::string in_english(ltl::Formula formula, ltl::Semantics semantics);

std::string not_understood_message(const std::string& text, const parser::Understanding& understood);
JsonObject not_understood_json(const std::string& text, const std::string& map,
                               const parser::Understanding& understood);

}  // namespace waymark::tools
