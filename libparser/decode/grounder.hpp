// All that grounding needs of a model, and how it reads a sentence.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "libparser/decode/best_first.hpp"
#include "libparser/lifted/lifted_reader.hpp"
#include "libparser/model/ranking_model.hpp"
#include "libparser/model/word_model.hpp"

namespace waymark::parser {

struct Grounder {
  WordModel word_model;                                    // that reads programs
  std::shared_ptr<const RankingModel> ranking;             // and the language that both speak
  std::shared_ptr<const LiftedReader> commands = nullptr;  // reads temporal words and named places; may be absent
};

// At most `beam` programs, the likeliest first. The same answer whenever it is asked; from several threads too.
std::vector<Candidate> read(const WordModel& model, const SentenceInput& input, std::size_t beam);

// A linear model without weights of rerankers.
Grounder grounder_of(LinearModel model);

}  // namespace waymark::parser
