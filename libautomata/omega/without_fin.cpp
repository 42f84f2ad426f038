#include "libautomata/omega/without_fin.hpp"

#include <algorithm>

#include "libautomata/omega/scc_filter.hpp"

namespace waymark::automata {
namespace {

// A clause that asks for more than another one adds nothing.
std::vector<Clause> fewest(const std::vector<Clause>& all, Budget& budget) {
  std::vector<Clause> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    budget.step(1 + all.size() / 16);
    const auto implied = [&](const Clause& c) {
      return all[i].finitely.includes(c.finitely) && all[i].infinitely.includes(c.infinitely);
    };
    bool needed = (all[i].finitely & all[i].infinitely).empty();
    for (std::size_t j = 0; j < all.size() && needed; ++j) {
      const bool same = all[i].finitely == all[j].finitely && all[i].infinitely == all[j].infinitely;
      needed = i == j || !implied(all[j]) || (same && i < j);
    }
    if (needed) out.push_back(all[i]);
  }
  return out;
}

}  // namespace

std::vector<Clause> clauses(const Condition& condition, Budget& budget) {
  switch (condition.op()) {
    case Condition::Op::True: return {{}};
    case Condition::Op::False: return {};
    case Condition::Op::Inf: return {{{}, Marks::of(condition.mark())}};
    case Condition::Op::Fin: return {{Marks::of(condition.mark()), {}}};
    case Condition::Op::Or: {
      std::vector<Clause> out;
      for (const Condition& operand : condition.operands())
        for (const Clause& c : clauses(operand, budget)) out.push_back(c);
      return fewest(out, budget);
    }
    case Condition::Op::And: {
      std::vector<Clause> out{{}};
      for (const Condition& operand : condition.operands()) {
        std::vector<Clause> both;
        for (const Clause& c : clauses(operand, budget))
          for (const Clause& d : out) both.push_back({c.finitely | d.finitely, c.infinitely | d.infinitely});
        out = fewest(both, budget);
      }
      return out;
    }
  }
  return {};  // unreachable: -Werror=switch
}

TransitionRelation without_fin(const TransitionRelation& automaton, Budget& budget) {
  if (automaton.acceptance.is_generalized_buchi()) return automaton;
  const std::vector<Clause> all = clauses(automaton.acceptance.condition, budget);
  const auto states = static_cast<std::uint32_t>(automaton.states());
  std::uint32_t sets = 1;  // the copy in which nothing was picked accepts nothing
  for (const Clause& c : all) sets = std::max(sets, c.infinitely.count());
  const auto marks_in = [&](const Clause& c, Marks marks) {
    const std::vector<std::uint32_t> wanted = c.infinitely.members();
    Marks out = Marks::first(sets).without(Marks::first(static_cast<std::uint32_t>(wanted.size())));
    for (std::uint32_t i = 0; i < wanted.size(); ++i)
      if (marks.contains(wanted[i])) out = out | Marks::of(i);
    return out;
  };
  TransitionRelation out;
  out.initial = automaton.initial;
  out.acceptance = Acceptance::generalized_buchi(sets);
  RootCopier copier(automaton, out);
  for (std::uint32_t copy = 0; copy <= all.size(); ++copy)  // the first one waits
    for (std::uint32_t q = 0; q < states; ++q) {
      budget.state();
      const auto leaf = [&](std::uint32_t c) {
        std::vector<Branch> branches;
        for (const Branch& b : automaton.choices[c]) {
          budget.step(1 + all.size() / 16);
          if (copy == 0) branches.push_back({b.target, {}});
          for (std::uint32_t k = 1; k <= all.size(); ++k)
            if ((copy == 0 || copy == k) && (b.marks & all[k - 1].finitely).empty())
              branches.push_back({k * states + b.target, marks_in(all[k - 1], b.marks)});
        }
        return out.choices.intern(std::move(branches));
      };
      out.roots.push_back(copier.copy(automaton.roots[q], leaf));
    }
  return scc_filter(out, MarksOn::Edges, budget);
}

}  // namespace waymark::automata
