#include "libltl/meaning/progress.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace waymark::ltl {
namespace {

// The subformulas that are read now: those not below a next, and with past operators all. Operands before operators.
std::vector<Formula> read_now(Formula f, bool past) {
  std::vector<Formula> out, stack{f};
  std::unordered_set<Formula> seen{f};
  while (!stack.empty()) {
    const Formula g = stack.back();
    stack.pop_back();
    out.push_back(g);
    if (!past && (g.op() == Op::Next || g.op() == Op::WeakNext)) continue;
    for (Formula operand : g.operands())
      if (seen.insert(operand).second) stack.push_back(operand);
  }
  std::sort(out.begin(), out.end());  // operands have smaller ids
  return out;
}

// What a formula becomes when a letter is read: `now`, what must hold of the rest for the formula to hold at the
// letter; `later`, what holds at a position of the rest exactly where the formula does at that position of the whole
// word. A formula without past operators is its own `later`.
struct Images {
  Formula now, later;
};

class Progression {
 public:
  Progression(Formula f, const Letter& letter, Semantics semantics)
      : arena_(f.arena()), letter_(letter), finite_(semantics == Semantics::Finite), past_(has_past(f)) {
    for (Formula g : read_now(f, past_)) {
      now_.clear();
      later_.clear();
      for (Formula operand : g.operands()) {
        const auto known = image_.find(operand);  // none: below a next
        now_.push_back(known == image_.end() ? operand : known->second.now);
        later_.push_back(known == image_.end() ? operand : known->second.later);
      }
      image_.emplace(g, images(g));
    }
  }
  Formula of(Formula f) const { return image_.at(f).now; }

 private:
  template <class Make>
  Formula later(Formula f, const Make& make) const {
    return past_ ? make() : f;
  }

  Images images(Formula f) {
    switch (f.op()) {
      case Op::False:
      case Op::True: return {f, f};
      case Op::Atom: return {arena_.constant(letter_.contains(f.proposition())), f};
      case Op::Not: return {negate(now_[0]), later(f, [&] { return negate(later_[0]); })};
      case Op::And: return {conjunction(arena_, now_), later(f, [&] { return conjunction(arena_, later_); })};
      case Op::Or: return {disjunction(arena_, now_), later(f, [&] { return disjunction(arena_, later_); })};
      case Op::Iff: return {iff(now_[0], now_[1]), later(f, [&] { return iff(later_[0], later_[1]); })};
      case Op::Next:
        return {finite_ ? conjunction(later_[0], eventually(arena_.constant(true))) : later_[0],
                later(f, [&] { return next(later_[0]); })};
      case Op::WeakNext:
        return {finite_ ? disjunction(later_[0], always(arena_.constant(false))) : later_[0],
                later(f, [&] { return weak_next(later_[0]); })};
      case Op::Until: {
        const Formula rest = later(f, [&] { return until(later_[0], later_[1]); });
        return {disjunction(now_[1], conjunction(now_[0], rest)), rest};
      }
      case Op::Release: {
        const Formula rest = later(f, [&] { return release(later_[0], later_[1]); });
        return {conjunction(now_[1], disjunction(now_[0], rest)), rest};
      }
      case Op::Yesterday: return {arena_.constant(false), disjunction(yesterday(later_[0]), at_first(now_[0]))};
      case Op::Since: {
        const Formula held = at_first(conjunction(later_[0], now_[1]));
        return {now_[1], since(later_[0], disjunction(later_[1], held))};
      }
    }
    return {f, f};  // unreachable: -Werror=switch
  }

  // φ at the first position of the rest, whose letter before is the one that was read. ¬Y true says "first".
  Formula at_first(Formula f) const { return conjunction(negate(yesterday(arena_.constant(true))), f); }

  Arena& arena_;
  const Letter& letter_;
  bool finite_, past_;
  std::vector<Formula> now_, later_;  // of the operands
  std::unordered_map<Formula, Images> image_;
};

}  // namespace

Formula progress(Formula f, const Letter& letter, Semantics semantics) {
  return Progression(f, letter, semantics).of(f);
}

bool accepts_empty(Formula f) {
  std::unordered_map<Formula, bool> value;
  const auto at = [&](Formula g) { return value.at(g); };
  for (Formula g : subformulas(f)) {
    const auto operands = g.operands();
    const bool accepts = [&] {
      switch (g.op()) {
        case Op::False:
        case Op::Atom:
        case Op::Next:
        case Op::Until:
        case Op::Yesterday:
        case Op::Since: return false;
        case Op::True:
        case Op::WeakNext:
        case Op::Release: return true;
        case Op::Not: return !at(g[0]);
        case Op::And: return std::all_of(operands.begin(), operands.end(), at);
        case Op::Or: return std::any_of(operands.begin(), operands.end(), at);
        case Op::Iff: return at(g[0]) == at(g[1]);
      }
      return false;  // unreachable: -Werror=switch
    }();
    value.emplace(g, accepts);
  }
  return value.at(f);
}

}  // namespace waymark::ltl
