// How far a sentence and a program speak of the same things.
//
// Many programs lead where a sentence leads; people expect to read the one that says what they said. A program disagrees
// with a sentence by the things that one of them names and the other does not, as far as the lexicon knows them: objects,
// floors, paintings, kinds of places, left and right, numbers. No formula is given to learn from: this is a prior.
#pragma once
#include <cstdint>
#include <vector>

#include "libparser/model/program_language.hpp"
#include "libparser/programs/program.hpp"

namespace waymark::parser {

class Wording {
 public:
  static constexpr double missing = 1.0;  // the sentence mentions it, the program does not name it
  static constexpr double added = 0.5;    // the program names it, the sentence does not mention it

  // mentions: of the sentence, SentenceFeatures::mentions. The language must outlive it.
  Wording(const ProgramLanguage& language, const std::vector<Part>& mentions);
  double lexical_overlap_penalty(const Program& program) const;  // ≥ 0; O(steps)

 private:
  std::vector<std::uint16_t> named_by(const Program& program) const;  // columns, sorted and unique

  const ProgramLanguage* language_;
  std::vector<std::vector<std::uint16_t>> topics_;  // what is mentioned, each by the columns that name it
  std::vector<bool> unsaid_;                        // columns of the lexicon that are not mentioned
  std::uint16_t left_, right_;                      // columns of the two sides, named by directions too
};

}  // namespace waymark::parser
