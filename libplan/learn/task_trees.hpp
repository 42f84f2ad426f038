// The formula that each state of an automaton stands for, as a tree of symbols: what a network reads of the task.
//
// The formula of a state is what progression leaves of φ along a shortest word that the model can write to that state,
// simplified. States that no word of the model leads to are represented by `false`; no trajectory reaches them.
#pragma once
#include <optional>
#include <vector>

#include "libltl/formula.hpp"
#include "libneural/recursive_encoder.hpp"
#include "libplan/learn/task_rows.hpp"

namespace waymark::plan {

struct TaskTrees {
  std::vector<neural::Index> slots;       // by symbol: its different operands, as RecursiveEncoder asks
  std::vector<neural::SymbolNode> nodes;  // subformulas, shared, operands before operators
  std::vector<neural::Index> root;        // by task: its formula
};

// By task: its formula; nullopt where no word leads. The table is that of φ's automaton.
std::vector<std::optional<ltl::Formula>> formulas_of(const TaskRows& table, ltl::Formula phi);

TaskTrees trees_of(const TaskRows& table, ltl::Formula phi);  // nodes are shared between states

}  // namespace waymark::plan
