// Route instructions of our own, with the trajectories that planning gives them: a corpus for tests and for training
// where no other is at hand. Every sentence also has the formula it was said of, kept aside for scores.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "libparser/corpus/corpus.hpp"
#include "libparser/language/judge.hpp"
#include "libparser/language/route_language.hpp"

namespace waymark::parser {

// Which formulas: all, or one side of a split that is the same for every seed. One formula in five is held out.
enum class Formulas : std::uint8_t { All, Known, HeldOut };

struct GenerateOptions {                            // what is drawn
  std::uint64_t seed = 1;                           // of all that is drawn
  std::size_t paragraphs = 100;                     // spread over the maps
  std::size_t sentences = 4;                        // of each paragraph
  Dialect dialect = Dialect::Plain;                 // of the programs
  std::size_t least_clauses = 1, most_clauses = 2;  // of a sentence
  Formulas formulas = Formulas::All;
  JudgedLimits judged = {};  // trajectories beside that of each sentence (judge.hpp)
};

// Sentences of route_language.hpp that can be carried out where the speaker stands; trajectories are the programs'
// plans, checked against the definition: their words satisfy the formulas. Headings are known. Same seed, same corpus.
// Where nothing more can be said (a paragraph that ends in a corner of a split) a paragraph has fewer sentences.
// Throws std::invalid_argument when the maps do not share a vocabulary, or it lacks what sentences speak of.
Corpus generate_corpus(std::span<const plan::Map> maps, const GenerateOptions& options = {});

// What is learned from where no corpus is named: up to three clauses, one formula in five held out.
inline constexpr GenerateOptions own_language{.seed = 1,
                                              .paragraphs = 600,
                                              .sentences = 4,
                                              .dialect = Dialect::Temporal,
                                              .least_clauses = 1,
                                              .most_clauses = 3,
                                              .formulas = Formulas::Known,
                                              .judged = {}};

}  // namespace waymark::parser
