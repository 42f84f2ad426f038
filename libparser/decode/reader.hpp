// Whoever reads a sentence: the likeliest programs, best first.
#pragma once
#include <memory>
#include <vector>

#include "libparser/model/features.hpp"
#include "libparser/model/linear_model.hpp"
#include "libparser/programs/program.hpp"

namespace waymark::parser {

struct Candidate {
  Program program;
  double log_probability = 0;
};

class Reader {
 public:
  virtual ~Reader() = default;
  // At most `beam` programs, the likeliest first. The same answer whenever it is asked; from several threads too.
  virtual std::vector<Candidate> read(const SentenceInput& input, std::size_t beam) const = 0;
};

// A reader, and what else is learned with it: the words, the lexicon's columns and the reranker are the model's.
struct Grounder {
  std::shared_ptr<const Reader> reader;
  std::shared_ptr<const LinearModel> model;
};

}  // namespace waymark::parser
