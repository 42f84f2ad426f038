#include "libltl/structure/random.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

namespace waymark::ltl {
namespace {

Formula leaf(Random& random, Arena& arena, const RandomFormula& options) {
  const std::size_t choice = random.below(options.atoms + (options.constants ? 1 : 0));
  if (choice < options.atoms) return arena.atom(Proposition{static_cast<std::uint32_t>(choice)});
  return arena.constant(random.below(2) == 1);
}

Formula unary(Random& random, Formula f, bool weak) {
  // F and G as often as the others: they are what people write, and true U φ alone would be rare.
  switch (random.below(weak ? 5 : 4)) {
    case 0: return negate(f);
    case 1: return next(f);
    case 2: return eventually(f);
    case 3: return always(f);
    default: return weak_next(f);
  }
}

Formula past_unary(Random& random, Formula f) {
  switch (random.below(4)) {
    case 0: return yesterday(f);
    case 1: return weak_yesterday(f);
    case 2: return once(f);
    default: return historically(f);
  }
}

Formula binary(Random& random, Formula a, Formula b) {
  switch (random.below(7)) {
    case 0: return conjunction(a, b);
    case 1: return disjunction(a, b);
    case 2: return iff(a, b);
    case 3: return until(a, b);
    case 4: return release(a, b);
    case 5: return weak_until(a, b);
    default: return strong_release(a, b);
  }
}

Formula of_size(Random& random, Arena& arena, const RandomFormula& options, std::size_t size) {
  if (size <= 1) return leaf(random, arena, options);
  // size 2 leaves no room for two operands
  const bool past = options.past && random.below(3) == 0;
  if (size == 2 || random.below(2) == 0) {
    const Formula f = of_size(random, arena, options, size - 1);
    return past ? past_unary(random, f) : unary(random, f, options.weak_next);
  }
  const std::size_t left = 1 + random.below(size - 2);
  const Formula a = of_size(random, arena, options, left);
  const Formula b = of_size(random, arena, options, size - 1 - left);
  if (past) return random.below(2) == 0 ? since(a, b) : triggered(a, b);
  return binary(random, a, b);
}

std::vector<Letter> letters(Random& random, std::size_t count, const RandomWord& options) {
  std::vector<Letter> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(random_letter(random, options));
  return out;
}

}  // namespace

// Lemire's multiplication would be faster; rejection is exact and plain.
std::size_t Random::below(std::size_t n) {
  const std::uint64_t range = n;
  const std::uint64_t limit = std::mt19937_64::max() - std::mt19937_64::max() % range;
  std::uint64_t draw = engine_();
  while (draw >= limit) draw = engine_();
  return static_cast<std::size_t>(draw % range);
}

double Random::unit() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }

Formula random_formula(Random& random, Arena& arena, const RandomFormula& options) {
  if (arena.vocabulary().size() < options.atoms)
    throw std::invalid_argument("random_formula: the vocabulary has fewer propositions than asked for");
  if (options.atoms == 0 && !options.constants) throw std::invalid_argument("random_formula: no leaf is allowed");
  return of_size(random, arena, options, options.size);
}

Letter random_letter(Random& random, const RandomWord& options) {
  Letter out;
  for (std::size_t p = 0; p < options.atoms; ++p)
    if (random.chance(options.density)) out.insert(Proposition{static_cast<std::uint32_t>(p)});
  return out;
}

Trace random_trace(Random& random, const RandomWord& options) {
  return Trace(letters(random, options.length, options));
}

Lasso random_lasso(Random& random, const RandomWord& options) {
  std::vector<Letter> prefix = letters(random, options.prefix, options);
  return Lasso(std::move(prefix), letters(random, options.cycle, options));
}

}  // namespace waymark::ltl
