// All small formulas and words, random larger ones, and how to show a failing pair.
//
// Laws are tested exhaustively on small inputs first, then on seeded random larger ones. What `show` prints can be
// pasted: a formula into parse(), a word into the words of the message.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/word.hpp"

namespace waymark::testing {

struct FormulaSpace {
  std::size_t size = 4;   // nodes of the syntax tree, at most, as stored (F a counts 3: true U a)
  std::size_t atoms = 2;  // a, b, c, …
  bool past = false;      // Y and S too
};
struct WordSpace {
  std::size_t length = 3;  // letters, at most; of a lasso |u| + |v|
  std::size_t atoms = 2;
};

// Names a, b, c, …; every formula and word here speaks of the first `atoms` of them.
ltl::Vocabulary letters_vocabulary(std::size_t atoms);

// Every formula made of at most `size` operators, constants and atoms in the arena, each distinct formula once,
// smaller ones first. The arena's first `atoms` propositions are used, and added when it has none.
std::vector<ltl::Formula> all_formulas(ltl::Arena& arena, const FormulaSpace& space);
std::vector<ltl::Trace> all_traces(const WordSpace& space);
std::vector<ltl::Lasso> all_lassos(const WordSpace& space);

template <class Function>
void for_each_formula(ltl::Arena& arena, const FormulaSpace& space, Function&& fn) {
  for (ltl::Formula f : all_formulas(arena, space)) fn(f);
}
template <class Function>
void for_each_trace(const WordSpace& space, Function&& fn) {
  for (const ltl::Trace& word : all_traces(space)) fn(word);
}
template <class Function>
void for_each_lasso(const WordSpace& space, Function&& fn) {
  for (const ltl::Lasso& word : all_lassos(space)) fn(word);
}

// "parse: a U N b   word: {a}; {b}" with the seed when there is one.
std::string show(ltl::Formula f);
std::string show(ltl::Formula f, const ltl::Trace& word);
std::string show(ltl::Formula f, const ltl::Lasso& word);

}  // namespace waymark::testing
