// waymark compose of any model: what is written of the model alone, or of its product with a task.
#pragma once
#include <iosfwd>
#include <stop_token>
#include <string>

#include "libplan/solve/task_automaton.hpp"

namespace waymark::tools {

struct GraphOutput {
  std::string format = "text";  // text, json, dot, prism, explicit, jani, dimacs, pgsolver
  std::string out;              // a prefix of files
  bool graph = false;           // json: not only the sizes
  std::string svg = {};         // a file for the picture; empty: none
  // The whole model for another tool, one product at a time.
  bool writes_model() const {
    return format == "prism" || format == "explicit" || format == "jani" || format == "dimacs" || is_game();
  }
  bool is_game() const { return format == "pgsolver"; }
};

void write_model(const plan::PlanningCase& model, const GraphOutput& output, std::ostream& out);

// `task` and `formula` are shown beside the sizes when they are not empty. Throws Interrupted.
struct ProductTitle {
  std::string task, formula;
};
void write_product(const plan::PlanningCase& model, const plan::TaskAutomaton& automaton, const ProductTitle& title,
                   const GraphOutput& output, const std::stop_token& stop, std::ostream& out);

// The parity game of the formula, over infinite words, on the model. Throws Interrupted; GaveUp without an automaton.
void write_game(const plan::PlanningCase& model, ltl::Formula f, const GraphOutput& output, const std::stop_token& stop,
                std::ostream& out);

}  // namespace waymark::tools
