// The picture of an answer: which page to draw, and a word where a part of it has to be left out.
#pragma once
#include <optional>
#include <string>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/formula.hpp"
#include "tools/shown_route.hpp"

namespace waymark::tools {

struct Picture {
  const plan::Map* map = nullptr;
  const automata::Dfa* dfa = nullptr;          // may be absent
  const automata::Automaton* omega = nullptr;  // the same of a task over infinite words
  std::string instruction = {};
  std::optional<ltl::Formula> formula = {};
  std::optional<ShownRoute> route = {};
  std::optional<std::size_t> lost = {};  // after so many actions no continuation satisfies the formula
};

// The SVG document; says in `automaton_left_out` whether an automaton is missing there.
struct Drawn {
  std::string svg;
  bool automaton_left_out = false;
};
Drawn drawn(const Picture& picture);
// The SVG document. Without the helper waymark-layout the automaton is left out, and standard error says so.
std::string drawn_whole(const Picture& picture);
// Writes it to `path`.
void draw(const Picture& picture, const std::string& path);

// A graph in DOT, laid out, as an SVG document. Throws UsageError when waymark-layout is not installed.
std::string graph_picture(const std::string& dot);
// The same, written to `path`.
void draw_graph(const std::string& dot, const std::string& path);
// Graphs beyond this size take minutes to be laid out and cannot be read.
inline constexpr std::size_t most_drawn_states = 100, most_drawn_edges = 400;

}  // namespace waymark::tools
