// What the reader of commands learns from: commands of our own, people's commands with formulas, route instructions,
// and texts that say nothing to a robot.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "libparser/corpus/corpus.hpp"
#include "libparser/domain/commands/command_domain.hpp"
#include "libparser/language/synchronous_grammar.hpp"
#include "libparser/lifted/learn_lifted.hpp"
#include "libplan/world/map.hpp"

namespace waymark::parser {

struct OwnCommands {
  std::size_t texts = 60000;  // of our own language
  std::uint64_t seed = 1;     // of the texts
  double weight = 0.04;       // of one text, compared with one of people's
  double nothing = 0.16;      // share of texts that say nothing, on top
};
// Texts of the grammar; those that say nothing name a thing that is not there, or are chatter or random words.
std::vector<LiftedExample> own_commands(const SynchronousGrammar& grammar, const WordVectors& vectors,
                                        const OwnCommands& options);

// People's commands with their labels; those that may be doubted only if `doubted`. A row is learned from with its
// domain named and, by `unnamed`, as one of no domain. Rows whose label does not go with the text's mentions are left
// out and counted.
struct LabelledCommands {
  std::vector<LiftedExample> examples;  // for the networks
  std::size_t left_out = 0;             // whose formulas are none, or are not lifted
};
// People's commands; `unnamed`: the share of their weight that is learned without the name of the domain.
LabelledCommands labelled_commands(std::span<const Command> commands, CommandDomains& domains,
                                   const MentionModel& mentions, double unnamed, bool doubted = false);

// Sentences and paragraphs of a corpus, as texts that the reader of programs reads.
std::vector<LiftedExample> route_instructions(const Corpus& corpus, std::span<const plan::Map> maps,
                                              const WordVectors& vectors, const Synonyms& synonyms, double weight);

}  // namespace waymark::parser
