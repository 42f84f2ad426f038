#include "libltl/text/foreign.hpp"

#include <algorithm>
#include <array>

#include "libltl/diagnostic.hpp"
#include "libltl/text/character.hpp"

namespace waymark::ltl {
namespace {

constexpr std::string_view blanks = " \t\r\n";

constexpr Foreign vcd{"a VCD file", "waymark check --trace reads it"};
constexpr Foreign xes{"an XES log", "nothing here reads it; waymark check --trace reads CSV and JSON lines"};
constexpr Foreign xml{"an XML document",
                      "waymark import and waymark plan --model read those of OpenStreetMap and GraphML"};
constexpr Foreign dot{"a DOT graph", "nothing here reads it, it is only written; HOA is read"};
constexpr Foreign never_claim{"a never claim", "nothing here reads it, it is only written; HOA is read"};
constexpr Foreign promela{"a Promela model", "nothing here reads it"};
constexpr Foreign lbt{"an automaton in the format of LBT", "nothing here reads it; HOA is read"};
constexpr Foreign hoa{"an automaton in HOA", "waymark automaton reads it"};
constexpr Foreign tlsf{"a TLSF specification",
                       "nothing here reads it, there is no synthesis; its formulas can be given "
                       "one by one"};
constexpr Foreign smv{"an SMV model", "nothing here reads it; its LTLSPEC lines are read with --dialect nusmv"};
constexpr Foreign prism{"a PRISM model", "waymark plan --model reads it"};
constexpr Foreign jani{"a JANI model", "waymark plan --model reads it"};
constexpr Foreign aiger{"an AIGER circuit", "nothing here reads it"};
constexpr Foreign pddl{"a PDDL file", "nothing here reads it"};

struct Beginning {
  std::string_view text;
  Foreign format;
};

// The first word, or a longer beginning of the text.
constexpr std::array<Beginning, 21> beginnings{{
    {"$date", vcd},
    {"$version", vcd},
    {"$timescale", vcd},
    {"$comment", vcd},
    {"$scope", vcd},
    {"$var", vcd},
    {"digraph", dot},
    {"strict digraph", dot},
    {"never {", never_claim},
    {"never{", never_claim},
    {"active proctype", promela},
    {"proctype", promela},
    {"mtype", promela},
    {"HOA:", hoa},
    {"INFO {", tlsf},
    {"INFO{", tlsf},
    {"MODULE ", smv},
    {"aag ", aiger},
    {"aig ", aiger},
    {"(define (", pddl},
    {"(define(", pddl},
}};

std::string_view first_line(std::string_view text) { return text.substr(0, text.find_first_of("\r\n")); }

// The text without blank lines and comments in front of it.
std::string_view beginning(std::string_view text) {
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const bool comment = text.starts_with("//") || text.starts_with("-- ");
    if (text.starts_with("/*"))
      text.remove_prefix(std::min(text.find("*/"), text.size() - 2) + 2);
    else if (comment && text.find('\n') != std::string_view::npos)
      text.remove_prefix(text.find('\n'));
    else
      return text;
  }
}

// "2 1", "3 2t": so many states, so many acceptance sets.
bool is_lbt_header(std::string_view line) {
  const auto digits = [&] {
    const std::size_t begin = line.size();
    while (!line.empty() && is_digit(line.front())) line.remove_prefix(1);
    return begin > line.size();
  };
  if (!digits() || !line.starts_with(' ')) return false;
  line.remove_prefix(1);
  if (!digits()) return false;
  while (!line.empty() && (line.front() == 't' || line.front() == 's')) line.remove_prefix(1);
  return line.find_first_not_of(blanks) == std::string_view::npos;
}

// The keyword of a type of model alone on a line or before a module; some line then begins a module.
bool is_prism(std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  constexpr std::array<std::string_view, 8> types{
      "mdp", "dtmc", "ctmc", "pta", "pomdp", "nondeterministic", "probabilistic", "stochastic"};
  return std::find(types.begin(), types.end(), word) != types.end() && text.find("module ") != std::string_view::npos;
}

}  // namespace

std::optional<Foreign> foreign_format(std::string_view text) {
  constexpr std::size_t most = std::size_t{1} << 16U;
  text = beginning(text.substr(0, most));
  const std::string_view line = first_line(text);
  for (const Beginning& row : beginnings) {
    if (!text.starts_with(row.text)) continue;
    const bool ends = is_letter(row.text.back()) && row.text.size() < text.size() &&
                      (is_letter(text[row.text.size()]) || is_digit(text[row.text.size()]));
    const bool claim = row.format.name != dot.name || text.find('{') != std::string_view::npos;
    if (!ends && claim) return row.format;
  }
  if (text.starts_with("<?xml") || text.starts_with("<!DOCTYPE") || text.starts_with("<log"))
    return text.find("<log") != std::string_view::npos ? xes : xml;
  if (text.starts_with('{') && text.find("\"jani-version\"") != std::string_view::npos) return jani;
  if (is_lbt_header(line) && line.size() < text.size()) return lbt;
  if (is_prism(text)) return prism;
  return std::nullopt;
}

std::string foreign_hint(std::string_view text, std::string_view own) {
  const auto found = foreign_format(text);
  if (!found || found->name == own) return "";
  return "this is " + std::string(found->name) + "; " + std::string(found->reads);
}

void refuse_foreign(std::string_view text, std::string_view source, std::string_view expected, std::string_view own) {
  if (const std::string hint = foreign_hint(text, own); !hint.empty())
    throw FormatError(source, 1, 1, "expected " + std::string(expected) + ": " + hint);
}

}  // namespace waymark::ltl
