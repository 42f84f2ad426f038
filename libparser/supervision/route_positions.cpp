#include "libparser/supervision/route_positions.hpp"

#include <stdexcept>

namespace waymark::parser {

RoutePositions::RoutePositions(const Executor& executor, const GoldRoute& route) : executor_(executor) {
  if (route.actions.size() > most) throw std::length_error("a route of more than 63 actions");
  letters_.push_back(Arrival::start(route.start));
  for (const plan::Action action : route.actions)
    letters_.push_back(Arrival::of(*executor.map().successor(letters_.back().pose(), action), action));
}

Positions RoutePositions::where(Positions at, std::uint16_t proposition) const {
  Positions out = 0;
  for (std::size_t i = 0; i < letters_.size(); ++i)
    if ((at >> i & 1U) != 0 && executor_.holds(proposition, letters_[i])) out |= Positions{1} << i;
  return out;
}

bool RoutePositions::holds(const Step& step, std::size_t i) const {
  for (const std::uint16_t p : step.literals())
    if (!executor_.holds(p, letters_[i])) return false;
  return true;
}

// One pass over the letters: `owed` is carried along while the step may wait.
Positions RoutePositions::after(Positions at, const Step& step, const Step* guard) const {
  if (step.kind == StepKind::Forward) {
    for (std::size_t k = 0; k < step.count; ++k) at = advance(at, {StepKind::Next, 0, 0, {}});
    return at;
  }
  if (step.kind == StepKind::Past) return advance(advance(at, {StepKind::Advance, 0, 1, step.goal}), {StepKind::Next});
  if (step.kind == StepKind::Advance) {
    for (std::size_t k = 0; k < step.times(); ++k) at = advance(at, step);
    return at;
  }
  Positions out = 0;
  bool owed = false;
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    const bool enters = (at >> i & 1U) != 0;
    if (step.kind == StepKind::Reach) {
      owed = owed || enters;
      if (owed && holds(step, i)) out |= Positions{1} << i;
      if (guard != nullptr && holds(*guard, i) != (guard->kind == StepKind::Keep)) owed = false;
      continue;
    }
    if (owed && (step.kind == StepKind::Next || letters_[i].is_turn()) && holds(step, i)) out |= Positions{1} << i;
    owed = enters || (owed && step.kind == StepKind::Face && letters_[i].is_turn());
  }
  return out;
}

// Moves alone until the goal holds; Next: a single one.
Positions RoutePositions::advance(Positions at, const Step& step) const {
  Positions out = 0;
  bool owed = false;
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    owed = owed && letters_[i].is_move();
    if (owed && holds(step, i)) out |= Positions{1} << i;
    owed = (at >> i & 1U) != 0 || (owed && step.kind == StepKind::Advance);
  }
  return out;
}

}  // namespace waymark::parser
