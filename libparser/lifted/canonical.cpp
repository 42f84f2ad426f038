// One spelling for what is the same but for the order of operands or brackets.
#include <algorithm>
#include <stdexcept>

#include "libparser/lifted/lifted_symbol.hpp"

namespace waymark::parser {
namespace {

using enum LiftedSymbol;

struct Tree {
  LiftedSymbol symbol = End;
  std::vector<Tree> operands = {};
};

Tree tree_of(std::span<const LiftedSymbol> lifted, std::size_t& at) {
  const auto bad = [] { return std::invalid_argument("no complete lifted formula"); };
  if (at == lifted.size() || lifted[at] == End) throw bad();
  Tree tree{lifted[at++]};
  const std::size_t n = operands_of(tree.symbol);
  for (std::size_t i = 0; i < n; ++i) {
    if (n == any_number && at < lifted.size() && lifted[at] == End) {
      ++at;
      break;
    }
    tree.operands.push_back(tree_of(lifted, at));
  }
  return tree;
}

void append(const Tree& tree, Lifted& out) {
  out.push_back(tree.symbol);
  for (const Tree& operand : tree.operands) append(operand, out);
  if (operands_of(tree.symbol) == any_number) out.push_back(End);
}

Lifted spelled(const Tree& tree) {
  Lifted out;
  append(tree, out);
  return out;
}

bool is_unordered(LiftedSymbol s) { return s == And || s == Or || s == Visit || s == Patrol || s == Never; }

void normalise(Tree& tree) {
  for (Tree& operand : tree.operands) normalise(operand);
  std::vector<Tree> flat;
  for (Tree& operand : tree.operands) {
    const bool merges = operand.symbol == tree.symbol && (tree.symbol == And || tree.symbol == Or);
    if (merges)
      for (Tree& inner : operand.operands) flat.push_back(std::move(inner));
    else
      flat.push_back(std::move(operand));
  }
  tree.operands = std::move(flat);
  if (is_unordered(tree.symbol)) {
    const auto less = [](const Tree& a, const Tree& b) { return spelled(a) < spelled(b); };
    const auto same = [](const Tree& a, const Tree& b) { return spelled(a) == spelled(b); };
    std::sort(tree.operands.begin(), tree.operands.end(), less);
    tree.operands.erase(std::unique(tree.operands.begin(), tree.operands.end(), same), tree.operands.end());
  }
  if (tree.operands.size() != 1) return;
  if (tree.symbol == And || tree.symbol == Or) {
    Tree only = std::move(tree.operands.front());
    tree = std::move(only);
  } else if (tree.symbol == Visit || (tree.symbol == Sequence && !is_action(tree.operands.front().symbol))) {
    tree.symbol = Eventually;
  }
}

}  // namespace

Lifted canonical(std::span<const LiftedSymbol> lifted) {
  std::size_t at = 0;
  Tree tree = tree_of(lifted, at);
  if (at != lifted.size()) throw std::invalid_argument("symbols follow a complete lifted formula");
  normalise(tree);
  return spelled(tree);
}

}  // namespace waymark::parser
