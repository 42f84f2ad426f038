// The most probable programs of a sentence, best first, exactly.
//
// p(prefix) bounds p(every completion), so taking the likeliest open prefix first yields complete programs in order
// of probability; the beam is the number of complete programs wanted. Only well-typed prefixes are ever made.
#pragma once
#include <cstddef>
#include <vector>

#include "libparser/scorer.hpp"

namespace waymark::parser {

struct Candidate {
  Program program;
  double log_probability = 0;
};

// At most `beam` programs, none of probability below e⁻¹²; fewer when `expansions` prefixes did not suffice. Deterministic: ties by order of making.
std::vector<Candidate> best_programs(Scorer& scorer, const PostfixGrammar& grammar, std::size_t beam,
                                     std::size_t expansions = 2000);

}  // namespace waymark::parser
