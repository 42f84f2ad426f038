#include "libltl/trace_check.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace waymark::ltl {

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
  value_.resize(program_.size());
  carry_.resize(program_.size());
}

std::uint32_t TraceCheck::emit(Code code, std::uint32_t a, std::uint32_t b) {
  program_.push_back({code, a, b});
  // Past the end of the word N, R and G hold: the border of accepts_empty (progress.hpp).
  carry_at_end_.push_back(code == Code::WeakNext || code == Code::Release || code == Code::Globally ? 1 : 0);
  return static_cast<std::uint32_t>(program_.size() - 1);
}

std::uint32_t TraceCheck::compile(Formula f, std::span<const std::uint32_t> operands) {
  const auto chain = [&](Code code) {
    std::uint32_t out = operands[0];
    for (std::uint32_t operand : operands.subspan(1)) out = emit(code, out, operand);
    return out;
  };
  switch (f.op()) {
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

// One block. Without Carries it is the only one: the end of the word carries in, nothing is carried out.
template <bool Carries>
void TraceCheck::run(const std::uint64_t* columns) {
  std::uint64_t* const value = value_.data();
  std::uint64_t* const carry = carry_.data();
  const Step* const program = program_.data();
  const std::size_t count = program_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Step step = program[i];
    const auto in = [&](std::uint64_t at_end) { return Carries ? carry[i] : at_end; };
    const auto out = [&](std::uint64_t bits, std::uint64_t carried) {
      value[i] = bits;
      if (Carries) carry[i] = carried >> 63U;
    };
    const std::uint64_t a = step.code == Code::Load ? columns[step.a] : value[step.a];
    switch (step.code) {
      case Code::Load: value[i] = a; break;
      case Code::False: value[i] = 0; break;
      case Code::True: value[i] = ~std::uint64_t{0}; break;
      case Code::Not: value[i] = ~a; break;
      case Code::And: value[i] = a & value[step.b]; break;
      case Code::Or: value[i] = a | value[step.b]; break;
      case Code::Iff: value[i] = ~(a ^ value[step.b]); break;
      case Code::Next: out(a << 1U | in(0), a); break;
      case Code::WeakNext: out(a << 1U | in(1), a); break;
      case Code::Finally: {  // all bits when something was carried in
        const std::uint64_t bits = a | (0 - a) | (0 - in(0));
        out(bits, bits);
        break;
      }
      case Code::Globally: {  // the trailing ones of a, none when a zero came before
        const std::uint64_t bits = a & ~(a + 1) & (0 - in(1));
        out(bits, bits);
        break;
      }
      case Code::Until: {
        const std::uint64_t psi = value[step.b], either = a | psi;
        const std::uint64_t carries = (either + psi + in(0)) ^ either ^ psi;  // into each bit
        const std::uint64_t bits = psi | (a & carries);                       // out of each bit
        out(bits, bits);
        break;
      }
      case Code::Release: {
        const std::uint64_t psi = value[step.b], both = a & psi;
        const std::uint64_t carries = (psi + both + in(1)) ^ psi ^ both;
        const std::uint64_t bits = both | (psi & carries);
        out(bits, bits);
        break;
      }
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
