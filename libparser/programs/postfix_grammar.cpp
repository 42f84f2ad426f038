#include "libparser/programs/postfix_grammar.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace waymark::parser {
namespace {

// A condition is said in a clause of its own, and counts as a step.
int own_steps(StepKind kind) { return kind == StepKind::When || kind == StepKind::Whether ? 1 : 0; }

}  // namespace

PostfixGrammar::PostfixGrammar(const ltl::Vocabulary& vocabulary, Dialect dialect)
    : PostfixGrammar(vocabulary, limits_of(dialect)) {}

PostfixGrammar::PostfixGrammar(const ltl::Vocabulary& vocabulary, Limits limits)
    : limits_(limits), names_{"end", "then", "&", "stay", "orient", "reach", "advance", "next", "face"} {
  if (vocabulary.size() > 20'000) throw std::invalid_argument("a vocabulary of more than 20,000 propositions");
  for (int k = 1; k <= max_forward; ++k) names_.push_back("forward_" + std::to_string(k));
  for (const std::string& name : vocabulary.names()) {
    names_.push_back(name);
    usable_.push_back(name != "moved");
    turns_.push_back(name == "turned_left" || name == "turned_right");
  }
  end_of_literals_ = static_cast<Token>(names_.size());
  if (limits_.dialect == Dialect::Temporal)
    for (const char* name : {"past", "advance_2", "advance_3", "without", "keep", "when", "whether", "apply"})
      names_.emplace_back(name);
}

std::optional<Step> PostfixGrammar::operator_of(Token t) const {
  if (t == reach) return Step{StepKind::Reach, 0, 0, {}};
  if (t == advance) return Step{StepKind::Advance, 0, 0, {}};
  if (t == next) return Step{StepKind::Next, 0, 0, {}};
  if (t == face) return Step{StepKind::Face, 0, 0, {}};
  if (t == token(past)) return Step{StepKind::Past, 0, 0, {}};
  if (t == token(advance_2)) return Step{StepKind::Advance, 2, 0, {}};
  if (t == token(advance_3)) return Step{StepKind::Advance, 3, 0, {}};
  if (t == token(without)) return Step{StepKind::Without, 0, 0, {}};
  if (t == token(keep)) return Step{StepKind::Keep, 0, 0, {}};
  if (t == token(when)) return Step{StepKind::When, 0, 0, {}};
  if (t == token(whether)) return Step{StepKind::Whether, 0, 0, {}};
  return std::nullopt;
}

Token PostfixGrammar::token_of(const Step& step) const {
  const auto none = static_cast<Token>(tokens());
  const auto temporal = [&](Temporal which) { return limits_.dialect == Dialect::Temporal ? token(which) : none; };
  switch (step.kind) {
    case StepKind::Stay: return stay;
    case StepKind::Orient: return orient;
    case StepKind::Forward:
      return step.count < 1 || step.count > max_forward ? none : static_cast<Token>(first_forward + step.count - 1);
    case StepKind::Reach: return reach;
    case StepKind::Next: return next;
    case StepKind::Advance:
      if (step.count == 0) return advance;
      return step.count < 2 || step.count > max_advance ? none : temporal(step.count == 2 ? advance_2 : advance_3);
    case StepKind::Face: return face;
    case StepKind::Past: return temporal(past);
    case StepKind::Without: return temporal(without);
    case StepKind::Keep: return temporal(keep);
    case StepKind::When: return temporal(when);
    case StepKind::Whether: return temporal(whether);
  }
  throw std::logic_error("a step of no kind");
}

// May the open goal of one literal be what `by` takes?
bool PostfixGrammar::takes(const PrefixState& s, const Step& by) const {
  if (s.bools != 1) return false;
  const auto n = static_cast<int>(operands(by.kind));
  if (n == 0) return !s.turns || by.kind == StepKind::Next || by.kind == StepKind::Face;
  return s.goals == 1 && !s.turns && s.awaits == 0 && !s.oriented && s.steps + n + own_steps(by.kind) <= limits_.steps;
}

bool PostfixGrammar::allowed(const PrefixState& s, Token t) const {
  if (s.ended || t >= tokens()) return false;
  if (s.goals >= 2 && s.bools == 2) return t == both;  // & follows its second operand at once
  if (s.operand) return t == token(apply);             // so does `apply`
  if (s.step_entries == 2) return t == then;           // and `then`
  if (is_literal(t)) {
    const auto p = static_cast<std::uint16_t>(t - first_literal);
    if (!usable_[p] || s.stayed) return false;
    if (s.bools == 0) return s.steps < limits_.steps;
    return s.goals < limits_.goals && p > s.last_literal;
  }
  if (const auto step = operator_of(t)) return takes(s, *step);
  if (s.bools > 0 || t == both || t == then || t >= end_of_literals_) return false;
  if (s.awaits > 0) return t >= first_forward;  // there is room for what a function takes
  if (t == end) return s.step_entries == 1 && !s.oriented;
  if (t == stay) return s.step_entries == 0;
  if (s.stayed) return false;  // `stay` is a program, not a step of one
  if (t == orient) return !s.oriented && s.step_entries == 0;
  return s.steps < limits_.steps;  // forward_k
}

TokenRanges PostfixGrammar::choices(const PrefixState& s) const {
  TokenRanges out;
  std::size_t used = 0;
  const auto add = [&](std::size_t begin, std::size_t stop) {
    if (begin < stop) out.ranges[used++] = {static_cast<Token>(begin), static_cast<Token>(stop)};
  };
  if (const auto forced_token = forced(s)) {
    add(*forced_token, *forced_token + 1U);
  } else if (s.bools > 0) {
    add(s.turns ? next : reach, face + 1);
    if (s.goals < limits_.goals) add(first_literal + s.last_literal + 1U, end_of_literals_);
    std::size_t stop = end_of_literals_;  // of what the temporal dialect allows: a beginning of its list
    while (stop < tokens() && allowed(s, static_cast<Token>(stop))) ++stop;
    add(end_of_literals_, stop);
  } else if (!s.ended) {
    if (s.step_entries == 1 && !s.oriented && s.awaits == 0) add(end, end + 1);
    if (s.step_entries == 0 && s.awaits == 0) add(stay, orient + 1);
    if (s.steps < limits_.steps) add(first_forward, end_of_literals_);
  }
  return out;
}

PrefixState PostfixGrammar::after(const PrefixState& state, Token t) const {
  assert(allowed(state, t));
  PrefixState s = state;
  if (is_literal(t)) {
    ++s.bools;
    ++s.goals;
    s.last_literal = static_cast<std::uint16_t>(t - first_literal);
    s.turns = s.turns || is_turn(s.last_literal);
  } else if (t == both) {
    --s.bools;
  } else if (t == then) {
    --s.step_entries;
  } else if (t == end) {
    s.ended = true;
  } else if (s.operand) {  // apply
    s.operand = false;
    if (--s.awaits == 0) ++s.step_entries;
  } else {  // a Step or a function is pushed
    const auto step = operator_of(t);
    const std::size_t n = step ? operands(step->kind) : 0;
    s.bools = s.goals = 0;
    s.last_literal = 0;
    s.turns = false;
    s.oriented = t == orient;
    s.stayed = t == stay;
    if (n > 0) {
      s.awaits = static_cast<std::uint8_t>(n);
      s.steps = static_cast<std::uint8_t>(s.steps + own_steps(step->kind));
      return s;
    }
    if (s.awaits > 0)
      s.operand = true;
    else
      ++s.step_entries;
    if (t != orient) ++s.steps;
  }
  return s;
}

std::optional<Token> PostfixGrammar::forced(const PrefixState& s) const {
  if (s.ended) return std::nullopt;
  if (s.goals >= 2 && s.bools == 2) return both;
  if (s.operand) return token(apply);
  if (s.step_entries == 2) return then;
  if (s.bools == 0 && s.awaits == 0 && (s.stayed || (s.steps == limits_.steps && !s.oriented))) return end;
  return std::nullopt;
}

// Its tokens but `end`, whether or not they are allowed, of a program that is complete.
std::vector<Token> PostfixGrammar::spelled(const Program& program) const {
  std::vector<Token> out;
  const auto unit = [&](const auto& self, std::size_t i) -> void {
    const Step& step = program[i];
    for (std::size_t g = 0; g < step.goals; ++g) {
      out.push_back(literal(step.goal[g]));
      if (g > 0) out.push_back(both);
    }
    out.push_back(token_of(step));
    std::size_t operand = i + 1;
    for (std::size_t k = 0; k < operands(step.kind); ++k) {
      self(self, operand);
      out.push_back(token(apply));
      operand = unit_end(program, operand);
    }
  };
  for (std::size_t i = 0; i < program.size(); i = unit_end(program, i)) {
    unit(unit, i);
    if (i > 0) out.push_back(then);
  }
  return out;
}

bool PostfixGrammar::contains(const Program& program) const {
  if (!is_complete(program)) return false;
  std::vector<Token> tokens = spelled(program);
  tokens.push_back(end);
  PrefixState state;
  return std::all_of(tokens.begin(), tokens.end(), [&](Token t) {
    const bool fits = allowed(state, t);
    if (fits) state = after(state, t);
    return fits;
  });
}

std::vector<Token> PostfixGrammar::tokens_of(const Program& program) const {
  if (!contains(program)) throw std::invalid_argument("a program outside the decoder's language");
  std::vector<Token> tokens = spelled(program);
  tokens.push_back(end);
  return tokens;
}

Program PostfixGrammar::program_of(std::span<const Token> tokens) const {
  Program program;
  Step open;
  for (Token t : tokens) {
    if (is_literal(t)) {
      open.goal.at(open.goals++) = static_cast<std::uint16_t>(t - first_literal);
      continue;
    }
    if (t == both || t == then || t == end || t == token(apply)) continue;
    if (const auto step = operator_of(t)) {
      open.kind = step->kind;
      open.count = step->count;
    } else if (t >= first_forward) {
      open.kind = StepKind::Forward;
      open.count = static_cast<std::uint8_t>(t - first_forward + 1);
    } else {
      open.kind = t == stay ? StepKind::Stay : StepKind::Orient;
    }
    program.push_back(open);
    open = Step{};
  }
  return program;
}

std::string PostfixGrammar::show(const Program& program) const {
  std::string text;
  for (const Token t : spelled(program)) text += (text.empty() ? "" : " ") + names_.at(t);
  return text;
}

}  // namespace waymark::parser
