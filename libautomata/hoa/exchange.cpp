#include "libautomata/hoa/exchange.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "libautomata/omega/degeneralize.hpp"
#include "libautomata/omega/edges.hpp"
#include "libautomata/omega/operations.hpp"
#include "libltl/text/print.hpp"

namespace waymark::automata {
namespace {

using EdgesByState = std::vector<std::vector<BranchEdge>>;

bool marks_are_on_states(const TransitionRelation& automaton) {
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    const std::vector<Branch> branches = branches_of(automaton, q);
    for (const Branch& b : branches)
      if (b.marks != branches.front().marks) return false;
  }
  return true;
}

// By state: does it accept? Throws unless the automaton is Büchi (or accepts all runs) with marks on states.
std::vector<bool> accepting_states(const Automaton& automaton) {
  const Acceptance& acceptance = automaton.acceptance();
  if ((!acceptance.is_buchi() && !acceptance.is_all()) || !marks_are_on_states(automaton.transitions()))
    throw std::invalid_argument("this format takes Büchi automata with accepting states");
  std::vector<bool> out;
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    const std::vector<Branch> branches = branches_of(automaton.transitions(), q);
    out.push_back(acceptance.is_all() || (!branches.empty() && branches.front().marks.contains(0)));
  }
  return out;
}

bool is_identifier(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

// x > 3, state == idle: comparisons are expressions of Promela as they are.
bool is_comparison(std::string_view name) {
  const auto operand = [&] {
    const std::size_t end = std::min(name.find_first_of(" =!<>"), name.size());
    const std::string_view word = name.substr(0, end);
    name.remove_prefix(end);
    name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
    return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             std::string_view("_.[]-").find(c) != std::string_view::npos;
    });
  };
  if (!operand()) return false;
  const std::size_t sign = std::min(name.find_first_not_of("=!<>"), name.size());
  constexpr std::array<std::string_view, 6> signs{"==", "!=", "<", "<=", ">", ">="};
  if (std::find(signs.begin(), signs.end(), name.substr(0, sign)) == signs.end()) return false;
  name.remove_prefix(sign);
  name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
  return operand() && name.empty();
}

std::string promela_name(const std::string& name) {
  if (is_identifier(name)) return name;
  return is_comparison(name) ? '(' + name + ')' : ltl::print_name(name);
}

std::string promela(const Guard& guard, const Automaton& automaton) {
  std::string out;
  for (const Cube& cube : guard) {
    out += out.empty() ? "(" : " || (";
    for (std::size_t i = 0; i < cube.size(); ++i) {
      const std::string& name = automaton.vocabulary().name(automaton.reads()[cube[i].variable]);
      out += (i > 0 ? " && " : "") + std::string(cube[i].positive ? "" : "!");
      out += promela_name(name);
    }
    if (cube.empty()) out += "true";
    out += ')';
  }
  return out;
}

std::string comment(std::string text) {  // which must not end early
  for (std::size_t at = text.find("*/"); at != std::string::npos; at = text.find("*/", at)) text[at] = ' ';
  return text;
}

// The letters of a guard as full conjunctions, by counting: the first proposition changes slowest.
class Letters {
 public:
  explicit Letters(const Automaton& automaton) : automaton_(automaton) {}
  std::size_t width() const { return automaton_.reads().size(); }

  std::string name(std::uint64_t letter) const {
    std::string out;
    for (std::size_t v = 0; v < width(); ++v) {
      out += (v > 0 ? "&" : "") + std::string(member(letter, v) ? "" : "!");
      for (char c : automaton_.vocabulary().name(automaton_.reads()[v]))  // no comma, no bracket
        out += std::string_view(",[]->\n").find(c) == std::string_view::npos ? c : '_';
    }
    return out.empty() ? "true" : out;
  }
  std::span<const Branch> next(std::uint32_t q, std::uint64_t letter) const {
    const TransitionRelation& transitions = automaton_.transitions();
    const auto holds = [&](Mtbdd::Variable v) { return member(letter, v); };
    return transitions.choices[Mtbdd::payload(transitions.diagram.evaluate(transitions.roots[q], holds))];
  }

 private:
  bool member(std::uint64_t letter, std::size_t v) const { return ((letter >> (width() - 1 - v)) & 1U) != 0; }
  const Automaton& automaton_;
};

}  // namespace

std::optional<Automaton> make_state_based(const Automaton& automaton, Budget& budget) {
  const Acceptance& acceptance = automaton.acceptance();
  if (!acceptance.is_generalized_buchi()) return std::nullopt;
  if ((acceptance.is_buchi() || acceptance.is_all()) && marks_are_on_states(automaton.transitions())) return automaton;
  return with_edges(automaton, degeneralize(automaton.transitions(), {}, budget));
}

std::optional<std::string> write_never_claim(const Automaton& automaton, std::size_t most_edges,
                                             const std::string& name) {
  const std::vector<bool> accepting = accepting_states(automaton);
  const std::optional<EdgesByState> edges = edges_by_state(automaton.transitions(), most_edges);
  if (!edges) return std::nullopt;
  const auto label = [&](std::uint32_t q) {
    return std::string(accepting[q] ? "accept_" : "T0_") +
           (q == automaton.initial().index ? "init" : 'S' + std::to_string(q));
  };
  std::string out = name.empty() ? "never {\n" : "never { /* " + comment(name) + " */\n";
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {  // state 0 is the initial one, which must come first
    const std::vector<BranchEdge>& from = (*edges)[q];
    out += label(q) + ":\n";
    if (from.empty()) {
      out += "  false;\n";
      continue;
    }
    out += "  if\n";
    for (const BranchEdge& edge : from)
      out += "  :: (" + promela(edge.guard, automaton) + ") -> goto " + label(edge.branch.target) + '\n';
    out += "  fi;\n";
  }
  return out + "}\n";
}

std::optional<std::string> write_lbtt(const Automaton& automaton, std::size_t most_edges) {
  if (!automaton.acceptance().is_generalized_buchi())
    throw std::invalid_argument("LBTT takes generalised Büchi automata");
  const std::optional<EdgesByState> edges = edges_by_state(automaton.transitions(), most_edges);
  if (!edges) return std::nullopt;
  ltl::Arena arena(automaton.vocabulary());
  std::string out = std::to_string(automaton.states()) + ' ' + std::to_string(automaton.acceptance().sets) + "t\n";
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    out += std::to_string(q) + (q == automaton.initial().index ? " 1\n" : " 0\n");
    for (const BranchEdge& edge : (*edges)[q]) {
      out += std::to_string(edge.branch.target) + ' ';
      for (std::uint32_t mark : edge.branch.marks.members()) out += std::to_string(mark) + ' ';
      out += "-1 " + ltl::print(to_formula(edge.guard, automaton, arena), ltl::Style::Lbt) + '\n';
    }
    out += "-1\n";
  }
  return out;
}

std::optional<std::string> write_ba(const Automaton& automaton, std::size_t most_edges) {
  const std::vector<bool> accepting = accepting_states(automaton);
  const Letters letters(automaton);
  if (letters.width() > 40) return std::nullopt;
  const std::uint64_t count = std::uint64_t{1} << letters.width();
  if (count > most_edges) return std::nullopt;
  const auto state = [](std::size_t q) { return '[' + std::to_string(q) + ']'; };
  std::string out = state(automaton.initial().index) + '\n';
  std::size_t written = 0;
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint64_t letter = 0; letter < count; ++letter) {
      std::optional<std::uint32_t> before;  // branches to one target differ in marks that the format does not have
      for (const Branch& branch : letters.next(q, letter)) {
        if (before == branch.target) continue;
        before = branch.target;
        if (++written > most_edges) return std::nullopt;
        out += letters.name(letter) + ',' + state(q) + "->" + state(branch.target) + '\n';
      }
    }
  bool any = false;
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    if (accepting[q]) {
      out += state(q) + '\n';
      any = true;
    }
  return any ? out : out + state(automaton.states()) + '\n';
}

std::optional<std::string> write_table(const Automaton& automaton, std::size_t most_edges) {
  const std::optional<EdgesByState> edges = edges_by_state(automaton.transitions(), most_edges);
  if (!edges) return std::nullopt;
  ltl::Arena arena(automaton.vocabulary());
  std::string out = "source\ttarget\tmarks\tguard\n";
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (const BranchEdge& edge : (*edges)[q]) {
      std::string marks;
      for (std::uint32_t mark : edge.branch.marks.members()) marks += (marks.empty() ? "" : ",") + std::to_string(mark);
      out += std::to_string(q) + '\t' + std::to_string(edge.branch.target) + '\t' + (marks.empty() ? "-" : marks) +
             '\t' + ltl::print(to_formula(edge.guard, automaton, arena)) + '\n';
    }
  return out;
}

}  // namespace waymark::automata
