// Automata as HOA files write them, before anything is asked of them: headers in any order, aliases resolved, marks
// on states or edges, labels on states, edges, or implied by position, universal branches. [BBD+15, Sec. 4]
//
// A text may hold a stream of automata; HoaReader reads one after the other. What a file says of itself is kept
// where somebody concludes something from it: `finite-words` under `properties:`.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/hoa/lexer.hpp"

namespace waymark::automata {

struct HoaCondition {                                               // an acceptance condition as written
  enum class Op : std::uint8_t { True, False, Inf, Fin, And, Or };  // as in HOA
  Op op = Op::True;                                                 // of this condition
  std::uint64_t set = 0;                                            // of Inf and Fin
  bool complemented = false;           // Inf(!k): infinitely often an edge outside of set k
  std::vector<HoaCondition> operands;  // of And and Or
};

struct HoaAutomaton {                    // one automaton of a stream
  struct Edge {                          // of the body
    Mtbdd::Node label;                   // over labels, variables are positions in propositions
    std::vector<std::uint64_t> targets;  // several: a universal branch
    std::vector<std::uint64_t> marks;    // as written on the edge
    HoaToken at;                         // the first token
  };
  enum class Labels : std::uint8_t { None, State, Edge, Implied };  // where the labels of a state are written
  struct State {                                                    // of the body
    std::uint64_t number = 0;                                       // as written
    std::string name;                                               // in quotes behind the number; may be empty
    std::vector<std::uint64_t> marks;                               // as written on the state: on all of its edges
    std::vector<Edge> edges;                                        // that leave it
    Labels labels = Labels::None;                                   // where they are
    HoaToken at;                                                    // the first token
  };

  std::vector<std::vector<std::uint64_t>> starts;  // several: nondeterminism; several in one: alternation
  std::vector<std::string> propositions;           // of AP, in order
  std::string name;                                // of the automaton; may be empty
  std::uint64_t sets = 0;                          // of the header Acceptance
  HoaCondition acceptance;                         // of the same header
  std::vector<HoaToken> properties;                // as written, with their places
  HoaToken acceptance_at, second_start_at;         // acceptance_at of an aborted one: the place of --ABORT--
  Mtbdd labels;                                    // of edges and states
  std::vector<State> states;                       // in file order; others that occur have no edges
  bool aborted = false;                            // --ABORT-- stands in the place of the end: nothing else counts
};

// Memory and time are bounded by the text and its labels, not by numbers in it. Tokens point into the text.
class HoaReader {
 public:
  // Throws ltl::FormatError where the text is in another format that is known.
  HoaReader(std::string_view text, std::string_view source);
  // nullopt at the end of the text. Throws ltl::FormatError; the automata behind one with an error can still be read,
  // unless the error is a character or string that is no token.
  std::optional<HoaAutomaton> next();
  const HoaLexer& rest() const { return lexer_; }  // behind the automata read so far

 private:
  HoaLexer lexer_;
  std::string_view source_;
};

// The only automaton of the text. Throws ltl::FormatError, also when there is none, a second one, or --ABORT--.
HoaAutomaton parse_hoa(std::string_view text, std::string_view source);

}  // namespace waymark::automata
