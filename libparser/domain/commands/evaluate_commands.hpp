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
  double percent(std::size_t count) const {      // of n
    return n > 0 ? 100.0 * static_cast<double>(count) / static_cast<double>(n) : 0;
  }
};

struct CommandAnswer {                     // one answer of a test
  const Command* command = nullptr;        // that was asked
  std::string formula;                     // empty: none
  double probability = 0;                  // of the formula
  bool exact = false, equivalent = false;  // as in CommandScore
};

// How well probabilities agree with how often answers are right, in ten bins of equal width [GPSW17, Sec. 2].
struct Calibration {
  struct Bin {                     // answers of like probability
    std::size_t n = 0, right = 0;  // answers, and those that are right
    double probability = 0;        // the sum of the bin
  };
  std::array<Bin, 10> bins;  // of equal width

  void add(double probability, bool right);  // one answer
  // Σ over bins of (n / all) · |share right − mean probability|; 0 when there are no answers.
  double expected_error() const;
};

struct CommandScores {                                     // of a test
  CommandScore all;                                        // commands together
  std::map<std::string, CommandScore> by_type, by_domain;  // kinds and domains
  std::vector<CommandAnswer> answers;                      // in the order of the commands
};

// Reads every command.
CommandScores score_commands(const LiftedReader& reader, std::span<const Command> commands, CommandDomains& domains,
                             const ReadCommandOptions& options);

// What is tested, and what is left to learn from: the rows of the fold are tested; with commands made from others
// (`from`) those are tested whose origin is in the fold.
struct CommandSplit {
  std::vector<Command> training, test;  // without commands of the fold; of the fold
  bool new_kinds = false;               // the test asks for templates or sizes that training lacks
};
// The fold names rows of the commands; others are always learned from.
CommandSplit split_commands(std::vector<Command> commands, std::vector<Command> others,
                            const std::set<std::string>& fold);

struct CommandsExperiment {              // what is learned from, and how
  std::vector<std::string> synonyms;     // groups
  bool doubted = false;                  // learn from labels that may be doubted too
  OwnCommands own;                       // commands of our own
  LiftedTraining network;                // of each network
  std::size_t networks = 3;              // that vote
  std::function<void(double)> progress;  // called with the share that is done
};
// Where the test has new kinds, domains are not told: what was said of a domain is then no reason against a kind.
LiftedReader train_commands(const CommandSplit& split, CommandDomains& domains, const SynchronousGrammar& grammar,
                            const std::shared_ptr<const WordVectors>& vectors, const CommandsExperiment& how);

}  // namespace waymark::parser
