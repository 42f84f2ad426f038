#include "libautomata/hoa/dot_omega.hpp"

#include <array>
#include <string_view>

#include "libautomata/omega/edges.hpp"
#include "libltl/text/print.hpp"

namespace waymark::automata {
namespace {

// Colours that people with any kind of sight tell apart; more than eight marks start over, their number tells.
constexpr std::array<std::string_view, 8> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                  "#E69F00", "#56B4E9", "#F0E442", "#000000"};

std::string escaped(std::string_view text) {  // for labels between < and >
  std::string out;
  for (char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string dots(Marks marks) {
  std::string out;
  for (std::uint32_t mark : marks.members())
    out += " <font color=\"" + std::string(colours[mark % colours.size()]) + "\">●<sub>" + std::to_string(mark) +
           "</sub></font>";
  return out;
}

}  // namespace

std::optional<std::string> write_dot_within(const Automaton& automaton, std::size_t most_edges,
                                            const OmegaDotOptions& options) {
  const auto edges = edges_by_state(automaton.transitions(), most_edges);
  if (!edges) return std::nullopt;
  ltl::Arena arena(automaton.vocabulary());
  std::string out = "digraph automaton {\n  rankdir=LR;\n  nodesep=0.35;\n  ranksep=0.55;\n";
  std::string caption = print(automaton.acceptance().condition);
  if (!options.name.empty()) caption = options.name + "   ·   " + caption;
  out += "  label=<" + escaped(caption) + ">;\n  labelloc=b;\n  fontname=\"Helvetica\";\n";
  out += "  node [shape=circle, fontname=\"Helvetica\", fontsize=12, width=0.4, height=0.4, fixedsize=true];\n";
  out += "  edge [fontname=\"Helvetica\", fontsize=11, arrowsize=0.7];\n";
  out += "  start [shape=none, label=\"\", width=0.05, height=0.05];\n";
  for (std::size_t q = 0; q < automaton.states(); ++q) out += "  " + std::to_string(q) + ";\n";
  out += "  start -> " + std::to_string(automaton.initial().index) + ";\n";
  for (const auto& [from, to] : options.jumps)
    out += "  " + std::to_string(from) + " -> " + std::to_string(to) + " [style=dotted];\n";
  for (std::size_t q = 0; q < edges->size(); ++q) {
    const std::vector<BranchEdge>& from = (*edges)[q];
    for (std::size_t i = 0; i < from.size(); ++i) {  // sorted by target: equal ones stand together
      const bool first = i == 0 || from[i - 1].branch.target != from[i].branch.target;
      const bool last = i + 1 == from.size() || from[i + 1].branch.target != from[i].branch.target;
      if (first)
        out += "  " + std::to_string(q) + " -> " + std::to_string(from[i].branch.target) + " [label=<";
      else
        out += "<br/>";
      const ltl::Formula guard = to_formula(from[i].guard, automaton, arena);
      out += escaped(ltl::print(guard, ltl::Style::Unicode)) + dots(from[i].branch.marks);
      if (last) out += ">];\n";
    }
  }
  return out + "}\n";
}

}  // namespace waymark::automata
