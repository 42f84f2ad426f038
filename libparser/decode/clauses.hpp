// The reading of sentences that are longer than those of training: as a whole, and clause by clause.
//
//   p(z | sentence) = ½ p_reader(z | sentence) + ½ max Π p_reader(zᵢ | part i)
// The maximum is over the ways to cut the sentence into parts and z into z₁ … zₙ. A part is up to four neighbouring
// clauses (token.hpp). A part does not begin with "otherwise", which continues what "if" began. The reader reads each
// part like a sentence, and `then` joins the programs. With one clause, p is the reader's.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "libparser/decode/best_first.hpp"

namespace waymark::parser {

// The likeliest programs of a sentence, at most so many, the likeliest first.
using ReadSentence = std::function<std::vector<Candidate>(const SentenceInput&, std::size_t beam)>;

// The programs of p, the likeliest first, at most `beam`; of parts and beginnings only the 16 likeliest are kept, or
// `beam`, and programs of more steps than 120 are not made. Probabilities need not sum to 1. O(clauses · 4) readings.
std::vector<Candidate> read_by_clauses(const ReadSentence& read, const SentenceInput& input, std::size_t beam);

}  // namespace waymark::parser
