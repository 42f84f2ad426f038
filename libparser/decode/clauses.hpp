// Sentences longer than those that were learned from: read as a whole, and clause by clause.
//
//   p(z | sentence) = ½ p_reader(z | sentence) + ½ max over ways to cut it into parts, and z into z₁ … zₙ, of Π p_reader(zᵢ | part i)
// A part is up to four neighbouring clauses (token.hpp) and does not begin with "otherwise", which goes on with what "if" began; the reader
// is asked about each as if it were the sentence, the programs are joined by `then`. What a reader never learned, where a program
// of seven steps ends, it need not know. With one clause, p is the reader's.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "libparser/decode/best_first.hpp"

namespace waymark::parser {

// The likeliest programs of a sentence, at most so many, the likeliest first.
using ReadSentence = std::function<std::vector<Candidate>(const SentenceInput&, std::size_t beam)>;

// The programs of p, the likeliest first, at most `beam`; of parts and beginnings only the 16 likeliest are kept, or `beam`, and programs of more
// steps than 120 are not made. Probabilities need not sum to 1. O(clauses · 4) readings.
std::vector<Candidate> read_by_clauses(const ReadSentence& read, const SentenceInput& input,
                                       std::size_t beam);

}  // namespace waymark::parser
