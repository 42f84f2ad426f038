// A trie of programs under an encoder-decoder: log p of each program, and the gradient of any objective of these.
//
//   ∂ objective / ∂ score(node, v) = Σ_{leaves below (node, v)} g − p(v | node) Σ_{leaves below node} g
// where g is ∂ objective / ∂ log p(leaf).
#pragma once
#include <span>
#include <vector>

#include "libparser/decode/trie.hpp"
#include "libparser/model/network_scorer.hpp"

namespace waymark::parser {

using NetworkTrie = ProgramTrie<NetworkPrefix>;  // with the prefixes of an encoder-decoder

void append_histories(const NetworkTrie& trie, std::vector<History>& out);  // of all nodes, in order

struct Likelihoods {           // what the programs of a trie are worth
  std::vector<float> log_p;    // by program
  std::vector<float> symbols;  // by node and symbol
};
// From the scores of the nodes: columns [at, at + nodes).
Likelihoods likelihoods(const NetworkTrie& trie, const neural::Matrix& scores, neural::Index at,
                        const std::vector<bool>& forbidden);
// dscores, the same columns, from ∂ / ∂ log p of each program.
void backpropagate(const NetworkTrie& trie, const Likelihoods& likelihoods, std::span<const float> gradient,
                   neural::Matrix& dscores, neural::Index at);

}  // namespace waymark::parser
