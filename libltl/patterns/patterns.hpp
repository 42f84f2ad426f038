// Specification patterns by name, from two catalogues.
//
// The property patterns of [DAC98] have eleven bodies (p never holds, s responds to p, …) in five scopes (globally,
// before r, after q, between q and r, after q until r): 55 formulas as published. The mission patterns of [MTP+21] for
// robots are visits, patrols, avoidance and reactions, over any number of places. Both were written for infinite words.
// On finite words X is strong, so a mission that requires a next letter cannot end there.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::ltl {

enum class Body : std::uint8_t {  // what is claimed inside a scope
  Absence,                        // p never holds
  Existence,                      // p holds at some time
  BoundedExistence,               // p holds for at most two stretches of time
  Universality,                   // p always holds
  Precedence,                     // s precedes p
  Response,                       // s responds to p
  PrecedenceChain2To1,            // s and then t precede p
  PrecedenceChain1To2,            // p precedes s and then t
  ResponseChain2To1,              // p responds to s and then t
  ResponseChain1To2,              // s and then t respond to p
  ConstrainedChain,               // s and then t, without z between them, respond to p
};
enum class Scope : std::uint8_t { Globally, Before, After, Between, AfterUntil };  // where a body is claimed

enum class Mission : std::uint8_t {  // the mission patterns of robots
  Visit,
  SequencedVisit,
  OrderedVisit,
  StrictOrderedVisit,
  FairVisit,
  Patrolling,
  SequencedPatrolling,
  OrderedPatrolling,
  StrictOrderedPatrolling,
  FairPatrolling,
  GlobalAvoidance,
  PastAvoidance,
  FutureAvoidance,
  UpperRestrictedAvoidance,
  LowerRestrictedAvoidance,
  ExactRestrictedAvoidance,
  InstantaneousReaction,
  DelayedReaction,
  PromptReaction,
  BoundReaction,
  BoundDelay,
  Wait,
};

struct Pattern {
  std::string name;        // "response-between", "ordered-visit"
  std::string parameters;  // names with blanks between: "p s q r"; "n l": a number first; "l..": one or more
  std::string sentence;    // in terms of the parameters
  std::string source;      // a key of docs/references.bib
  std::string formula;     // in terms of the parameters; of three places and of n = 2
};

// Arguments in the order of the parameters, all of one arena. Throw std::invalid_argument when their number is wrong.
Formula property(Body body, Scope scope, std::span<const Formula> arguments);
Formula mission(Mission mission, std::span<const Formula> places);
// The avoidances that count: at most, at least, exactly `times` instants at the place; times ≥ 1.
Formula restricted_avoidance(Mission mission, std::size_t times, Formula place);

std::vector<Pattern> property_patterns();  // 55, the order of the catalogue
std::vector<Pattern> mission_patterns();   // in the order of the catalogue

// The pattern of that name with these arguments, formulas of the arena; a number stands first where the parameters
// begin with n. Throws SyntaxError in an argument, std::invalid_argument (name unknown, nearest one named; wrong
// count).
Formula instantiate(std::string_view name, std::span<const std::string> arguments, Arena& arena);

}  // namespace waymark::ltl
