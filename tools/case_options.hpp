// What waymark plan --case and --model are told on the command line.
#pragma once
#include <cstddef>
#include <string>

#include "libplan/model/prism/read_prism.hpp"
#include "libplan/solve/least_lasso.hpp"
#include "tools/shell/command.hpp"
#include "tools/shell/parallel.hpp"

namespace waymark::tools {

struct CaseChoice {
  std::string file, task, method = "best";
  std::string model, query, automaton;  // --model; no query: pmax
  std::string strategy;                 // a file for it; empty: none
  std::string strategy_format = "waymark";
  std::string constants, rewards, properties;  // of a model in the language of PRISM
  std::string hierarchy;                       // of a model of roads: a file; "none"; empty: made after reading
  std::string scheduler;                       // a file to read: the model's choices; empty: they are free
  std::string order = "prefix";                // of lassos
  std::size_t top = 1;
  double discount = 0.9;
  double tolerance = 1e-6;
  std::string values_in;     // a folder for the values of large grids; empty: memory
  ParallelOptions parallel;  // formulas or tasks; limits of each of them, and of reading a model
  bool json = false;
};
plan::LassoOrder order_of(const std::string& name);          // `order` of a choice
plan::PrismConstants constants_of(const std::string& text);  // "N=3,p=0.5"; throws UsageError
void add_case_options(Command command, CaseChoice& choice);

}  // namespace waymark::tools
