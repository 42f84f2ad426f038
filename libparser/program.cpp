#include "libparser/program.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace waymark::parser {
namespace {

ltl::Formula event(ltl::Arena& arena, std::string_view name) {
  const auto p = arena.vocabulary().find(name);
  if (!p) throw std::invalid_argument("programs need the proposition '" + std::string(name) + "'");
  return arena.atom(*p);
}

// X(only U (only ∧ then))
ltl::Formula next_until(ltl::Formula only, ltl::Formula then) {
  return ltl::next(ltl::until(only, ltl::conjunction(only, then)));
}

ltl::Formula step_formula(const Step& step, ltl::Formula rest) {
  ltl::Arena& arena = rest.arena();
  std::vector<ltl::Formula> parts{rest};
  for (std::uint16_t p : step.literals()) parts.push_back(arena.atom(ltl::Proposition{p}));
  const ltl::Formula goal = ltl::conjunction(arena, parts);
  const auto moved = [&] { return event(arena, "moved"); };
  const auto turned = [&] {
    return ltl::disjunction(event(arena, "turned_left"), event(arena, "turned_right"));
  };
  switch (step.kind) {
    case StepKind::Stay: return rest;
    case StepKind::Orient: return ltl::disjunction(rest, next_until(turned(), rest));
    case StepKind::Forward: {
      ltl::Formula f = rest;
      for (int k = 0; k < step.count; ++k) f = ltl::next(ltl::conjunction(moved(), f));
      return f;
    }
    case StepKind::Reach: return ltl::eventually(goal);
    case StepKind::Next: return ltl::next(goal);
    case StepKind::Advance: return next_until(moved(), goal);
    case StepKind::Face: return next_until(turned(), goal);
  }
  throw std::logic_error("a step of no kind");
}

}  // namespace

ltl::Formula formula_of(const Program& program, ltl::Arena& arena) {
  ltl::Formula f = arena.constant(true);
  for (std::size_t i = program.size(); i-- > 0;) f = step_formula(program[i], f);
  return f;
}

Program mirror(Program program, std::span<const std::uint16_t> images) {
  for (Step& step : program) {
    for (std::size_t i = 0; i < step.goals; ++i) step.goal[i] = images[step.goal[i]];
    std::sort(step.goal.begin(), step.goal.begin() + step.goals);
  }
  return program;
}

std::vector<std::uint16_t> mirror_images(const ltl::Vocabulary& vocabulary) {
  const auto exchange = [](std::string name, const std::string& from, const std::string& to) {
    return name.rfind(from, 0) == 0 ? to + name.substr(from.size()) : name;
  };
  std::vector<std::uint16_t> images(vocabulary.size());
  for (std::uint32_t p = 0; p < vocabulary.size(); ++p) {
    const std::string& name = vocabulary.name({p});
    std::string image = name;
    if (name.rfind("left_", 0) == 0) image = exchange(name, "left_", "right_");
    if (name.rfind("right_", 0) == 0) image = exchange(name, "right_", "left_");
    if (name == "turned_left") image = "turned_right";
    if (name == "turned_right") image = "turned_left";
    images[p] = static_cast<std::uint16_t>(vocabulary.find(image).value_or(ltl::Proposition{p}).index);
  }
  return images;
}

}  // namespace waymark::parser
