#include <string>

#include "libautomata/guard.hpp"
#include "libautomata/hoa.hpp"

namespace waymark::automata {
namespace {

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string label(const Guard& guard) {
  std::string out;
  for (const Cube& cube : guard) {
    if (!out.empty()) out += " | ";
    for (std::size_t i = 0; i < cube.size(); ++i) {
      if (i > 0) out += '&';
      if (!cube[i].positive) out += '!';
      out += std::to_string(cube[i].variable);
    }
    if (cube.empty()) out += 't';
  }
  return out;
}

}  // namespace

std::string write_hoa(const Dfa& dfa, const HoaOptions& options) {
  std::string out = "HOA: v1\n";
  if (!options.name.empty()) out += "name: " + quoted(options.name) + '\n';
  out += "tool: \"waymark\"\n";
  out += "States: " + std::to_string(dfa.states()) + '\n';
  out += "Start: " + std::to_string(dfa.initial().index) + '\n';
  out += "AP: " + std::to_string(dfa.reads().size());
  for (ltl::Proposition p : dfa.reads()) out += ' ' + quoted(dfa.vocabulary().name(p));
  out += "\nacc-name: Buchi\nAcceptance: 1 Inf(0)\n";
  out += "properties: trans-labels explicit-labels state-acc complete deterministic finite-words\n--BODY--\n";
  Edges edges(dfa);
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    out += "State: " + std::to_string(q) + (dfa.is_accepting(StateId{q}) ? " {0}\n" : "\n");
    for (const Edge& edge : edges.from(StateId{q}))
      out += '[' + label(edge.guard) + "] " + std::to_string(edge.target.index) + '\n';
  }
  return out + "--END--\n";
}

}  // namespace waymark::automata
