#include <algorithm>

#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/edges.hpp"

namespace waymark::automata {
namespace {

using EdgesByState = std::vector<std::vector<BranchEdge>>;

bool uniform(const EdgesByState& edges) {
  return std::all_of(edges.begin(), edges.end(), [](const std::vector<BranchEdge>& from) {
    return std::all_of(from.begin(), from.end(),
                       [&](const BranchEdge& edge) { return edge.branch.marks == from.front().branch.marks; });
  });
}

HoaText::State state_text(std::vector<BranchEdge>& edges, bool marks_on_state) {
  HoaText::State state;
  if (marks_on_state && !edges.empty()) state.marks = edges.front().branch.marks.members();
  for (BranchEdge& edge : edges) {
    HoaText::Edge text{std::move(edge.guard), edge.branch.target, {}};
    if (!marks_on_state) text.marks = edge.branch.marks.members();
    state.edges.push_back(std::move(text));
  }
  return state;
}

}  // namespace

std::optional<std::string> write_hoa_within(const Automaton& automaton, std::size_t most_edges,
                                            const OmegaHoaOptions& options) {
  const TransitionRelation& transitions = automaton.transitions();
  std::optional<EdgesByState> edges = edges_by_state(transitions, most_edges);
  if (!edges) return std::nullopt;
  const bool on_states = options.marks_on_states && uniform(*edges);
  HoaText text;
  text.name = options.name;
  text.starts = {automaton.initial().index};
  for (ltl::Proposition p : automaton.reads()) text.propositions.push_back(automaton.vocabulary().name(p));
  text.acceptance_name = automaton.acceptance().name().value_or("");
  text.acceptance = std::to_string(automaton.acceptance().sets) + ' ' + print(automaton.acceptance().condition);
  text.properties = "trans-labels explicit-labels ";
  text.properties += on_states ? "state-acc" : "trans-acc";
  text.properties += " no-univ-branch";
  if (is_complete(transitions)) text.properties += " complete";
  if (is_deterministic(transitions)) text.properties += " deterministic";
  for (const std::string& property : options.properties) text.properties += ' ' + property;
  text.headers = options.headers;
  for (std::vector<BranchEdge>& from : *edges) text.states.push_back(state_text(from, on_states));
  return print(text, options.layout);
}

std::string write_hoa(const Automaton& automaton, const OmegaHoaOptions& options) {
  return *write_hoa_within(automaton, SIZE_MAX, options);
}

}  // namespace waymark::automata
