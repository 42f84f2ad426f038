// HOA as text: an automaton with explicit edges, ready for output.
//
// This header alone defines the layout; the writers of each kind of automaton supply the headers of the file. With
// aliases, a label of several literals that occurs more than once is written once, in the header.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libautomata/finite/guard.hpp"

namespace waymark::automata {

struct HoaLayout {
  bool aliases = false;   // labels that occur more than once get a name
  bool one_line = false;  // blanks in the place of line ends, but the last one
};

struct HoaText {                       // what a file is to hold
  struct Edge {                        // of the body
    Guard guard;                       // the label
    std::uint32_t target = 0;          // a state
    std::vector<std::uint32_t> marks;  // as `{0 1}`
  };
  struct State {                       // of the body
    std::vector<std::uint32_t> marks;  // on the state
    std::vector<Edge> edges;           // that leave it
  };

  std::string name;                       // of the automaton; none when empty
  std::vector<std::uint32_t> starts;      // one header `Start:` each
  std::vector<std::string> propositions;  // of AP
  std::string acceptance_name;            // the whole line behind `acc-name:`, none when empty
  std::string acceptance;                 // the number of sets and the condition
  std::string properties;                 // the whole line behind `properties:`
  std::vector<std::string> headers;       // more of them, whole lines
  std::vector<State> states;              // numbered from 0
};

std::string print(const HoaText& automaton, const HoaLayout& layout);  // ends with a line break

// An automaton that its writer gave up: nothing but the name, ended by --ABORT--.
std::string aborted_hoa(std::string_view name, const HoaLayout& layout);

std::string quoted(std::string_view text);  // with \" and \\ escaped
std::string hoa_label(const Guard& guard);  // "0&!1 | 2", "t", "f", without brackets

}  // namespace waymark::automata
