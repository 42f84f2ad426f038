#include "libautomata/hoa/dot_finite.hpp"

#include <string_view>

#include "libautomata/finite/guard.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"

namespace waymark::automata {
namespace {

// Escapes the text and breaks it, before a connective, into lines of about `width` characters.
std::string label(std::string_view text, std::size_t width) {
  std::string out;
  std::size_t line = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    const bool connective = rest.starts_with(" ∨ ") || rest.starts_with(" ∧ ");
    const std::size_t next = connective ? rest.find(" ∨ ", 1) : 0;
    const std::size_t ahead = connective ? ltl::utf8_length(rest.substr(0, next)) : 0;
    if (connective && line > 0 && line + ahead > width) {
      out += "\\n";
      line = 0;
      continue;  // the blank before the connective
    }
    if (text[i] == '"' || text[i] == '\\') out += '\\';
    out += text[i];
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) ++line;
  }
  return out;
}

std::string node(const Dfa& dfa, StateId q) {
  std::string out = "  " + std::to_string(q.index);
  if (dfa.is_accepting(q)) out += " [shape=doublecircle]";
  if (dfa.is_trap(q)) out += " [color=gray70, fontcolor=gray70]";
  return out + ";\n";
}

}  // namespace

std::string write_dot(const Dfa& dfa, const DotOptions& options) {
  const auto shown = [&](StateId q) {
    return options.trap == DotOptions::Trap::Grey || !dfa.is_trap(q) || q == dfa.initial();
  };
  std::string out = "digraph automaton {\n  rankdir=LR;\n  nodesep=0.35;\n  ranksep=0.55;\n";
  if (!options.name.empty())
    out +=
        "  label=\"" + label(options.name, 4 * options.label_width) + "\";\n  labelloc=b;\n  fontname=\"Helvetica\";\n";
  out += "  node [shape=circle, fontname=\"Helvetica\", fontsize=12, width=0.4, height=0.4, fixedsize=true];\n";
  out += "  edge [fontname=\"Helvetica\", fontsize=11, arrowsize=0.7];\n";
  out += "  start [shape=none, label=\"\", width=0.05, height=0.05];\n";
  for (std::uint32_t q = 0; q < dfa.states(); ++q)
    if (shown(StateId{q})) out += node(dfa, StateId{q});
  out += "  start -> " + std::to_string(dfa.initial().index) + ";\n";
  ltl::Arena arena(dfa.vocabulary());
  Edges edges(dfa);
  for (std::uint32_t i = 0; i < dfa.states(); ++i) {
    const StateId q{i};
    for (StateId r : targets(dfa, q)) {
      if (!shown(q) || !shown(r)) continue;
      const std::string text = ltl::print(edges.label(q, r, arena), ltl::Style::Unicode);
      out += "  " + std::to_string(q.index) + " -> " + std::to_string(r.index) + " [label=\"" +
             label(text, options.label_width) + "\"";
      if (dfa.is_trap(r)) out += ", color=gray70, fontcolor=gray70";
      out += "];\n";
    }
  }
  return out + "}\n";
}

}  // namespace waymark::automata
