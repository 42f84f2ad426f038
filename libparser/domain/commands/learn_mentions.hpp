// The weights by which mentions of landmarks are found, learned from commands whose formulas name landmarks.
//
// The formula says which landmarks a text names, not where. Weights maximise the log-likelihood of all covers that name
// just these (mention_lattice.hpp), less a quadratic penalty on the distance to the weights set by hand, by AdaGrad
// [DHS11]. Every source of commands weighs the same, whatever the number of its commands.
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
};

struct LearnedMentions {                              // what was learned
  MentionVector weights = mention_weights_by_hand();  // of the features
  std::size_t commands = 0;     // that were learned from; without any the weights are those set by hand
  std::size_t unexplained = 0;  // of cities, without doubts, and no cover names just their landmarks
};
// Commands without doubts of domains that are cities; others are passed over.
LearnedMentions learn_mentions(std::span<const Command> commands, CommandDomains& domains, const Synonyms& synonyms,
                               const MentionTraining& options = {});

}  // namespace waymark::parser
