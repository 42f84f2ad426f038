// The phrases of English for formulas: one table for writing and for reading.
//
// A phrase pairs a sentence with a formula. The letters in braces stand for parts, by what may stand there:
//   s r  a state clause: a Boolean combination of literals, at most two levels deep
//   x y  a state clause, or any formula by a letter of its own, "(A) holds"
//   l    a literal                               t u  any formula, to the end of the phrase
//   v    a place to go to, "go to the chair"     c    any formula, up to what follows
//   e    an action that is forbidden             a    an action, "turn left"
// A verbalisation uses the first phrase whose formula matches, so special phrases stand before general ones.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// What may stand for a letter.
enum class Slot : std::uint8_t { State, LooseState, Literal, Visit, Enter, Act, Closed, Tail };
Slot slot_of(char letter);  // by the table above

// What stands for each letter, and for n.
struct Bindings {
  std::array<std::optional<Formula>, 26> parts;  // by letter, a … z; nothing where the letter does not occur
  std::size_t n = 0;                             // of counted phrases
  std::optional<Formula>& operator[](char letter) { return parts[static_cast<std::size_t>(letter - 'a')]; }
  const std::optional<Formula>& operator[](char letter) const { return parts[static_cast<std::size_t>(letter - 'a')]; }
};

struct Phrase {
  std::string_view english;  // "whenever {x}, {t}"
  Formula formula;           // over an arena whose propositions are a … z
};
std::span<const Phrase> phrases();  // the table, special phrases first

// Phrases with a number n: the formula is made, not matched.
struct CountedPhrase {
  std::string_view english;                           // "{n} steps later {t}"
  Formula (*formula)(Arena& arena, const Bindings&);  // of n ≥ 1 and the parts
  std::optional<Bindings> (*recognise)(Formula f);    // n and the parts of f
};
std::span<const CountedPhrase> counted_phrases();  // the table of phrases with a number

}  // namespace waymark::ltl
