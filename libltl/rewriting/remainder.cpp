#include "libltl/rewriting/remainder.hpp"

#include <algorithm>

#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/simplify.hpp"

namespace waymark::ltl {
namespace {

constexpr std::size_t few_parts = 8;  // that are simplified together
constexpr std::size_t most_steps = 100'000;

}  // namespace

Remainder::Remainder(Formula f, Semantics semantics) : semantics_(semantics), rest_(f) {
  if (f.op() == Op::And && f.operands().size() > few_parts) parts_.assign(f.operands().begin(), f.operands().end());
}

Formula Remainder::read(const Letter& letter) {
  if (parts_.empty()) return rest_ = simplified(rest_, letter);
  if (known_.size() > most_steps) known_.clear();
  for (Formula& part : parts_) part = step(part, letter);
  return conjunction(rest_.arena(), parts_);
}

Formula Remainder::step(Formula part, const Letter& letter) {
  if (part.operands().empty() && part.op() != Op::Atom) return part;  // decided
  std::pair<std::uint32_t, std::vector<bool>> key{part.id(), {}};
  for (const Proposition p : propositions(part)) key.second.push_back(letter.contains(p));
  const auto [at, fresh] = known_.emplace(std::move(key), part);
  if (fresh) at->second = simplified(part, letter);
  return at->second;
}

Formula Remainder::simplified(Formula part, const Letter& letter) const {
  const Over over = semantics_ == Semantics::Finite ? Over::Rest : Over::Infinite;
  return simplify(progress(part, letter, semantics_), over);
}

}  // namespace waymark::ltl
