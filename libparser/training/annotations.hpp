// Sentences with their formulas: the same models, learned with supervision.
//
// A formula is recognised as a program (recognise.hpp), and the model maximises the log-probability of its tokens: the
// cross-entropy that marginal likelihood becomes when a sentence has a single consistent program.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "libparser/training/learn.hpp"

namespace waymark::parser {

struct Annotation {
  std::string text;      // the sentence
  Program program;       // that denotes the formula
  std::string formula;   // as it stands in the file
  std::size_t line = 0;  // counts from 1
};

struct Annotations {              // the lines of a file
  std::vector<Annotation> pairs;  // that are learned from
  struct Refused {                // a line that is left out
    std::size_t line;             // from 1
    std::string reason;           // in words
  };
  std::vector<Refused> refused;  // lines whose formula is none, or no program of the dialect
};

// Lines `sentence TAB formula`; blank ones and those that begin with # are skipped. Throws ltl::FormatError with the
// line that has no tab or no sentence.
Annotations parse_annotations(std::string_view text, const ltl::Vocabulary& vocabulary, Dialect dialect,
                              std::string_view source = "");

// Programs over the map's vocabulary. Without a reranker: there is no trajectory to choose by. Throws
// std::invalid_argument when there is no pair; Stopped when a stop was requested.
Grounder train_supervised(const std::vector<Annotation>& pairs, const plan::Map& map, TrainOptions options);

}  // namespace waymark::parser
