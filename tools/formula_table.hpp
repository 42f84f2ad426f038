// The share of formulas that were read as they were meant: as a table, as JSON, and for the pairs of a file.
#pragma once
#include <string>

#include "libparser/experiment/formula_scores.hpp"
#include "libparser/training/annotations.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

Json formulas_json(const parser::FormulaScores& scores);
void print_formulas(const parser::FormulaScores& scores);  // nothing when nothing was scored

// Lines whose formula is no program, on standard error, with file and line.
void report_refused(const parser::Annotations& annotations, const std::string& file);

// The model of a file, asked for the formula of every sentence of a file of pairs: text alone, no map.
struct PairsExperiment {
  std::string pairs;
  ModelOptions model;
  std::string data;
  bool json = false;
  bool clauses = true;  // sentences of several are also read clause by clause
};
ExitCode evaluate_pairs(const PairsExperiment& experiment, const Session& session);

}  // namespace waymark::tools
