#include "libautomata/omega/reduce.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "libautomata/omega/simulation.hpp"

namespace waymark::automata {
namespace {

constexpr std::size_t many_states = 400;     // from here on what merges states most is enough
constexpr std::size_t most_as_marked = 200;  // merged states with the marks as given that are looked at first
constexpr std::size_t least_again = 8, most_again = 12;  // states of a result that both ways are tried for

class Steps {
 public:
  Steps(MarksOn marks, Effort& effort) : marks_(marks), effort_(effort) {}

  // What the first step that makes the automaton smaller makes of it.
  std::optional<Branching> improved(const Branching& automaton) {
    const std::vector<bool> colour =
        marks_ == MarksOn::Edges ? std::vector<bool>(automaton.states(), false) : marked_states(automaton);
    const Size most = size(automaton);
    Simulations plain(automaton, effort_);
    if (auto out = smaller(most, plain.quotient())) return out;
    if (auto out = smaller(most, plain.reverse_quotient(colour))) return out;
    if (automaton.states() > many_states) return std::nullopt;
    if (auto out = smaller(most, plain.without_overtaken())) return out;
    if (marks_ == MarksOn::States) return std::nullopt;
    const std::optional<Branching> freed = with_free_marks(automaton);
    if (!freed) return std::nullopt;
    Simulations free(*freed, effort_);
    if (auto out = smaller(most, free.reverse_quotient(colour))) return out;
    return smaller(most, free.quotient());
  }

 private:
  // States, edges, and branches of choices: a branch may go on some letters and stay on others.
  using Size = std::array<std::size_t, 3>;
  static Size size(const Branching& a) {
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
  std::optional<Branching> smaller(const Size& most, const Branching& after) const {
    if (!(size(after) < most)) return std::nullopt;
    Branching filtered = scc_filter(after, marks_, effort_);
    if (!(size(filtered) < most)) return std::nullopt;
    return filtered;
  }

  MarksOn marks_;
  Effort& effort_;
};

// What simulation forwards and backwards leaves of a trimmed automaton, its marks as they are.
Branching simulated(Branching automaton, Effort& effort) {
  const std::vector<bool> one_colour(automaton.states(), false);
  while (true) {
    const std::size_t states = automaton.states(), edges = count_edges(automaton);
    automaton = trim(Simulations(automaton, effort).quotient());
    automaton = trim(Simulations(automaton, effort).reverse_quotient(one_colour));
    if (automaton.states() == states && count_edges(automaton) >= edges) return automaton;
  }
}

// Until no step helps. Filtered and merged in.
Reduced stepwise(Branching automaton, MarksOn marks, Effort& effort) {
  Steps steps(marks, effort);
  try {
    while (std::optional<Branching> better = steps.improved(automaton)) automaton = *std::move(better);
    return {std::move(automaton), true};
  } catch (const Effort::Spent& spent) {
    if (spent.reason == Effort::Spent::Reason::Stopped) throw;
    return {std::move(automaton), false};
  }
}

bool is_smaller(const Branching& a, const Branching& b) {
  return a.states() < b.states() || (a.states() == b.states() && count_edges(a) < count_edges(b));
}

}  // namespace

Reduced reduce(Branching automaton, MarksOn marks, Effort& effort) {
  Effort unlimited;  // trimmed in any case, in linear time
  automaton = scc_filter(automaton, marks, unlimited);
  try {
    automaton = bisimulation_quotient(automaton, effort);
  } catch (const Effort::Spent& spent) {
    if (spent.reason == Effort::Spent::Reason::Stopped) throw;
    return {std::move(automaton), false};
  }
  return stepwise(std::move(automaton), marks, effort);
}

Reduced reduce_as_marked(const Branching& automaton, Effort& effort) {
  if (automaton.acceptance.sets == 0) return reduce(automaton, MarksOn::Edges, effort);
  try {
    const Branching live = trim(automaton), plain = bisimulation_quotient(live, effort);
    Branching saturated = bisimulation_quotient(scc_filter(live, MarksOn::Edges, effort), effort);
    if (plain.states() < saturated.states() && plain.states() <= most_as_marked)
      return reduce(simulated(plain, effort), MarksOn::Edges, effort);
    const std::uint32_t sets = saturated.acceptance.sets;
    Reduced out = stepwise(std::move(saturated), MarksOn::Edges, effort);
    const std::size_t states = out.automaton.states();
    if (states < least_again || states > most_again || sets == plain.acceptance.sets ||
        is_deterministic(out.automaton))
      return out;
    Reduced other = reduce(simulated(plain, effort), MarksOn::Edges, effort);
    return is_smaller(other.automaton, out.automaton) ? std::move(other) : std::move(out);
  } catch (const Effort::Spent& spent) {
    if (spent.reason == Effort::Spent::Reason::Stopped) throw;
    return {reduce(automaton, MarksOn::Edges, effort).automaton, false};
  }
}

}  // namespace waymark::automata
