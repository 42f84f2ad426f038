#include <utility>

#include "libautomata/omega/degeneralize.hpp"
#include "libautomata/omega/projection.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libautomata/translation/strategies.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

std::variant<Translated, Exhausted> forget_histories(std::variant<Translated, Exhausted> found,
                                                     const ltl::Vocabulary& names, bool buchi,
                                                     const ltl::Limits& limits) {
  const Translated* made = std::get_if<Translated>(&found);
  if (made == nullptr) return found;
  const Automaton short_of = projected(made->automaton, names);
  Budget budget(BuchiStrategies{}.simulation.steps, SIZE_MAX, limits.stop);
  try {
    Reduced out = reduce(short_of.transitions(), buchi ? MarksOn::States : MarksOn::Edges, budget);
    const TransitionRelation result = buchi ? with_one_set(std::move(out.automaton)) : std::move(out.automaton);
    return Translated{as_automaton(result, names, short_of.reads()), made->reduced && out.complete};
  } catch (const Budget::Exceeded&) {  // stopped
    return Exhausted{short_of.states()};
  }
}

}  // namespace waymark::automata
