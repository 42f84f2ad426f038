// The letters of a model as an automaton reads them: letters that the automaton cannot tell apart form one class.
//
// Propositions are matched by name. A model may lack a proposition that the automaton reads; the caller says what
// follows: the task is refused (maps and learners: a misspelt name), or the proposition never holds (planning cases: a
// model file lists only what occurs).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "libplan/world/letters.hpp"

namespace waymark::plan {

enum class UnknownProposition : std::uint8_t { Refuse, NeverHolds };  // what follows when the model lacks it

class AlphabetClasses {
 public:
  AlphabetClasses() = default;  // of no letters
  // Throws ltl::FormatError under Refuse, naming the proposition and the owner of the letters. O(letters · |reads|).
  AlphabetClasses(const Letters& letters, const ltl::Vocabulary& vocabulary, const std::vector<ltl::Proposition>& reads,
                  UnknownProposition unknown, const std::string& owner = "the model");

  std::size_t size() const { return representatives_.size(); }
  std::uint32_t of(LetterId letter) const { return class_[letter.index]; }  // the class of a letter
  // By class, in order of first occurrence: the letter over the automaton's vocabulary.
  const std::vector<ltl::Letter>& representatives() const { return representatives_; }

 private:
  std::vector<std::uint32_t> class_;  // by letter of the model
  std::vector<ltl::Letter> representatives_;
};

// Letters over one vocabulary as an automaton over another one reads them; unknown propositions never hold.
std::vector<ltl::Letter> as_read(const std::vector<ltl::Letter>& letters, const ltl::Vocabulary& from,
                                 const ltl::Vocabulary& to, const std::vector<ltl::Proposition>& reads);

}  // namespace waymark::plan
