// The runs of a comparison: exact methods and learners on one task, and on a suite of tasks, by one protocol.
//
// Where a task comes from (a map, a planning case) is the business of compare.cpp; how answers look, that of
// comparing.hpp.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "libplan/learn/comparison.hpp"
#include "tools/comparing.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct CompareChoice {
  std::vector<std::string> methods;
  Protocol protocol;
  std::string svg;
  int threads = 0;  // one for each core
  bool json = false;
};

class Comparison {
 public:
  // Both must outlive it. Throws UsageError for a method that does not exist.
  Comparison(const CompareChoice& choice, const Session& session);

  plan::LearningTaskOptions task_options() const;  // the discount, and what the chosen methods need

  // What is said of the task beforehand is in `compared`, with the exact search where there is one. Runs the learners,
  // prints the answer, and draws it where it is the only one. Throws std::logic_error when search and value iteration
  // disagree.
  ExitCode run(ComparedTask compared, const plan::LearningTask& task, bool is_single);
  void suite() const;  // all runs together
  std::size_t tasks() const { return tasks_; }

 private:
  void add_exact(ComparedTask& compared);
  void run_methods(ComparedTask& compared, const plan::LearningTask& task);
  void summarise(ComparedTask& compared, std::size_t method, std::span<const plan::LearningCurve> curves,
                 std::span<const double> seconds);
  void draw(const ComparedTask& compared) const;

  const CompareChoice& choice_;
  const Session& session_;
  std::vector<plan::Method> methods_;
  std::vector<std::vector<plan::Verdict>> verdicts_;       // by method, of all tasks
  std::array<std::vector<double>, 2> exact_seconds_ = {};  // of all tasks
  std::size_t tasks_ = 0;
};

}  // namespace waymark::tools
