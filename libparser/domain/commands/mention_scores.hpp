// Whether the mentions that are found in a command are those that its writer marked.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "libparser/domain/commands/command.hpp"
#include "libparser/domain/commands/command_domain.hpp"
#include "libparser/lifted/mention_weights.hpp"
#include "libparser/mention/mention.hpp"

namespace waymark::parser {

struct NamedThings {                  // what a text names
  std::vector<std::string> slots;     // propositions in the order of first mention
  std::vector<std::string> negated;   // those that an odd number of mentions negate, sorted
  std::vector<std::string> sequence;  // all mentions, "!p" where p is negated
  bool operator==(const NamedThings&) const = default;
};

// A mention is negated when its words state the opposite, and once more for each "no", "not" or "without" directly
// before it: "no open door", "the door isn't open" and "the door is shut" say the same.
NamedThings marked_things(const Command& command);
// The marks of a command among its landmark_tokens; things by their rank among the keys.
std::vector<Mention> marked_mentions(const Command& command);
// The text whose marks are slots: what the likeliest reading of the mentions should be.
CommandDomain::Lift marked_lift(const Command& command);
NamedThings found_things(const CommandDomain::Lift& lift);

struct MentionScores {       // numbers of commands
  std::size_t commands = 0;  // all
  std::size_t named = 0;     // whose things are found in the order of first mention
  std::size_t stated = 0;    // of these: what is negated is found, too
  std::size_t exact = 0;     // every mention is found, and no other
  std::size_t lifted =
      0;  // no word more and no word less belongs to a mention: the text with slots is that of the marks
};

// Of the likeliest reading. Each command is read over its things, and so many others of `distractors` as are given.
MentionScores score_mentions(std::span<const Command> commands, const MentionModel& model,
                             std::span<const std::string> distractors = {});

}  // namespace waymark::parser
