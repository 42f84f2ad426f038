// The check of a finite word against a task of a planning case: by the definition, not by the automaton that found it.
#pragma once
#include "libautomata/finite/dfa.hpp"
#include "libltl/formula.hpp"
#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"
#include "libplan/model/formats/read_case.hpp"

namespace waymark::plan {

// The finite word satisfies f, and so, of a co-safe f without X, does all that begins with it. Of another good prefix
// the word that stands still in its last letter is tried. Letters and formula are over one vocabulary. Throws
// std::logic_error when the check fails.
void certify_word(const ltl::Trace& word, ltl::Formula f, CaseTask::Logic logic);

// Where the task came as an automaton: a run of it, on letters over another vocabulary. Throws as above.
void certify_word(const ltl::Trace& word, const ltl::Vocabulary& vocabulary, const automata::Dfa& dfa);

}  // namespace waymark::plan
