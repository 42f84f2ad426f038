// English commands of a domain → LTL formulas over its propositions, likeliest first.
//
// p(φ | text) = Σ over what the words may name, Σ over lifted formulas that denote a formula of the same language:
// readings with one meaning vote together. Over infinite words.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "libparser/domain/commands/command_domain.hpp"
#include "libparser/lifted/lifted_reader.hpp"

namespace waymark::parser {

struct CommandReading {    // one meaning of a command
  ltl::Formula formula;    // over the propositions of the domain
  double probability = 0;  // of the language of the formula
};

struct CommandReadings {                 // all readings of a text
  std::vector<CommandReading> readings;  // of one arena; probabilities sum to 1
  double understood = 0;  // probability that the text is a command, with the mentions of the likeliest reading
};

struct ReadCommandOptions {  // what reading may cost
  std::size_t beam = 12;     // lifted formulas of each text
  std::size_t compared = 5;  // the likeliest formulas whose languages are compared
  bool names_domain = true;  // the reader is told which domain it is
};

// What the words of a text may name, and how likely they name it.
struct BoundLift {
  LiftedText text;         // its mentions are slots
  double probability = 1;  // of the lifts of one text: 1 together
  Bindings bindings;       // what its slots denote, in the arena of the readings
};
// Readings of the lifts together.
CommandReadings read_lifts(const LiftedReader& reader, std::span<const BoundLift> lifts,
                           const ReadCommandOptions& options = {});

// No readings when no lifted formula of the beam denotes a formula of the domain.
CommandReadings read_command(const LiftedReader& reader, const CommandDomain& domain, const std::string& text,
                             ltl::Arena& arena, const ReadCommandOptions& options = {});

// Do they hold on the same infinite words? Of one arena. False when the question takes more than `steps` states.
bool same_language(ltl::Formula a, ltl::Formula b, std::size_t steps = 200'000);

}  // namespace waymark::parser
