#include "libplan/learn/task_trees.hpp"

#include <map>
#include <unordered_map>

#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/simplify.hpp"

namespace waymark::plan {
namespace {

using neural::Index;

// Symbols: one for each operator, in the order of Op, then one for each proposition of the task.
constexpr Index operators = static_cast<Index>(ltl::Op::Since) + 1;

// The number of operand positions that the network distinguishes: 2 where the order of operands matters, 1 where all
// operands play the same part.
Index operands_told_apart(ltl::Op op) {
  switch (op) {
    case ltl::Op::False:
    case ltl::Op::True:
    case ltl::Op::Atom: return 0;
    case ltl::Op::Not:
    case ltl::Op::And:
    case ltl::Op::Or:
    case ltl::Op::Iff:
    case ltl::Op::Next:
    case ltl::Op::WeakNext:
    case ltl::Op::Yesterday: return 1;
    case ltl::Op::Until:
    case ltl::Op::Since:
    case ltl::Op::Release: return 2;
  }
  return 0;  // unreachable: -Werror=switch
}

// Adds formulas to `out`, each subformula once.
class Trees {
 public:
  explicit Trees(ltl::Formula phi) {
    for (Index op = 0; op < operators; ++op) out.slots.push_back(operands_told_apart(static_cast<ltl::Op>(op)));
    for (const ltl::Proposition p : ltl::propositions(phi)) {
      atoms_.emplace(p, static_cast<Index>(out.slots.size()));
      out.slots.push_back(0);
    }
  }

  Index node_of(ltl::Formula f) {
    for (const ltl::Formula g : ltl::subformulas(f)) {
      if (node_.contains(g)) continue;
      neural::SymbolNode node{g.op() == ltl::Op::Atom ? atoms_.at(g.proposition()) : static_cast<Index>(g.op())};
      for (std::size_t i = 0; i < g.operands().size(); ++i)
        node.children.push_back({node_.at(g[i]), operands_told_apart(g.op()) == 2 ? static_cast<Index>(i) : 0});
      node_.emplace(g, static_cast<Index>(out.nodes.size()));
      out.nodes.push_back(std::move(node));
    }
    return node_.at(f);
  }

  TaskTrees out;

 private:
  std::map<ltl::Proposition, Index> atoms_;
  std::unordered_map<ltl::Formula, Index> node_;
};

}  // namespace

std::vector<std::optional<ltl::Formula>> formulas_of(const TaskRows& table, ltl::Formula phi) {
  std::vector<std::optional<ltl::Formula>> formula(table.tasks);
  formula[table.initial] = phi;
  std::vector<std::uint32_t> queue{table.initial};
  for (std::size_t head = 0; head < queue.size(); ++head)
    for (std::uint32_t letter = 0; letter < table.letters; ++letter) {
      const std::uint32_t next = table.after(queue[head], letter);
      if (formula[next]) continue;
      formula[next] =
          ltl::simplify(ltl::progress(*formula[queue[head]], table.classes.representatives()[letter]), ltl::Over::Rest);
      queue.push_back(next);
    }
  return formula;
}

TaskTrees trees_of(const TaskRows& table, ltl::Formula phi) {
  Trees trees(phi);
  for (const auto& formula : formulas_of(table, phi))
    trees.out.root.push_back(trees.node_of(formula.value_or(phi.arena().constant(false))));
  return std::move(trees.out);
}

}  // namespace waymark::plan
