// Trajectories: poses joined by actions. They are read from text, checked step by step, and turned into words.
//
//   JSON    [[x,y,heading],…], or an object that holds such a list under "route" or "poses" (the answer of `waymark
//           plan --json` can be fed back in); each pose differs from the one before by exactly one action; or an object
//           with "prefix" and "cycle", two such lists: a walk without end, the cycle begins where the prefix ends
//   text    a start pose x,y,heading, then the actions: 1,9,0 FORWARD LEFT FORWARD
//           (separated by blanks or commas; # starts a comment that runs to the end of the line); the last actions in
//           ( … )w are repeated for ever
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/formula.hpp"
#include "libltl/word.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

struct Trajectory {
  std::vector<PoseId> poses;    // poses.size() = actions.size() + 1
  std::vector<Action> actions;  // between the poses
  friend bool operator==(const Trajectory&, const Trajectory&) = default;
};

// A walk on a map: a trajectory that ends, or a lasso whose last `repeated` ≥ 1 actions are repeated for ever.
struct Walk {
  Trajectory trajectory;     // the prefix and one round
  std::size_t repeated = 0;  // 0: the walk ends
};

// The action that leads from one pose to the other in one step, if there is one.
std::optional<Action> action_between(const Map& map, PoseId from, PoseId to);

// The poses that the actions lead through; nullopt when one of them runs into a wall.
std::optional<Trajectory> follow(const Map& map, PoseId start, const std::vector<Action>& actions);

// L(start), then one letter per action (conventions.md 1).
ltl::Trace word_of(const Trajectory& trajectory, const Map& map);
// u·vʷ of a walk with repeated ≥ 1: v has the letters of the actions that are repeated.
ltl::Lasso lasso_of(const Walk& walk, const Map& map);
// word_of over the vocabulary of f: the propositions that occur in f are matched with the map's by name. Throws
// ltl::FormatError naming one that the map lacks.
ltl::Trace word_for(ltl::Formula f, const Trajectory& trajectory, const Map& map);

// The error for a proposition that no letter of the map can carry, with the nearest name as a hint.
ltl::FormatError unknown_proposition(const Map& map, const std::string& name);

// Either form. Throws ltl::FormatError naming the step that is impossible and what would have been possible there, and
// for a cycle that does not lead back to where it begins.
Walk parse_walk(std::string_view text, const Map& map, std::string_view source = "");
// The same; of a walk without end the prefix and one round of the cycle.
Trajectory parse_trajectory(std::string_view text, const Map& map, std::string_view source = "");

// "x,y,heading", or "x,y" and "x,y,-1" for an unknown heading: all four poses of the place, heading 0 first
// (conventions.md 8). Throws ltl::FormatError; for a place off the map it names the nearest.
std::vector<PoseId> parse_start(std::string_view text, const Map& map);

// "FORWARD", "LEFT", "RIGHT" in any case, or their first letters.
std::optional<Action> parse_action(std::string_view text);

// "1,9,0 FORWARD LEFT": parse_trajectory reads it back.
std::string show(const Trajectory& trajectory, const Map& map);

}  // namespace waymark::plan
