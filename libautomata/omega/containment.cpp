#include "libautomata/omega/containment.hpp"

#include <stdexcept>

#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/walk.hpp"

namespace waymark::automata {

using ltl::Formula;
using ltl::Op;
namespace {

// On which letters of the lassos a proposition holds: each time the same, for the same formula has the same automaton.
// One step of SplitMix64 [SLF14].
std::uint64_t letters_with(ltl::Proposition p) {
  std::uint64_t bits = (std::uint64_t{p.index} + 1) * 0x9E3779B97F4A7C15U;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31U);
}

}  // namespace

Containment::Containment(const std::vector<ltl::Proposition>& reads, Budget& budget) : reads_(reads), budget_(budget) {
  static_assert(lassos * letters == 64, "a bit for each letter");
  for (std::size_t i = 0; i < lassos; ++i) {
    const std::size_t start = i % letters;
    for (std::size_t j = 0; j < letters; ++j)
      successor_[letters * i + j] = static_cast<std::uint8_t>(letters * i + (j + 1 < letters ? j + 1 : start));
  }
}

bool Containment::operator()(Formula from, Formula to) {
  if (spent_ || (verdict(from) & ~verdict(to)) != 0) return false;
  const auto [at, fresh] = known_.try_emplace(std::uint64_t{from.id()} << 32U | to.id(), false);
  if (fresh) at->second = prove(from, to);
  return at->second;
}

bool Containment::prove(Formula from, Formula to) {
  const Formula both = ltl::nnf(conjunction(from, negate(to)));
  for (const bool afresh : {false, true}) {  // many questions may promise more than there are marks
    if (!satisfiable_ || afresh) satisfiable_.emplace(from.arena(), reads_, budget_);
    try {
      return !(*satisfiable_)(both);
    } catch (const Budget::Exceeded& spent) {
      if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
      if (spent.reason == Budget::Exceeded::Reason::Steps) break;
    }
  }
  spent_ = true;
  satisfiable_.reset();
  return false;
}

std::uint64_t Containment::verdict(Formula f) {
  if (const auto known = verdicts_.find(f); known != verdicts_.end()) return known->second;
  for (Formula g : ltl::unknown_subformulas(f, [&](Formula h) { return verdicts_.contains(h); }))
    verdicts_.emplace(g, compute(g));
  return verdicts_.at(f);
}

std::uint64_t Containment::next(std::uint64_t bits) const {
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < successor_.size(); ++i) out |= (bits >> successor_[i] & 1U) << i;
  return out;
}

std::uint64_t Containment::compute(Formula f) {
  const auto at = [&](std::size_t i) { return verdicts_.at(f[i]); };
  const auto all = [&](std::uint64_t unit, bool conjunctive) {
    for (Formula g : f.operands()) unit = conjunctive ? unit & verdicts_.at(g) : unit | verdicts_.at(g);
    return unit;
  };
  switch (f.op()) {
    case Op::Yesterday:
    case Op::Since: throw std::logic_error("a suffix of a word has no past");
    case Op::False: return 0;
    case Op::True: return ~std::uint64_t{0};
    case Op::Atom: return letters_with(f.proposition());
    case Op::Not: return ~at(0);
    case Op::And: return all(~std::uint64_t{0}, true);
    case Op::Or: return all(0, false);
    case Op::Iff: return ~(at(0) ^ at(1));
    case Op::Next:
    case Op::WeakNext: return next(at(0));
    case Op::Until: {  // least fixpoint, from below
      std::uint64_t x = at(1);
      for (std::uint64_t before = ~x; before != x;) {
        before = x;
        x = at(1) | (at(0) & next(x));
      }
      return x;
    }
    case Op::Release: {  // greatest fixpoint, from above
      std::uint64_t x = at(1);
      for (std::uint64_t before = ~x; before != x;) {
        before = x;
        x = at(1) & (at(0) | next(x));
      }
      return x;
    }
  }
  return 0;  // unreachable: -Werror=switch
}

}  // namespace waymark::automata
