#include "libautomata/hoa/text.hpp"

#include <map>

namespace waymark::automata {
namespace {

std::string marks_text(const std::vector<std::uint32_t>& marks) {
  std::string out;
  for (std::uint32_t mark : marks) out += (out.empty() ? " {" : " ") + std::to_string(mark);
  return out.empty() ? out : out + '}';
}

// Labels in order of first use, those of several literals that are used again by their alias.
class Labels {
 public:
  Labels(const HoaText& automaton, bool aliases) {
    if (!aliases) return;
    std::map<std::string, std::size_t> uses;
    std::vector<std::string> order;
    for (const HoaText::State& state : automaton.states)
      for (const HoaText::Edge& edge : state.edges) {
        const std::string label = hoa_label(edge.guard);
        if (label.find_first_of("&|") != std::string::npos && ++uses[label] == 2) order.push_back(label);
      }
    for (const std::string& label : order) {
      const std::string name = "@l" + std::to_string(alias_.size());
      alias_.emplace(label, name);
      definitions_ += "Alias: " + name + ' ' + label + '\n';
    }
  }
  const std::string& definitions() const { return definitions_; }
  std::string of(const Guard& guard) const {
    std::string label = hoa_label(guard);
    const auto known = alias_.find(label);
    return known == alias_.end() ? label : known->second;
  }

 private:
  std::map<std::string, std::string> alias_;
  std::string definitions_;
};

// Line ends outside of strings become blanks.
std::string on_one_line(std::string text) {
  bool in_string = false;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (in_string && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      in_string = !in_string;
    else if (text[i] == '\n' && !in_string)
      text[i] = ' ';
  }
  return text;
}

std::string headers(const HoaText& automaton) {
  std::string out = "HOA: v1\n";
  if (!automaton.name.empty()) out += "name: " + quoted(automaton.name) + '\n';
  out += "tool: \"waymark\"\n";
  out += "States: " + std::to_string(automaton.states.size()) + '\n';
  for (std::uint32_t start : automaton.starts) out += "Start: " + std::to_string(start) + '\n';
  out += "AP: " + std::to_string(automaton.propositions.size());
  for (const std::string& name : automaton.propositions) out += ' ' + quoted(name);
  if (!automaton.acceptance_name.empty()) out += "\nacc-name: " + automaton.acceptance_name;
  out += "\nAcceptance: " + automaton.acceptance + "\nproperties: " + automaton.properties + '\n';
  for (const std::string& header : automaton.headers) out += header + '\n';
  return out;
}

}  // namespace

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string hoa_label(const Guard& guard) {
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
  return out.empty() ? "f" : out;
}

std::string print(const HoaText& automaton, const HoaLayout& layout) {
  const Labels labels(automaton, layout.aliases);
  std::string out = headers(automaton) + labels.definitions() + "--BODY--\n";
  for (std::size_t q = 0; q < automaton.states.size(); ++q) {
    const HoaText::State& state = automaton.states[q];
    out += "State: " + std::to_string(q) + marks_text(state.marks) + '\n';
    for (const HoaText::Edge& edge : state.edges)
      out += '[' + labels.of(edge.guard) + "] " + std::to_string(edge.target) + marks_text(edge.marks) + '\n';
  }
  out += "--END--\n";
  return layout.one_line ? on_one_line(std::move(out)) : out;
}

std::string aborted_hoa(std::string_view name, const HoaLayout& layout) {
  std::string out = "HOA: v1\n";
  if (!name.empty()) out += "name: " + quoted(name) + '\n';
  out += "--ABORT--\n";
  return layout.one_line ? on_one_line(std::move(out)) : out;
}

}  // namespace waymark::automata
