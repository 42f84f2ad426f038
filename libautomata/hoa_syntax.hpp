// One automaton as a HOA file writes it, before anything is asked of it: headers in any order, aliases, marks on
// states or edges, labels on states, edges, or implied by position. [BBD+15, Sec. 4]
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libautomata/boolean.hpp"
#include "libautomata/hoa_lexer.hpp"
#include "libautomata/mtbdd.hpp"

namespace waymark::automata {

struct HoaAutomaton {
  struct Acceptance {
    enum class Kind : std::uint8_t { All, None, Buchi, Other };
    Kind kind = Kind::Other;
    std::uint64_t set = 0;  // of Büchi: Inf(set)
  };
  struct Edge {
    Mtbdd::Node label;                   // over labels, variables are positions in propositions
    std::vector<std::uint64_t> targets;  // several: a universal branch
    std::vector<std::uint64_t> marks;
    HoaToken at;
  };
  struct State {
    std::uint64_t number = 0;
    std::vector<std::uint64_t> marks;
    std::vector<Edge> edges;
    HoaToken at;
  };

  std::vector<std::vector<std::uint64_t>> starts;  // several: nondeterminism; several in one: alternation
  std::vector<std::string> propositions;
  Acceptance acceptance;
  HoaToken acceptance_at, second_start_at;
  Mtbdd labels;
  std::vector<State> states;  // in file order
};

// Throws ltl::FormatError. Memory and time are bounded by the text and its labels, not by numbers in it.
HoaAutomaton parse_hoa(std::string_view text, std::string_view source);

}  // namespace waymark::automata
