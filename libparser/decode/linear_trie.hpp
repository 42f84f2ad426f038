// A trie of programs under the linear model: the marginal likelihood of its programs and the gradient of it.
//
//   value(node) = log Σ_child exp(log p(token | node) + value(child)),   value(leaf) = log weight of the program
// A sentence has a few hundred consistent programs and about as many prefixes.
#pragma once
#include <vector>

#include "libparser/decode/trie.hpp"
#include "libparser/model/scorer.hpp"

namespace waymark::parser {

using LinearTrie = ProgramTrie<LinearPrefix>;  // with the prefixes of the linear model

// Room for one pass; keep it to save allocations.
struct TrieScratch {
  std::vector<float> log_p;               // [nodes × tokens]
  std::vector<float> value, mass, delta;  // by node
  std::vector<Scorer::GroupIds> groups;   // by node: its rows of weights
};

// log Σ_z weight(z) p(z | x); its gradient goes to the scorer, which must have begun this sentence.
double accumulate_gradient(const LinearTrie& trie, Scorer& scorer, TrieScratch& scratch);

}  // namespace waymark::parser
