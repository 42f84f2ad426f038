#include "libparser/programs/program.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "libplan/world/labelling.hpp"

namespace waymark::parser {
namespace {

ltl::Formula event(ltl::Arena& arena, std::string_view name) {
  const auto p = arena.vocabulary().find(name);
  if (!p) throw std::invalid_argument("programs need the proposition '" + std::string(name) + "'");
  return arena.atom(*p);
}

// Formulas of steps. `meanwhile` holds at every letter before the one where the goal of a step holds.
class Builder {
 public:
  Builder(std::span<const Step> program, ltl::Arena& arena) : program_(program), arena_(arena) {}

  ltl::Formula whole() const {
    std::vector<std::size_t> units;
    for (std::size_t i = 0; i < program_.size(); i = unit_end(program_, i)) units.push_back(i);
    ltl::Formula f = arena_.constant(true);
    for (std::size_t u = units.size(); u-- > 0;) f = unit(units[u], f, arena_.constant(true));
    return f;
  }

 private:
  ltl::Formula unit(std::size_t i, ltl::Formula rest, ltl::Formula meanwhile) const {
    const Step& step = program_[i];
    if (operands(step.kind) == 0) return formula_of_step(step, rest, meanwhile);
    const ltl::Formula first = unit(i + 1, rest,
                                    step.kind == StepKind::Without ? ltl::negate(literal(step))
                                    : step.kind == StepKind::Keep  ? literal(step)
                                                                   : meanwhile);
    if (step.kind == StepKind::Without || step.kind == StepKind::Keep) return first;
    const ltl::Formula second =
        step.kind == StepKind::Whether ? unit(unit_end(program_, i + 1), rest, meanwhile) : rest;
    const ltl::Formula holds = ltl::conjunction(literal(step), first);
    return ltl::disjunction(holds, ltl::conjunction(ltl::negate(literal(step)), second));
  }

  ltl::Formula formula_of_step(const Step& step, ltl::Formula rest, ltl::Formula meanwhile) const {
    switch (step.kind) {
      case StepKind::Stay: return rest;
      case StepKind::Orient: return ltl::disjunction(rest, only_until(turned(), rest, arena_.constant(true)));
      case StepKind::Forward: {
        ltl::Formula f = rest;
        for (int k = 0; k < step.count; ++k) f = moved_to(f, meanwhile);
        return f;
      }
      case StepKind::Reach: return ltl::until(meanwhile, goal(step, rest));
      case StepKind::Next: return ltl::conjunction(meanwhile, ltl::next(goal(step, rest)));
      case StepKind::Advance: {
        ltl::Formula f = only_until(moved(), goal(step, rest), meanwhile);
        for (std::size_t k = 1; k < step.times(); ++k) f = only_until(moved(), goal(step, f), meanwhile);
        return f;
      }
      case StepKind::Face: return only_until(turned(), goal(step, rest), meanwhile);
      case StepKind::Past: return only_until(moved(), goal(step, moved_to(rest, meanwhile)), meanwhile);
      case StepKind::Without:
      case StepKind::Keep:
      case StepKind::When:
      case StepKind::Whether: break;
    }
    throw std::logic_error("a function is no step");
  }

  // X(moved ∧ then)
  ltl::Formula moved_to(ltl::Formula then, ltl::Formula meanwhile) const {
    return ltl::conjunction(meanwhile, ltl::next(ltl::conjunction(moved(), then)));
  }

  // X(only U (only ∧ then))
  static ltl::Formula only_until(ltl::Formula only, ltl::Formula then, ltl::Formula meanwhile) {
    const ltl::Formula before = ltl::conjunction(only, meanwhile);
    return ltl::conjunction(meanwhile, ltl::next(ltl::until(before, ltl::conjunction(only, then))));
  }

  ltl::Formula goal(const Step& step, ltl::Formula rest) const {
    std::vector<ltl::Formula> parts{rest};
    for (std::uint16_t p : step.literals()) parts.push_back(arena_.atom(ltl::Proposition{p}));
    return ltl::conjunction(arena_, parts);
  }
  ltl::Formula literal(const Step& step) const { return goal(step, arena_.constant(true)); }
  ltl::Formula moved() const { return event(arena_, "moved"); }
  ltl::Formula turned() const {
    const ltl::Formula left = event(arena_, "turned_left");
    return ltl::disjunction(left, event(arena_, "turned_right"));
  }

  std::span<const Step> program_;
  ltl::Arena& arena_;
};

}  // namespace

bool is_complete(std::span<const Step> program) {
  std::size_t owed = 0;  // steps to functions before
  for (const Step& step : program) owed = (owed > 0 ? owed - 1 : 0) + operands(step.kind);
  return owed == 0;
}

std::size_t unit_end(std::span<const Step> program, std::size_t i) {
  if (i >= program.size()) throw std::invalid_argument("a function without the step it applies to");
  const std::size_t n = operands(program[i++].kind);
  for (std::size_t k = 0; k < n; ++k) i = unit_end(program, i);
  return i;
}

ltl::Formula formula_of(const Program& program, ltl::Arena& arena) { return Builder(program, arena).whole(); }

Program mirror(Program program, std::span<const std::uint16_t> images) {
  for (Step& step : program) {
    for (std::size_t i = 0; i < step.goals; ++i) step.goal[i] = images[step.goal[i]];
    std::sort(step.goal.begin(), step.goal.begin() + step.goals);
  }
  return program;
}

std::vector<std::uint16_t> mirror_images(const ltl::Vocabulary& vocabulary) {
  const std::vector<plan::Observable> observables = plan::observables_of(vocabulary);
  std::vector<std::uint16_t> images;
  for (std::uint32_t p = 0; p < vocabulary.size(); ++p) {
    const auto image = vocabulary.find(plan::proposition_name(plan::mirrored(observables[p])));
    images.push_back(static_cast<std::uint16_t>(image.value_or(ltl::Proposition{p}).index));
  }
  return images;
}

}  // namespace waymark::parser
