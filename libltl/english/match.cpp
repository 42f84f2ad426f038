#include "libltl/english/match.hpp"

#include <algorithm>
#include <vector>

namespace waymark::ltl {
namespace {

bool is_junction(Formula f) { return f.op() == Op::And || f.op() == Op::Or; }

// An atom with such words, or a choice of several.
bool has_words(Formula f, std::string Described::*words_of, std::span<const Described> words) {
  const auto named = [&](Formula g) { return g.op() == Op::Atom && !(words[g.proposition().index].*words_of).empty(); };
  if (f.op() != Op::Or) return named(f);
  return std::all_of(f.operands().begin(), f.operands().end(), named);
}

// Does the letter take as many operands of a junction as it can?
bool takes_many(Slot slot) {
  return slot == Slot::State || slot == Slot::LooseState || slot == Slot::Closed || slot == Slot::Tail;
}

class Matcher {
 public:
  explicit Matcher(std::span<const Described> words) : words_(words) {}

  bool match(Formula pattern, Formula f, Bindings& bound) const {
    if (pattern.op() == Op::Atom) return bind(letter_of(pattern), f, bound);
    if (pattern.op() != f.op()) return false;
    if (is_junction(pattern)) return junction(pattern, f, bound);
    if (pattern.op() == Op::Iff) return equivalence(pattern, f, bound);
    for (std::size_t i = 0; i < f.operands().size(); ++i)
      if (!match(pattern[i], f[i], bound)) return false;
    return true;
  }

 private:
  static char letter_of(Formula variable) { return static_cast<char>('a' + variable.proposition().index); }

  bool bind(char letter, Formula f, Bindings& bound) const {
    if (bound[letter]) return *bound[letter] == f;
    if (!fits(f, slot_of(letter), words_)) return false;
    bound[letter] = f;
    return true;
  }

  bool equivalence(Formula pattern, Formula f, Bindings& bound) const {
    for (const bool clause : {true, false})  // better a state clause in front than a letter
      for (const std::size_t first : {0U, 1U}) {
        Bindings trial = bound;
        if (!match(pattern[0], f[first], trial) || !match(pattern[1], f[1 - first], trial)) continue;
        if (clause && trial['x'] && !is_state_clause(*trial['x'])) continue;
        bound = trial;
        return true;
      }
    return false;
  }

  // Operands with operators first, then letters that take one operand, then states, then what takes the rest.
  bool junction(Formula pattern, Formula f, Bindings& bound) const {
    std::vector<Formula> wanted(pattern.operands().begin(), pattern.operands().end());
    const auto rank = [](Formula g) {
      if (g.op() != Op::Atom) return -1;
      const Slot slot = slot_of(letter_of(g));
      return !takes_many(slot) ? 0 : slot == Slot::State ? 1 : 2;
    };
    std::stable_sort(wanted.begin(), wanted.end(), [&](Formula a, Formula b) { return rank(a) < rank(b); });
    return assign(wanted, {f.operands().begin(), f.operands().end()}, f.op(), bound);
  }

  bool assign(std::span<const Formula> wanted, std::vector<Formula> left, Op op, Bindings& bound) const {
    if (wanted.empty()) return left.empty();
    const Formula first = wanted.front();
    const auto rest = wanted.subspan(1);
    if (first.op() == Op::Atom) {
      const char letter = letter_of(first);
      if (bound[letter]) return without(*bound[letter], left, op) && assign(rest, std::move(left), op, bound);
      if (takes_many(slot_of(letter))) return take_many(letter, rest, std::move(left), op, bound);
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
      Bindings trial = bound;
      if (!match(first, left[i], trial)) continue;
      auto others = left;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      if (!assign(rest, std::move(others), op, trial)) continue;
      bound = trial;
      return true;
    }
    return false;
  }

  bool take_many(char letter, std::span<const Formula> rest, std::vector<Formula> left, Op op, Bindings& bound) const {
    std::vector<Formula> taken = left;
    if (slot_of(letter) == Slot::State)
      std::erase_if(taken, [](Formula f) { return !is_state_clause(f); });
    else if (!rest.empty())
      return false;
    if (taken.empty()) return false;
    std::erase_if(left, [&](Formula f) { return std::find(taken.begin(), taken.end(), f) != taken.end(); });
    Arena& arena = taken.front().arena();
    const Formula whole = op == Op::And ? conjunction(arena, taken) : disjunction(arena, taken);
    return bind(letter, whole, bound) && assign(rest, std::move(left), op, bound);
  }

  // Takes what is bound, or its operands, out of `left`; false when they are not all there.
  static bool without(Formula known, std::vector<Formula>& left, Op op) {
    std::vector<Formula> parts = {known};
    if (known.op() == op) parts.assign(known.operands().begin(), known.operands().end());
    return std::all_of(parts.begin(), parts.end(), [&](Formula f) { return std::erase(left, f) == 1; });
  }

  std::span<const Described> words_;
};

}  // namespace

bool is_literal(Formula f) {
  const Op op = f.op() == Op::Not ? f[0].op() : f.op();
  return op == Op::Atom || op == Op::True || op == Op::False;
}

bool is_state_clause(Formula f) {
  if (is_literal(f)) return true;
  return is_junction(f) && std::all_of(f.operands().begin(), f.operands().end(), [](Formula g) {
           return is_literal(g) ||
                  (is_junction(g) && std::all_of(g.operands().begin(), g.operands().end(), is_literal));
         });
}

bool fits(Formula f, Slot slot, std::span<const Described> words) {
  switch (slot) {
    case Slot::State: return is_state_clause(f);
    case Slot::Literal: return is_literal(f);
    case Slot::Visit: return has_words(f, &Described::reach, words);
    case Slot::Enter: return has_words(f, &Described::enter, words);
    case Slot::Act: return has_words(f, &Described::act, words);
    case Slot::LooseState:
    case Slot::Closed:
    case Slot::Tail: return true;
  }
  return false;  // unreachable: -Werror=switch
}

std::optional<Bindings> match(const Phrase& phrase, Formula f, std::span<const Described> words) {
  Bindings bound;
  if (!Matcher(words).match(phrase.formula, f, bound)) return std::nullopt;
  return bound;
}

}  // namespace waymark::ltl
