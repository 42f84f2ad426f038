// The output of an automaton: every format of `waymark translate` and `waymark automaton`, and the size limits.
#pragma once
#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"
#include "libautomata/omega/automaton.hpp"
#include "tools/shell/command.hpp"
#include "tools/shell/parallel.hpp"

namespace waymark::tools {

struct OutputOptions {
  std::string format = "hoa";
  bool one_line = false, aliases = false;
  std::string acceptance = "state";  // of HOA for DFAs: where the marks stand
  std::size_t edges = 1'000'000;     // explicit edges, at most
  std::string svg = {};              // a file for the picture; empty: none
  std::string outputs = {};          // of pgsolver: propositions of the system, with commas
};
void add_output_options(Command command, OutputOptions& options);

struct Shown {
  std::size_t line = 1;
  std::string text = {};          // what was read, or the name of the automaton that was
  std::string name = {};          // in ASCII notation; of the formula, or as the file says
  std::string unicode_name = {};  // for drawings
  std::string semantics = {};     // "finite", "infinite"
  std::string status = "ok";      // or unreduced
  double seconds = 0;
  std::string certificate = {};  // of JSON, when one was asked for
  std::stop_token stop = {};     // of the drawing
};

// The automaton in the format asked for, and drawn where a picture was; past the limit on edges the answer is status
// limit with the symbolic size.
Reply show(const automata::Dfa& dfa, const Shown& about, const OutputOptions& options);
Reply show(const automata::Automaton& automaton, const Shown& about, const OutputOptions& options);
// Jumps are branches; HOA and JSON also say which.
Reply show(const automata::MdpSafe& automaton, const Shown& about, const OutputOptions& options);

// What stands in the place of an automaton that there is not: about.status is limit or error; on standard output.
std::string show_none(const Shown& about, const std::string& message, const OutputOptions& options);

// What stands before the first automaton of a format: the names of the columns of stats.
std::string heading(const OutputOptions& options);

}  // namespace waymark::tools
