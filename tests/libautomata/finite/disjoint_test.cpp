// Products over disjoint alphabets against pairs and minimisation, and what is claimed of lengths against letters.
#include "libautomata/finite/disjoint.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/portfolio.hpp"
#include "libltl/limits.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/structure/substitute.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

namespace waymark::automata {
namespace {

using Reads = std::vector<ltl::Proposition>;

constexpr Verdict both = [](bool p, bool q) { return p && q; };
constexpr Verdict either = [](bool p, bool q) { return p || q; };
const Reads reads{{0}, {1}, {2}, {3}};

Transitions minimal(ltl::Formula f) {
  std::size_t made = 0;
  const ltl::Limits unlimited{SIZE_MAX, {}};
  return canonical(minimal_automaton(f, reads, unlimited, made));
}

// A random formula over two propositions.
ltl::Formula random_over(ltl::Random& random, ltl::Arena& arena, ltl::Proposition a, ltl::Proposition b) {
  ltl::Arena own(ltl::Vocabulary({"x", "y"}));
  const ltl::Formula f = ltl::random_formula(random, own, {.size = 1 + random.below(12), .atoms = 2});
  return ltl::substitute(f, arena, [&](ltl::Proposition p) { return arena.atom(p.index == 0 ? a : b); });
}

std::uint32_t next(const Transitions& automaton, std::uint32_t q, std::size_t letter) {
  const auto holds = [&](Mtbdd::Variable v) { return ((letter >> v) & 1U) != 0; };
  return Mtbdd::payload(automaton.diagram.evaluate(automaton.roots[q], holds));
}

bool comes_back(const Transitions& automaton) {
  for (std::uint32_t q = 0; q < automaton.roots.size(); ++q)
    for (std::size_t letter = 0; letter < 16; ++letter)
      if (next(automaton, q, letter) == automaton.initial) return true;
  return false;
}

// L(q, n) as a number, letter by letter: 0 for no word, 1 for every word, others by the numbers after each letter.
std::vector<std::size_t> at_length(const Transitions& automaton, int n) {
  std::vector<std::size_t> of(automaton.accepting.begin(), automaton.accepting.end());
  for (; n > 0; --n) {
    std::map<std::vector<std::size_t>, std::size_t> names{{std::vector<std::size_t>(16, 0), 0},
                                                          {std::vector<std::size_t>(16, 1), 1}};
    std::vector<std::size_t> longer;
    for (std::uint32_t q = 0; q < of.size(); ++q) {
      std::vector<std::size_t> after;
      for (std::size_t letter = 0; letter < 16; ++letter) after.push_back(of[next(automaton, q, letter)]);
      longer.push_back(names.try_emplace(after, names.size()).first->second);
    }
    of = longer;
  }
  return of;
}

// Of states with different diagrams.
bool told_apart_at(const Transitions& automaton, int n) {
  const std::vector<std::size_t> of = at_length(automaton, n);
  std::map<std::size_t, Mtbdd::Node> seen;
  for (std::uint32_t q = 0; q < of.size(); ++q) {
    if (q == automaton.initial && !comes_back(automaton)) continue;
    const Mtbdd::Node root = automaton.roots[q];
    const auto leads_to_sink = [&](bool accepting) {
      return Mtbdd::is_terminal(root) && automaton.roots[Mtbdd::payload(root)] == root &&
             automaton.accepting[Mtbdd::payload(root)] == accepting;
    };
    if (of[q] < 2 && !leads_to_sink(of[q] == 1)) return false;
    if (seen.try_emplace(of[q], root).first->second != root) return false;
  }
  return true;
}

bool reached_at(const Transitions& automaton, int n) {
  std::set<std::uint32_t> here{automaton.initial};
  for (; n > 0; --n) {
    std::set<std::uint32_t> after;
    for (const std::uint32_t q : here)
      for (std::size_t letter = 0; letter < 16; ++letter) after.insert(next(automaton, q, letter));
    here = after;
  }
  return here.size() == automaton.roots.size() - (comes_back(automaton) ? 0 : 1);
}

bool same(const Transitions& a, const Transitions& b) {  // canonical ones
  if (a.roots != b.roots || a.accepting != b.accepting || a.diagram.size() != b.diagram.size()) return false;
  for (const Mtbdd::Node n : a.diagram.reachable(a.roots))
    if (a.diagram.variable(n) != b.diagram.variable(n) || a.diagram.low(n) != b.diagram.low(n) ||
        a.diagram.high(n) != b.diagram.high(n))
      return false;
  return true;
}

TEST(Disjoint, WhatHoldsAtEachLengthHoldsLetterByLetter) {
  constexpr int far = 60;  // longer than any length at which these automata change their behaviour
  ltl::Random random(21);
  std::size_t apart = 0, reached = 0;
  for (int i = 0; i < 600; ++i) {
    ltl::Arena arena(ltl::Vocabulary({"a", "b", "c", "d"}));
    const ltl::Formula f = random_over(random, arena, {0}, {1});
    const Transitions automaton = minimal(f);
    Budget unlimited;
    const AtEachLength claimed = at_each_length(automaton, unlimited);
    for (int n = far; n < far + 3; ++n) {
      ASSERT_EQ(claimed.told_apart, told_apart_at(automaton, n)) << ltl::print(f) << " at length " << n;
      ASSERT_TRUE(!claimed.reached || reached_at(automaton, n)) << ltl::print(f) << " at length " << n;
    }
    apart += claimed.told_apart ? 1 : 0;
    reached += claimed.reached ? 1 : 0;
  }
  EXPECT_GT(apart, 200U);
  EXPECT_GT(reached, 100U);
}

TEST(Disjoint, ProductsAreMinimalAndThoseOfPairs) {
  ltl::Random random(22);
  std::size_t copied = 0, shared_roots = 0;
  for (int i = 0; i < 1500; ++i) {
    ltl::Arena arena(ltl::Vocabulary({"a", "b", "c", "d"}));
    const bool mixed = random.chance(0.3);  // a, c and b, d
    const ltl::Formula f = random_over(random, arena, {0}, {mixed ? 2U : 1U});
    const ltl::Formula g = random_over(random, arena, {mixed ? 1U : 2U}, {3});
    const Transitions a = minimal(f), b = minimal(g);
    Budget unlimited;
    const AtEachLength of_a = at_each_length(a, unlimited), of_b = at_each_length(b, unlimited);
    if (!of_a.told_apart || !of_b.told_apart) continue;
    for (const Verdict verdict : {both, either}) {
      const Transitions expected = canonical(minimize(product(a, b, verdict, unlimited), unlimited));
      const bool own_roots = of_a.own_roots && of_b.own_roots;
      Transitions pairs = product(a, b, verdict, unlimited, own_roots ? Alphabets::Disjoint : Alphabets::Any);
      merge_initial(pairs, unlimited);
      ASSERT_TRUE(same(canonical(pairs), expected)) << ltl::print(f) << "  and  " << ltl::print(g);
      shared_roots += own_roots ? 0 : 1;
      if (mixed || !own_roots || !of_a.reached || !of_b.reached) continue;
      Transitions copies = disjoint_product(a, b, verdict, unlimited);
      merge_initial(copies, unlimited);
      ASSERT_TRUE(same(canonical(copies), expected)) << ltl::print(f) << "  and  " << ltl::print(g);
      const AtEachLength again = at_each_length(canonical(copies), unlimited);
      ASSERT_TRUE(again.told_apart && again.reached && again.own_roots) << ltl::print(f) << "  and  " << ltl::print(g);
      ++copied;
    }
  }
  EXPECT_GT(copied, 100U);
  EXPECT_GT(shared_roots, 100U);
}

TEST(Disjoint, TheInitialStateMayBeAnother) {
  ltl::Arena arena(ltl::Vocabulary({"a", "b", "c", "d"}));
  const Transitions first = minimal(ltl::parse("G (a -> F b)", arena)), second = minimal(ltl::parse("F c", arena));
  Budget unlimited;
  Transitions made = disjoint_product(first, second, both, unlimited);
  const std::size_t before = made.roots.size();
  merge_initial(made, unlimited);
  EXPECT_EQ(before, 5U) << "the pairs, and the initial one to which no word comes back";
  EXPECT_EQ(made.roots.size(), 4U) << "which rejects as the pair of satisfied and waiting does";
}

TEST(Disjoint, RunsOutOfStatesBeforeTheyAreMade) {
  ltl::Arena arena(ltl::Vocabulary({"a", "b", "c", "d"}));
  const Transitions first = minimal(ltl::parse("F a & F b", arena)), second = minimal(ltl::parse("F c & F d", arena));
  Budget few(SIZE_MAX, 10, {});
  EXPECT_THROW(disjoint_product(first, second, both, few), Budget::Exceeded);
}

}  // namespace
}  // namespace waymark::automata
