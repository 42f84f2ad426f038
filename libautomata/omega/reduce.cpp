#include "libautomata/omega/reduce.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "libautomata/omega/candidate.hpp"
#include "libautomata/omega/simulation.hpp"

namespace waymark::automata {
namespace {

constexpr std::size_t many_states = 400;     // from here on what merges states most is enough
constexpr std::size_t most_as_marked = 200;  // merged states with the marks as given that are looked at first
constexpr std::size_t least_again = 8, most_again = 12;  // states of a result that both ways are tried for

class Steps {
 public:
  Steps(MarksOn marks, Budget& budget) : marks_(marks), budget_(budget) {}

  // What the first step that makes the automaton smaller makes of it.
  std::optional<TransitionRelation> improved(const TransitionRelation& automaton) {
    const std::vector<bool> colour =
        marks_ == MarksOn::Edges ? std::vector<bool>(automaton.states(), false) : marked_states(automaton);
    const Size most = size(automaton);
    Simulations plain(automaton, budget_);
    if (auto out = smaller(most, plain.quotient())) return out;
    if (auto out = smaller(most, plain.reverse_quotient(colour))) return out;
    if (automaton.states() > many_states) return std::nullopt;
    if (auto out = smaller(most, plain.without_overtaken())) return out;
    if (marks_ == MarksOn::States) return std::nullopt;
    const std::optional<TransitionRelation> freed = with_free_marks(automaton);
    if (!freed) return std::nullopt;
    Simulations free(*freed, budget_);
    if (auto out = smaller(most, free.reverse_quotient(colour))) return out;
    return smaller(most, free.quotient());
  }

 private:
  // States, edges, and branches of choices: a branch may go on some letters and stay on others.
  using Size = std::array<std::size_t, 3>;
  static Size size(const TransitionRelation& a) {
    ChoiceLists lists(a);
    std::size_t edges = 0, branches = 0;
    std::vector<Branch> all;
    for (std::uint32_t q = 0; q < a.states(); ++q) {
      all.clear();
      for (std::uint32_t c : lists.of(q)) all.insert(all.end(), a.choices[c].begin(), a.choices[c].end());
      branches += all.size();
      std::sort(all.begin(), all.end());
      edges += static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
    }
    return {a.states(), edges, branches};
  }
  std::optional<TransitionRelation> smaller(const Size& most, const TransitionRelation& after) const {
    if (!(size(after) < most)) return std::nullopt;
    TransitionRelation filtered = scc_filter(after, marks_, budget_);
    if (!(size(filtered) < most)) return std::nullopt;
    return filtered;
  }

  MarksOn marks_;
  Budget& budget_;
};

// What simulation forwards and backwards leaves of a trimmed automaton, its marks as they are.
TransitionRelation simulated(TransitionRelation automaton, Budget& budget) {
  const std::vector<bool> one_colour(automaton.states(), false);
  while (true) {
    const std::size_t states = automaton.states(), edges = count_edges(automaton);
    automaton = trim(Simulations(automaton, budget).quotient());
    automaton = trim(Simulations(automaton, budget).reverse_quotient(one_colour));
    if (automaton.states() == states && count_edges(automaton) >= edges) return automaton;
  }
}

// Until no step helps. Filtered and merged in.
Reduced stepwise(TransitionRelation automaton, MarksOn marks, Budget& budget) {
  Steps steps(marks, budget);
  try {
    while (std::optional<TransitionRelation> better = steps.improved(automaton)) automaton = *std::move(better);
    return {std::move(automaton), true};
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    return {std::move(automaton), false};
  }
}

}  // namespace

Reduced reduce(TransitionRelation automaton, MarksOn marks, Budget& budget) {
  Budget unlimited;  // trimmed in any case, in linear time
  automaton = scc_filter(automaton, marks, unlimited);
  try {
    automaton = bisimulation_quotient(automaton, budget);
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    return {std::move(automaton), false};
  }
  return stepwise(std::move(automaton), marks, budget);
}

Reduced reduce_as_marked(const TransitionRelation& automaton, Budget& budget) {
  if (automaton.acceptance.sets == 0) return reduce(automaton, MarksOn::Edges, budget);
  try {
    const TransitionRelation live = trim(automaton), plain = bisimulation_quotient(live, budget);
    TransitionRelation saturated = bisimulation_quotient(scc_filter(live, MarksOn::Edges, budget), budget);
    if (plain.states() < saturated.states() && plain.states() <= most_as_marked)
      return reduce(simulated(plain, budget), MarksOn::Edges, budget);
    const std::uint32_t sets = saturated.acceptance.sets;
    Reduced out = stepwise(std::move(saturated), MarksOn::Edges, budget);
    const std::size_t states = out.automaton.states();
    if (states < least_again || states > most_again || sets == plain.acceptance.sets || is_deterministic(out.automaton))
      return out;
    Reduced other = reduce(simulated(plain, budget), MarksOn::Edges, budget);
    const bool complete =
        out.complete && other.complete;  // the one that is left may be the larger one for want of steps
    return {smaller(other.automaton, out.automaton) ? std::move(other.automaton) : std::move(out.automaton), complete};
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    return {reduce(automaton, MarksOn::Edges, budget).automaton, false};
  }
}

}  // namespace waymark::automata
