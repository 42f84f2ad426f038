#include "libparser/postfix_grammar.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace waymark::parser {
namespace {

std::optional<StepKind> operator_of(Token token) {
  switch (token) {
    case PostfixGrammar::reach: return StepKind::Reach;
    case PostfixGrammar::next: return StepKind::Next;
    case PostfixGrammar::advance: return StepKind::Advance;
    case PostfixGrammar::face: return StepKind::Face;
    default: return std::nullopt;
  }
}

Token token_of(const Step& step) {
  switch (step.kind) {
    case StepKind::Stay: return PostfixGrammar::stay;
    case StepKind::Orient: return PostfixGrammar::orient;
    case StepKind::Forward: return static_cast<Token>(PostfixGrammar::first_forward + step.count - 1);
    case StepKind::Reach: return PostfixGrammar::reach;
    case StepKind::Next: return PostfixGrammar::next;
    case StepKind::Advance: return PostfixGrammar::advance;
    case StepKind::Face: return PostfixGrammar::face;
  }
  throw std::logic_error("a step of no kind");
}

}  // namespace

PostfixGrammar::PostfixGrammar(const ltl::Vocabulary& vocabulary) : PostfixGrammar(vocabulary, Limits{}) {}

PostfixGrammar::PostfixGrammar(const ltl::Vocabulary& vocabulary, Limits limits)
    : limits_(limits), names_{"end", "then", "&", "stay", "orient", "reach", "advance", "next", "face"} {
  if (vocabulary.size() > 20'000)
    throw std::invalid_argument("a vocabulary of more than 20,000 propositions");
  for (int k = 1; k <= max_forward; ++k) names_.push_back("forward_" + std::to_string(k));
  for (const std::string& name : vocabulary.names()) {
    names_.push_back(name);
    usable_.push_back(name != "moved");
    turns_.push_back(name == "turned_left" || name == "turned_right");
  }
}

bool PostfixGrammar::allowed(const PrefixState& s, Token token) const {
  if (s.ended || token >= tokens()) return false;
  if (s.goals >= 2 && s.bools == 2) return token == both;  // & follows its second operand at once
  if (s.step_entries == 2) return token == then;           // so does `then`
  if (token >= first_literal) {
    const auto p = static_cast<std::uint16_t>(token - first_literal);
    if (!usable_[p] || s.stayed) return false;
    if (s.bools == 0) return s.steps < limits_.steps;
    return s.goals < limits_.goals && p > s.last_literal;
  }
  if (operator_of(token)) return s.bools == 1 && (!s.turns || token == next || token == face);
  if (s.bools > 0 || token == both || token == then) return false;
  if (token == end) return s.step_entries == 1 && !s.oriented;
  if (token == stay) return s.step_entries == 0;
  if (s.stayed) return false;  // `stay` is a program, not a step of one
  if (token == orient) return !s.oriented && s.step_entries == 0;
  return s.steps < limits_.steps;  // forward_k
}

TokenRanges PostfixGrammar::choices(const PrefixState& s) const {
  TokenRanges out;
  std::size_t used = 0;
  const auto add = [&](std::size_t begin, std::size_t stop) {
    if (begin < stop) out.ranges[used++] = {static_cast<Token>(begin), static_cast<Token>(stop)};
  };
  if (const auto token = forced(s)) {
    add(*token, *token + 1U);
  } else if (s.bools > 0) {
    add(s.turns ? next : reach, face + 1);
    if (s.goals < limits_.goals) add(first_literal + s.last_literal + 1U, tokens());
  } else if (!s.ended) {
    if (s.step_entries == 1 && !s.oriented) add(end, end + 1);
    if (s.step_entries == 0) add(stay, orient + 1);
    if (s.steps < limits_.steps) add(first_forward, tokens());
  }
  return out;
}

PrefixState PostfixGrammar::after(const PrefixState& state, Token token) const {
  assert(allowed(state, token));
  PrefixState s = state;
  if (token >= first_literal) {
    ++s.bools;
    ++s.goals;
    s.last_literal = static_cast<std::uint16_t>(token - first_literal);
    s.turns = s.turns || is_turn(s.last_literal);
  } else if (token == both) {
    --s.bools;
  } else if (token == then) {
    --s.step_entries;
  } else if (token == end) {
    s.ended = true;
  } else {  // a Step is pushed
    s.bools = s.goals = 0;
    s.last_literal = 0;
    s.turns = false;
    ++s.step_entries;
    s.oriented = token == orient;
    s.stayed = token == stay;
    if (token != orient) ++s.steps;
  }
  return s;
}

std::optional<Token> PostfixGrammar::forced(const PrefixState& s) const {
  if (s.ended) return std::nullopt;
  if (s.goals >= 2 && s.bools == 2) return both;
  if (s.step_entries == 2) return then;
  if (s.bools == 0 && (s.stayed || (s.steps == limits_.steps && !s.oriented))) return end;
  return std::nullopt;
}

std::vector<Token> PostfixGrammar::tokens_of(const Program& program) const {
  std::vector<Token> tokens;
  PrefixState state;
  const auto push = [&](Token token) {
    if (!allowed(state, token)) throw std::invalid_argument("a program outside the decoder's language");
    state = after(state, token);
    tokens.push_back(token);
  };
  for (std::size_t i = 0; i < program.size(); ++i) {
    const Step& step = program[i];
    for (std::size_t g = 0; g < step.goals; ++g) {
      push(literal(step.goal[g]));
      if (g > 0) push(both);
    }
    const Token token = token_of(step);
    if (step.kind == StepKind::Forward && (step.count < 1 || step.count > max_forward))
      throw std::invalid_argument("a program outside the decoder's language");
    push(token);
    if (i > 0) push(then);
  }
  push(end);
  return tokens;
}

Program PostfixGrammar::program_of(std::span<const Token> tokens) const {
  Program program;
  Step open;
  for (Token token : tokens) {
    if (token >= first_literal) {
      open.goal.at(open.goals++) = static_cast<std::uint16_t>(token - first_literal);
      continue;
    }
    if (token == both || token == then || token == end) continue;
    if (const auto kind = operator_of(token)) {
      open.kind = *kind;
    } else if (token >= first_forward) {
      open.kind = StepKind::Forward;
      open.count = static_cast<std::uint8_t>(token - first_forward + 1);
    } else {
      open.kind = token == stay ? StepKind::Stay : StepKind::Orient;
    }
    program.push_back(open);
    open = Step{};
  }
  return program;
}

std::string PostfixGrammar::show(const Program& program) const {
  std::string text;
  for (std::size_t i = 0; i < program.size(); ++i) {
    const Step& step = program[i];
    for (std::size_t g = 0; g < step.goals; ++g)
      text += (text.empty() ? "" : " ") + names_[literal(step.goal[g])] + (g > 0 ? " &" : "");
    text += (text.empty() ? "" : " ") + names_[token_of(step)] + (i > 0 ? " then" : "");
  }
  return text;
}

}  // namespace waymark::parser
