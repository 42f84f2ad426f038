// The most probable programs of a sentence, best first, exactly.
//
// p(prefix) bounds p(every completion), so taking the likeliest open prefix first yields complete programs in order
// of probability; the beam is the number of complete programs wanted. Only well-typed prefixes are ever made.
#pragma once
#include <cstddef>
#include <vector>

#include "libparser/decode/reader.hpp"
#include "libparser/model/scorer.hpp"

namespace waymark::parser {

// At most `beam` programs, none of probability below e⁻¹²; fewer when `expansions` prefixes did not suffice. Deterministic: ties by order of making.
std::vector<Candidate> best_programs(Scorer& scorer, const PostfixGrammar& grammar, std::size_t beam,
                                     std::size_t expansions = 2000);

class LinearReader : public Reader {
 public:
  explicit LinearReader(std::shared_ptr<const LinearModel> model) : model_(std::move(model)) {}
  std::vector<Candidate> read(const SentenceInput& input, std::size_t beam) const override;

  const LinearModel& model() const { return *model_; }

 private:
  std::shared_ptr<const LinearModel> model_;
};

// One linear model of the reader's weights and the reranker's, as it is saved.
// Throws std::invalid_argument when the reader is of another kind.
LinearModel linear_model_of(const Grounder& grounder);

// The linear model as reader and reranker in one.
Grounder grounder_of(LinearModel model);

}  // namespace waymark::parser
