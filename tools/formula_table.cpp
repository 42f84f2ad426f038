#include "tools/formula_table.hpp"

#include <iomanip>
#include <iostream>

#include "libparser/corpus/token.hpp"
#include "libparser/rerank/decide.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

Json share_json(const parser::FormulaShare& share) {
  return JsonObject()
      .add("same", share.same.value())
      .add("equivalent", share.equivalent.value())
      .add("n", share.same.total);
}

void print_row(const std::string& name, const parser::FormulaShare& share) {
  std::cout << std::left << std::setw(14) << name << std::right << std::setw(10) << fixed(share.same.value(), 2)
            << std::setw(12) << fixed(share.equivalent.value(), 2) << std::setw(8) << share.same.total << '\n';
}

}  // namespace

Json formulas_json(const parser::FormulaScores& scores) {
  JsonObject constructs, lengths;
  for (const auto& [name, share] : scores.by_construct) constructs.add(name, share_json(share));
  for (const auto& [length, share] : scores.by_length) lengths.add(std::to_string(length), share_json(share));
  return JsonObject()
      .add("same", scores.all.same.value())
      .add("equivalent", scores.all.equivalent.value())
      .add("n", scores.all.same.total)
      .add("by_construct", constructs)
      .add("by_length", lengths);
}

void print_formulas(const parser::FormulaScores& scores) {
  if (scores.all.same.total == 0) return;
  std::cout << "\nformulas, per cent\nconstruct           same  equivalent       n\n";
  for (const auto& [name, share] : scores.by_construct) print_row(name, share);
  for (const auto& [length, share] : scores.by_length)
    print_row(std::to_string(length) + (length == 1 ? " unit" : " units"), share);
  print_row("all", scores.all);
}

ExitCode evaluate_pairs(const PairsExperiment& experiment, const Session& session) {
  const parser::Grounder grounder = read_model(experiment.model, experiment.data);
  const ltl::Vocabulary& vocabulary = grounder.ranking->language.vocabulary();
  const parser::Annotations annotations = parser::parse_annotations(
      read_file(experiment.pairs), vocabulary, parser::Dialect::Temporal, source_name(experiment.pairs));
  report_refused(annotations, experiment.pairs);
  parser::FormulaJudge judge(vocabulary, parser::Dialect::Temporal);
  for (const parser::Annotation& pair : annotations.pairs) {
    if (session.stop.stop_requested()) throw Interrupted();
    const auto programs =
        parser::likely_programs(grounder, {parser::tokenize(pair.text), false}, {.clauses = experiment.clauses});
    judge.judge(pair.formula, programs.empty() ? parser::Program{} : programs.front().program);
  }
  if (experiment.json)
    std::cout
        << JsonObject().add("formulas", formulas_json(judge.scores())).add("refused", annotations.refused.size()).text()
        << '\n';
  else
    print_formulas(judge.scores());
  return ExitCode::Done;
}

void report_refused(const parser::Annotations& annotations, const std::string& file) {
  for (const auto& [line, reason] : annotations.refused)
    std::cerr << source_name(file) << ':' << line << ": " << reason << '\n';
}

}  // namespace waymark::tools
