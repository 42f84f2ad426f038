#include "libautomata/monitor/good_prefixes.hpp"

#include <utility>

#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/monitor/monitor.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/scc_filter.hpp"

namespace waymark::automata {

std::variant<Dfa, UnsettledWord> good_prefixes(const Automaton& automaton, Budget& budget) {
  const Automaton no = complement(determinized(automaton, budget)).automaton();
  const Automaton trimmed = with_edges(no, trim(no.transitions()));
  TransitionRelation any_run = trimmed.transitions();
  any_run.acceptance.condition = Condition::constant(true);
  const Automaton unsettled = intersection(automaton, with_edges(trimmed, any_run), budget);
  if (auto word = find_lasso(unsettled)) return UnsettledWord{*std::move(word), unsettled.vocabulary()};
  return bad_prefixes(trimmed, budget);
}

}  // namespace waymark::automata
