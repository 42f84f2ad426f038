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
#include "libparser/domain/commands/marked_commands.hpp"
#include "libparser/lifted/learn_matcher.hpp"

namespace waymark::parser {

struct CommandScore {                            // counts of commands that were read as labelled
  std::size_t exact = 0, equivalent = 0, n = 0;  // a formula that is right; the same language as one; commands
  std::size_t refused = 0;                       // not understood, or not likely enough
  std::size_t wrong() const { return n - equivalent - refused; }  // answered, and not right
  double percent(std::size_t count) const {                       // of n
    return n > 0 ? 100.0 * static_cast<double>(count) / static_cast<double>(n) : 0;
  }
};

struct CommandAnswer {                     // one answer of a test
  const Command* command = nullptr;        // that was asked
  std::string formula;                     // empty: none
  double probability = 0;                  // of the formula
  bool exact = false, equivalent = false;  // as in CommandScore
  bool refused = false;                    // not understood, or not likely enough
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

struct ScoreOptions {            // how a reader is tested
  ReadCommandOptions read;       // what reading may cost
  bool marks_are_given = false;  // what the words name is told by the marks: the reader of formulas alone is tested
  double least = 0;              // answers that are less likely are refused
};
// Reads every command. Languages are compared over infinite words; over finite ones where a formula says weak next.
CommandScores score_commands(const LiftedReader& reader, std::span<const Command> commands, CommandDomains& domains,
                             const MarkedCommands& marked, const ScoreOptions& options);

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
  MatcherTraining matcher;               // of the matcher
  std::size_t networks = 3;              // that vote
  std::function<void(double)> progress;  // called with the share that is done
};
// Networks, each of the next seed, and a matcher. `own`: commands of our own language, of which the matcher takes those
// that say nothing alone: it decides over formulas that people's texts have.
LiftedReader learn_reader(std::vector<LiftedExample> own, std::span<const LiftedExample> people,
                          const std::shared_ptr<const WordVectors>& vectors, const MentionModel& mentions,
                          const CommandsExperiment& how);
// Commands of our own, and people's. Where the test has new kinds, domains are not told: what was said of a domain is
// then no reason against a kind.
LiftedReader train_commands(const CommandSplit& split, CommandDomains& domains, const MarkedCommands& marked,
                            const SynchronousGrammar& grammar, const std::shared_ptr<const WordVectors>& vectors,
                            const CommandsExperiment& how);

}  // namespace waymark::parser
