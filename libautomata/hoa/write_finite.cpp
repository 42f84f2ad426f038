#include <string>

#include "libautomata/finite/guard.hpp"
#include "libautomata/hoa/finite.hpp"

namespace waymark::automata {

std::optional<std::string> write_hoa_within(const Dfa& dfa, std::size_t most_edges, const HoaOptions& options) {
  if (!count_edges(dfa, most_edges)) return std::nullopt;
  HoaText text;
  text.name = options.name;
  text.starts = {dfa.initial().index};
  for (ltl::Proposition p : dfa.reads()) text.propositions.push_back(dfa.vocabulary().name(p));
  text.acceptance_name = "Buchi";
  text.acceptance = "1 Inf(0)";
  text.properties = "trans-labels explicit-labels ";
  text.properties += options.marks_on_edges ? "trans-acc" : "state-acc";
  text.properties += " complete deterministic finite-words";
  Edges edges(dfa);
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    std::optional<std::vector<Edge>> from = edges.from(StateId{q}, most_edges);
    if (!from) return std::nullopt;
    HoaText::State state;
    if (!options.marks_on_edges && dfa.is_accepting(StateId{q})) state.marks = {0};
    for (Edge& edge : *from) {
      const bool marked = options.marks_on_edges && dfa.is_accepting(edge.target);
      state.edges.push_back({std::move(edge.guard), edge.target.index,
                             marked ? std::vector<std::uint32_t>{0} : std::vector<std::uint32_t>{}});
    }
    text.states.push_back(std::move(state));
  }
  return print(text, options.layout);
}

std::string write_hoa(const Dfa& dfa, const HoaOptions& options) { return *write_hoa_within(dfa, SIZE_MAX, options); }

}  // namespace waymark::automata
