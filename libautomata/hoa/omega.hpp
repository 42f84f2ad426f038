// The writer of HOA for automata on infinite words, and the reader of every form of the format. [BBD+15]
//
// Several initial states become one. Marks on states become marks on edges. Complemented sets Inf(!k) become sets of
// their own. Universal branches are removed (alternation.hpp) where the automaton is weak or Büchi.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/hoa/syntax.hpp"
#include "libautomata/hoa/text.hpp"
#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

struct OmegaHoaOptions {
  std::string name = {};         // the header `name:`; none when empty
  bool marks_on_states = false;  // where all edges of each state carry the same marks; else it stays as it is
  std::vector<std::string> properties = {};  // that are true and not seen on the automaton: more of them
  std::vector<std::string> headers = {};     // whole lines, of names that begin with a small letter
  HoaLayout layout = {};                     // line breaks and aliases
};

// States as they are numbered, labels irredundant: same automaton, same bytes. nullopt when there are more edges, or a
// label has more cubes, than that: counted before anything is written.
std::optional<std::string> write_hoa_within(const Automaton& automaton, std::size_t most_edges,
                                            const OmegaHoaOptions& options = {});
std::string write_hoa(const Automaton& automaton, const OmegaHoaOptions& options = {});

// States in canonical numbering. Throws ltl::FormatError where the automaton cannot be understood as one of ours: more
// than 64 acceptance sets, alternation that is neither weak nor Büchi, --ABORT--; and what the budget throws.
Automaton to_automaton(HoaAutomaton file, std::string_view source, Budget& budget);
Automaton read_omega_hoa(std::string_view text, std::string_view source = "");  // the only one of the text

}  // namespace waymark::automata
