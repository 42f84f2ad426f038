// One vector for each node of a directed acyclic graph of symbols, computed from the vectors of its children: the input
// of a network for a formula or any other tree.
//
//   h(v) = max(0, b[symbol] + Σ over children u of W[symbol, slot(u)] h(u))        h [width × nodes]
// A slot says which operand a child is. Operands without an order share one slot, in any number. Shared nodes are
// computed once. After [SLNM11], with sums for commutative operators.
#pragma once
#include <span>
#include <vector>

#include "libneural/parameters.hpp"

namespace waymark::neural {

struct SymbolNode {  // a node of the graph, after its children
  struct Child {     // an edge to an operand
    Index node = 0;  // stands before its parent
    Index slot = 0;  // which operand the child is
  };
  Index symbol = 0;                  // less than the number of symbols
  std::vector<Child> children = {};  // the operands
};

class RecursiveEncoder {
 public:
  // slots: by symbol, how many different operands it has; 0 for a leaf.
  RecursiveEncoder(Parameters& parameters, Index width, std::span<const Index> slots, const Uniform& uniform);
  Index width() const { return bias_.rows; }

  // h has a column for each node.
  void forward(const Parameters& parameters, std::span<const SymbolNode> nodes, Matrix& h) const;
  // After `forward`: dh holds ∂h of the nodes that are read outside, and is completed from parents to children on the
  // way; adds to the gradients of the parameters.
  void backward(Parameters& parameters, std::span<const SymbolNode> nodes, const Matrix& h, Matrix& dh) const;

 private:
  const Block& weight(Index symbol, Index slot) const {
    return weights_[first_[static_cast<std::size_t>(symbol)] + static_cast<std::size_t>(slot)];
  }
  Block bias_;                      // [width × symbols]
  std::vector<Block> weights_;      // [width × width], by symbol and slot
  std::vector<std::size_t> first_;  // by symbol: where its weights begin
};

}  // namespace waymark::neural
