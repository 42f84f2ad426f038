#include "libltl/meaning/trace_check.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace waymark::ltl {
namespace {

struct Bits {
  std::uint64_t truth, out;  // the truth at each position, and the word whose top bit is carried out
};

// The temporal operators on words: φ, ψ (where there is one), and what is carried in.
Bits next_bits(std::uint64_t phi, std::uint64_t, std::uint64_t in) { return {phi << 1U | in, phi}; }

// From the lowest set bit up; all bits when something was carried in.
Bits finally_bits(std::uint64_t phi, std::uint64_t, std::uint64_t in) {
  const std::uint64_t truth = phi | (0 - phi) | (0 - in);
  return {truth, truth};
}

// The trailing ones; none when a zero came before.
Bits globally_bits(std::uint64_t phi, std::uint64_t, std::uint64_t in) {
  const std::uint64_t truth = phi & ~(phi + 1) & (0 - in);
  return {truth, truth};
}

// ψ, or φ and a carry into this bit.
Bits until_bits(std::uint64_t phi, std::uint64_t psi, std::uint64_t in) {
  const std::uint64_t either = phi | psi;
  const std::uint64_t truth = psi | (phi & ((either + psi + in) ^ either ^ psi));
  return {truth, truth};
}

// ψ, and φ or a carry into this bit.
Bits release_bits(std::uint64_t phi, std::uint64_t psi, std::uint64_t in) {
  const std::uint64_t both = phi & psi;
  const std::uint64_t truth = both | (psi & ((psi + both + in) ^ psi ^ both));
  return {truth, truth};
}

}  // namespace

Columns::Columns(const Trace& word, std::size_t propositions)
    : propositions_(propositions), length_(word.size()), bits_(blocks() * propositions) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    const std::size_t bit = word.size() - 1 - i;
    for (Proposition p : word[i].members())
      if (p.index < propositions) bits_[bit / 64 * propositions + p.index] |= std::uint64_t{1} << (bit % 64);
  }
}

void Columns::append(const Letter& letter) {
  ++length_;
  bits_.resize(blocks() * propositions_);
  for (std::size_t b = blocks(); b-- > 0;)
    for (std::size_t p = 0; p < propositions_; ++p) {
      std::uint64_t& bits = bits_[b * propositions_ + p];
      const std::uint64_t entering =
          b > 0 ? bits_[(b - 1) * propositions_ + p] >> 63U : (letter.block(p / 64) >> (p % 64)) & 1U;
      bits = bits << 1U | entering;
    }
}

void Columns::clear() {
  length_ = 0;
  bits_.clear();
}

TraceCheck::TraceCheck(std::span<const Formula> formulas) {
  if (formulas.empty()) throw std::invalid_argument("a trace check needs a formula");
  std::vector<Formula> all;
  for (Formula f : formulas) {
    const std::vector<Formula> below = subformulas(f);
    all.insert(all.end(), below.begin(), below.end());
  }
  std::sort(all.begin(), all.end());  // operands have smaller ids
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::unordered_map<Formula, std::uint32_t> step;
  std::vector<std::uint32_t> operands;
  for (Formula f : all) {
    operands.clear();
    for (Formula operand : f.operands()) operands.push_back(step.at(operand));
    step.emplace(f, compile(f, operands));
  }
  for (Formula f : formulas) roots_.push_back(step.at(f));
  schedule();
  value_.resize(program_.size());
  carry_.resize(program_.size());
  // Past the end of the word N, R and G hold: the border of accepts_empty (progress.hpp).
  for (const Instruction& s : program_)
    carry_at_end_.push_back(s.code == Code::WeakNext || s.code == Code::Release || s.code == Code::Globally ? 1 : 0);
}

std::uint32_t TraceCheck::emit(Code code, std::uint32_t a, std::uint32_t b) {
  program_.push_back({code, a, b});
  return static_cast<std::uint32_t>(program_.size() - 1);
}

std::uint32_t TraceCheck::compile(Formula f, std::span<const std::uint32_t> operands) {
  const auto chain = [&](Code code) {
    std::uint32_t out = operands[0];
    for (std::uint32_t operand : operands.subspan(1)) out = emit(code, out, operand);
    return out;
  };
  switch (f.op()) {
    case Op::Yesterday:
    case Op::Since: throw std::invalid_argument("a trace check has no past operators, such as Y and S: see holds");
    case Op::False: return emit(Code::False);
    case Op::True: return emit(Code::True);
    case Op::Atom:
      propositions_ = std::max<std::size_t>(propositions_, f.proposition().index + 1);
      return emit(Code::Load, f.proposition().index);
    case Op::Not: return emit(Code::Not, operands[0]);
    case Op::And: return chain(Code::And);
    case Op::Or: return chain(Code::Or);
    case Op::Iff: return emit(Code::Iff, operands[0], operands[1]);
    case Op::Next: return emit(Code::Next, operands[0]);
    case Op::WeakNext: return emit(Code::WeakNext, operands[0]);
    case Op::Until:
      if (f[0].op() == Op::True) return emit(Code::Finally, operands[1]);
      return emit(Code::Until, operands[0], operands[1]);
    case Op::Release:
      if (f[0].op() == Op::False) return emit(Code::Globally, operands[1]);
      return emit(Code::Release, operands[0], operands[1]);
  }
  return 0;  // unreachable: -Werror=switch
}

std::size_t TraceCheck::arity(Code code) {
  switch (code) {
    case Code::Load:
    case Code::False:
    case Code::True: return 0;
    case Code::Not:
    case Code::Next:
    case Code::WeakNext:
    case Code::Finally:
    case Code::Globally: return 1;
    case Code::And:
    case Code::Or:
    case Code::Iff:
    case Code::Until:
    case Code::Release: return 2;
  }
  return 0;  // unreachable: -Werror=switch
}

// The steps that a formula's answer depends on (the true of true U φ is none: F has a code of its own).
std::vector<bool> TraceCheck::needed() const {
  std::vector<bool> out(program_.size());
  for (std::uint32_t root : roots_) out[root] = true;
  for (std::size_t i = program_.size(); i-- > 0;) {
    if (!out[i]) continue;
    if (arity(program_[i].code) > 0) out[program_[i].a] = true;
    if (arity(program_[i].code) > 1) out[program_[i].b] = true;
  }
  return out;
}

// Operands first, and as few changes of code as a greedy choice gives: always the code of which most is ready.
std::vector<std::uint32_t> TraceCheck::order_by_code(const std::vector<bool>& needed) const {
  std::vector<std::size_t> missing(program_.size());
  std::vector<std::vector<std::uint32_t>> users(program_.size());
  std::array<std::vector<std::uint32_t>, static_cast<std::size_t>(Code::Globally) + 1> ready;
  const auto queue = [&](std::uint32_t i) -> auto& { return ready[static_cast<std::size_t>(program_[i].code)]; };
  for (std::uint32_t i = 0; i < program_.size(); ++i) {
    if (!needed[i]) continue;
    missing[i] = arity(program_[i].code);
    if (missing[i] > 0) users[program_[i].a].push_back(i);
    if (missing[i] > 1) users[program_[i].b].push_back(i);
    if (missing[i] == 0) queue(i).push_back(i);
  }
  std::vector<std::uint32_t> out;
  const auto shorter = [](const auto& x, const auto& y) { return x.size() < y.size(); };
  while (true) {
    auto& most = *std::max_element(ready.begin(), ready.end(), shorter);
    if (most.empty()) return out;
    for (std::size_t k = 0; k < most.size(); ++k) {  // grows when a step makes one of its own code ready
      out.push_back(most[k]);
      for (std::uint32_t user : users[out.back()])
        if (--missing[user] == 0) queue(user).push_back(user);
    }
    most.clear();
  }
}

void TraceCheck::schedule() {
  const std::vector<std::uint32_t> order = order_by_code(needed());
  std::vector<std::uint32_t> moved(program_.size());
  std::vector<Instruction> program;
  for (std::uint32_t i : order) {
    Instruction step = program_[i];
    const auto at = static_cast<std::uint32_t>(program.size());
    moved[i] = at;
    if (arity(step.code) > 0) step.a = moved[step.a];
    if (arity(step.code) > 1) step.b = moved[step.b];
    program.push_back(step);
    if (runs_.empty() || runs_.back().code != step.code) runs_.push_back({step.code, at, at});
    runs_.back().end = at + 1;
  }
  program_ = std::move(program);
  for (std::uint32_t& root : roots_) root = moved[root];
}

// One block. Without Carries it is the only one: the end of the word carries in, nothing is carried out.
template <bool Carries>
void TraceCheck::run(const std::uint64_t* columns) {
  std::uint64_t* const value = value_.data();
  std::uint64_t* const carry = carry_.data();
  const Instruction* const program = program_.data();
  for (const Run run : runs_) {
    const auto each = [&](auto&& truth) {
      for (std::uint32_t i = run.begin; i < run.end; ++i) value[i] = truth(program[i]);
    };
    const auto temporal = [&](std::uint64_t at_end, auto&& bits_of) {
      for (std::uint32_t i = run.begin; i < run.end; ++i) {
        const Instruction& s = program[i];  // s.b is 0 where there is no ψ: read and not used
        const Bits bits = bits_of(value[s.a], value[s.b], Carries ? carry[i] : at_end);
        value[i] = bits.truth;
        if (Carries) carry[i] = bits.out >> 63U;
      }
    };
    switch (run.code) {
      case Code::Load: each([&](const Instruction& s) { return columns[s.a]; }); break;
      case Code::False: each([](const Instruction&) { return std::uint64_t{0}; }); break;
      case Code::True: each([](const Instruction&) { return ~std::uint64_t{0}; }); break;
      case Code::Not: each([&](const Instruction& s) { return ~value[s.a]; }); break;
      case Code::And: each([&](const Instruction& s) { return value[s.a] & value[s.b]; }); break;
      case Code::Or: each([&](const Instruction& s) { return value[s.a] | value[s.b]; }); break;
      case Code::Iff: each([&](const Instruction& s) { return ~(value[s.a] ^ value[s.b]); }); break;
      case Code::Next: temporal(0, next_bits); break;
      case Code::WeakNext: temporal(1, next_bits); break;
      case Code::Finally: temporal(0, finally_bits); break;
      case Code::Globally: temporal(1, globally_bits); break;
      case Code::Until: temporal(0, until_bits); break;
      case Code::Release: temporal(1, release_bits); break;
    }
  }
}

void TraceCheck::demand(std::size_t propositions, std::size_t length) const {
  if (length == 0) throw std::invalid_argument("a finite word has at least one letter");
  if (propositions < propositions_) throw std::invalid_argument("a proposition of the formula has no column");
}

void TraceCheck::run_all(const Columns& word) {
  if (word.blocks() == 1) return run<false>(word.block(0).data());
  std::copy(carry_at_end_.begin(), carry_at_end_.end(), carry_.begin());
  for (std::size_t b = 0; b < word.blocks(); ++b) run<true>(word.block(b).data());
}

bool TraceCheck::operator()(std::span<const std::uint64_t> columns, std::size_t length) {
  demand(columns.size(), length);
  if (length > 64) throw std::invalid_argument("more than 64 positions need Columns");
  run<false>(columns.data());
  return ((value_[roots_[0]] >> (length - 1)) & 1U) != 0;
}

bool TraceCheck::operator()(const Columns& word) {
  demand(word.propositions(), word.length());
  run_all(word);
  return ((value_[roots_[0]] >> ((word.length() - 1) % 64)) & 1U) != 0;
}

void TraceCheck::check(const Columns& word, std::span<bool> verdicts) {
  demand(word.propositions(), word.length());
  if (verdicts.size() != roots_.size()) throw std::invalid_argument("one verdict for each formula");
  run_all(word);
  for (std::size_t i = 0; i < roots_.size(); ++i)
    verdicts[i] = ((value_[roots_[i]] >> ((word.length() - 1) % 64)) & 1U) != 0;
}

void TraceCheck::at_every_position(const Columns& word, std::size_t which, std::span<std::uint64_t> truth) {
  demand(word.propositions(), word.length());
  if (truth.size() != word.blocks()) throw std::invalid_argument("one word of truth for each block");
  std::copy(carry_at_end_.begin(), carry_at_end_.end(), carry_.begin());
  for (std::size_t b = 0; b < word.blocks(); ++b) {
    run<true>(word.block(b).data());
    truth[b] = value_[roots_.at(which)];
  }
}

}  // namespace waymark::ltl
