// The lexical-overlap penalty: how far a sentence and a program name different things.
//
// Many programs lead where a sentence leads; the right one usually names what the sentence names. The penalty counts
// the things that only one of the two names, as far as the lexicon knows them: objects, floors, paintings, kinds of
// places, left and right, numbers. The penalty is a prior: learning sees no formula.
#pragma once
#include <cstdint>
#include <vector>

#include "libparser/model/program_language.hpp"
#include "libparser/programs/program.hpp"

namespace waymark::parser {

class Wording {  // computes the penalty for one sentence
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
