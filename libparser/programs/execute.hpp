// The plan of a program on a map: where does it end?
//
// The plan of a formula is its least-cost route, ties by action order FORWARD, LEFT, RIGHT (docs/conventions.md 4).
// All actions cost 1, so breadth-first search over (pose, action that led there) × (progress through the program)
// that expands actions in that order meets words in shortlex order, and the first accepting one is the plan. Progress
// is a bit set of pending obligations: the nondeterministic automaton of the program, determinised on the fly.
// Equal to solving the product with the DFA of formula_of(program) (tested), about a thousand times faster.
//
// Reading::Stepwise is the other meaning of `then`: each step on its own, from the pose where the last one ended.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libparser/programs/program.hpp"
#include "libplan/world/map.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::parser {

enum class Then : std::uint8_t { WholePlan, Stepwise };

struct Plan {                         // where a program leads
  plan::PoseId end;                   // the pose after the last action
  std::vector<plan::Action> actions;  // from the start
};

// A pose together with the action that led to it: what one letter depends on.
struct Arrival {
  std::uint32_t index = 0;                                 // 4 · pose, + 1 + action unless the route starts here
  static Arrival of(plan::PoseId pose, plan::Action by) {  // after an action
    return {4 * pose.index + 1 + static_cast<std::uint32_t>(by)};
  }
  static Arrival start(plan::PoseId pose) { return {4 * pose.index}; }  // before any action
  plan::PoseId pose() const { return {index / 4}; }                     // where one is
  // What led there.
  bool is_start() const { return index % 4 == 0; }
  bool is_move() const { return index % 4 == 1; }
  bool is_turn() const { return index % 4 >= 2; }
  plan::Action action() const { return static_cast<plan::Action>(index % 4 - 1); }  // not of a start
  friend bool operator==(Arrival, Arrival) = default;
};

class Executor {  // of one map
 public:
  explicit Executor(const plan::Map& map);  // the map must outlive it; O(|S| · |AP|)

  const plan::Map& map() const { return *map_; }  // of the plans
  // Nothing when the program has no plan.
  std::optional<Plan> run(const Program& program, plan::PoseId start, Then then = Then::WholePlan) const;

  // Does the word of the trajectory satisfy the program's formula? A trajectory of this map; O(letters · steps).
  bool satisfies(const plan::Trajectory& trajectory, const Program& program) const;

  struct Reached {      // an arrival that a step can pass through
    Arrival arrival;    // a pose and the action that led there
    std::int32_t from;  // position of the predecessor, −1: none
    bool goal;          // the step may end here
  };
  // Arrivals a single step can pass through, in shortlex order of their first word, the start first.
  // oriented: any turns may come before the step; only for Advance.
  std::vector<Reached> horizon(StepKind kind, plan::PoseId start, bool oriented = false) const;
  bool holds(std::uint16_t proposition, Arrival arrival) const {  // in the letter of the arrival
    return ((columns_[proposition][arrival.index / 64] >> (arrival.index % 64)) & 1U) != 0;
  }
  std::size_t propositions() const { return columns_.size(); }  // of the map

 private:
  template <std::size_t N>
  std::optional<Plan> search(const Program& program, plan::PoseId start) const;
  template <std::size_t N>
  bool progresses(const plan::Trajectory& trajectory, const Program& program) const;

  const plan::Map* map_;
  std::vector<std::vector<std::uint64_t>> columns_;      // by proposition: bit set over arrivals
  std::vector<std::array<std::int32_t, 3>> successors_;  // by pose and action: a pose, −1 for a wall
};

}  // namespace waymark::parser
