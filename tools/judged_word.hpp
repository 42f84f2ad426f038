// A formula judged letter by letter on a word: what remains after each letter, and where all hope was lost.
//
// The verdict on the whole word is that of the definition of ⊨ and of nothing else. What every continuation shares is
// asked of monitors of the conjuncts (libautomata/monitor/conjunction.hpp).
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/read_word.hpp"

namespace waymark::tools {

// Of the word so far: no continuation satisfies the formula; it would if it ended here; neither.
enum class LetterVerdict : std::uint8_t { Lost, Open, Satisfied };

struct JudgedLetter {
  ltl::Formula remains;
  std::optional<LetterVerdict> verdict;  // absent: the automaton met its limit
};

struct JudgedWord {
  std::optional<bool> satisfied;      // absent: a word that goes on, and its continuations differ
  std::optional<std::size_t> lost;    // the first letter, counted from 0, after which no continuation satisfies it
  bool knows_loss = false;            // `lost` was looked for
  bool is_known_satisfiable = true;   // false: of some letter, whether a continuation satisfies it is not known
  std::vector<JudgedLetter> letters;  // with `each` only; of a lasso those of u and of v once
};

// semantics Infinite and a finite word: the beginning of an infinite word. Letters are over the vocabulary of f. With
// `each` what remains is worked out for every letter, and the loss is looked for; without it the loss of words that do
// not satisfy f alone. Throws Interrupted, GaveUp when what remains grows beyond 20,000 nodes.
JudgedWord judge(ltl::Formula f, const ltl::AnyWord& word, ltl::Semantics semantics, bool each,
                 const std::stop_token& stop);

}  // namespace waymark::tools
