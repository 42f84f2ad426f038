// How many commands are read as they are labelled: trained on some, tested on others.
#pragma once
#include <array>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "libparser/domain/commands/command_examples.hpp"
#include "libparser/domain/commands/command_reader.hpp"

namespace waymark::parser {

struct CommandScore {
  std::size_t exact = 0, equivalent = 0, n = 0;  // the same formula; the same language over infinite words
  double percent(std::size_t count) const {
    return n > 0 ? 100.0 * static_cast<double>(count) / static_cast<double>(n) : 0;
  }
};

struct CommandAnswer {
  const Command* command = nullptr;
  std::string formula;  // empty: none
  double probability = 0;
  bool exact = false, equivalent = false;
};

// How well probabilities agree with how often answers are right, in ten bins of equal width [GPSW17, Sec. 2].
struct Calibration {
  struct Bin {
    std::size_t n = 0, right = 0;
    double probability = 0;  // the sum of the bin
  };
  std::array<Bin, 10> bins;

  void add(double probability, bool right);
  // Σ over bins of (n / all) · |share right − mean probability|; 0 when there are no answers.
  double expected_error() const;
};

struct CommandScores {
  CommandScore all;
  std::map<std::string, CommandScore> by_type, by_domain;
  std::vector<CommandAnswer> answers;
};

CommandScores score_commands(const LiftedReader& reader, std::span<const Command> commands, CommandDomains& domains,
                             const ReadCommandOptions& options);

// What is tested, and what is left to learn from: the rows of the fold are tested; with commands made from others
// (`from`) those are tested whose origin is in the fold.
struct CommandSplit {
  std::vector<Command> training, test;
  bool new_kinds = false;  // the test asks for templates or sizes that training lacks
};
CommandSplit split_commands(std::vector<Command> commands, std::vector<Command> others,
                            const std::set<std::string>& fold);

struct CommandsExperiment {
  std::vector<std::string> synonyms;  // groups
  bool doubted = false;               // learn from labels that may be doubted too
  OwnCommands own;
  LiftedTraining network;
  std::size_t networks = 3;
  std::function<void(double)> progress;
};
// Where the test has new kinds, domains are not told: what was said of a domain is then no reason against a kind.
LiftedReader train_commands(const CommandSplit& split, CommandDomains& domains, const SynchronousGrammar& grammar,
                            const std::shared_ptr<const WordVectors>& vectors, const CommandsExperiment& how);

}  // namespace waymark::parser
