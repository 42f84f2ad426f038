// The weights by which mentions of landmarks are found, learned from commands whose formulas name landmarks.
//
// The formula says which landmarks a text names, not where. Weights maximise the log-likelihood of all covers that name
// just these (mention_lattice.hpp), less a quadratic penalty on the distance to the weights set by hand, by AdaGrad
// [DHS11]. Every source of commands weighs the same, whatever the number of its commands.
//
// Where a command has marks, its cover is known: of each mark, the longest phrase inside that names its thing and
// agrees with it whether the words state the opposite. Such a command is read over its own things, and every other time
// over some of other commands, too.
#pragma once
#include <cstdint>
#include <span>

#include "libparser/domain/commands/command.hpp"
#include "libparser/domain/commands/command_domain.hpp"
#include "libparser/lifted/mention_weights.hpp"

namespace waymark::parser {

struct MentionTraining {               // by gradient ascent
  std::uint64_t seed = 1;              // of the order of the commands
  int epochs = 30;                     // over all commands
  double rate = 0.3, penalty = 0.005;  // of a step; of large weights
  int marked_epochs = 6;               // in which a command with marks is met, at most `epochs`
  double marked_weight = 1;            // of a command with marks; the mean of others is 1
  std::size_t distractors = 12;        // things of other commands beside those of a command with marks
};

struct LearnedMentions {                              // what was learned
  MentionVector weights = mention_weights_by_hand();  // of the features
  std::size_t commands = 0;     // that were learned from; without any the weights are those set by hand
  std::size_t marked = 0;       // of these: with marks
  std::size_t unexplained = 0;  // of cities, without doubts, and no cover names just their landmarks
};
// Commands without doubts that have marks or whose domains are cities; others are passed over.
LearnedMentions learn_mentions(std::span<const Command> commands, CommandDomains& domains, const Synonyms& synonyms,
                               const MentionTraining& options = {});

}  // namespace waymark::parser
