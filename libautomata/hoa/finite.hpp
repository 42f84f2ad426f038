// The Hanoi omega-automata format, version 1, for DFAs. [BBD+15]
//
// HOA has no finite words. Our convention is stated in the output: `properties: finite-words`, state-based `Acceptance:
// 1 Inf(0)`; the mark {0} on a state means that the word may end there. The convention is lossless, because the initial
// state never carries the mark. Files with marks on edges (the word may end after this letter, as Spot prints DFAs) are
// read and converted. docs/formats/hoa.md has the full convention.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/hoa/syntax.hpp"
#include "libautomata/hoa/text.hpp"

namespace waymark::automata {

struct HoaOptions {
  std::string name = {};        // the `name:` header, usually the formula
  bool marks_on_edges = false;  // "the word may stop after this letter" in the place of "… in this state"
  HoaLayout layout = {};        // line breaks and aliases
};

// States as the automaton numbers them, edges merged by (source, target), labels irredundant: same automaton, same
// bytes. O(edges · cubes), which may be exponential in the diagram.
std::string write_hoa(const Dfa& dfa, const HoaOptions& options = {});
// … nullopt when there are more edges, or a label has more cubes, than that: counted before anything is written.
std::optional<std::string> write_hoa_within(const Dfa& dfa, std::size_t most_edges, const HoaOptions& options = {});

// One automaton. States keep the order of their numbers; a trap is added where letters are missing. Throws
// ltl::FormatError with line and column; `source` names the file in messages. What is no DFA (nondeterminism,
// alternation, several initial states, acceptance other than Büchi) is refused with a message that says so.
Dfa read_hoa(std::string_view text, std::string_view source = "");
Dfa to_dfa(HoaAutomaton file, std::string_view source);  // the same of an automaton that was parsed

}  // namespace waymark::automata
