// The picture of an answer: which page to draw, and a word where a part of it has to be left out.
#pragma once
#include <optional>
#include <stop_token>
#include <string>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/formula.hpp"
#include "tools/render/automaton_picture.hpp"
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

// The SVG document; says in `left_out` why an automaton is missing there: the helper waymark-layout is not installed,
// or the automaton is too large. Throws GaveUp when the layout is stopped.
struct Drawn {
  std::string svg;
  std::string left_out = {};
};
Drawn drawn(const Picture& picture, const render::Layout& layout = {});
// The SVG document. Where the automaton is left out, standard error says so.
std::string drawn_whole(const Picture& picture, const std::stop_token& stop = {});
// Writes it to `path`.
void draw(const Picture& picture, const std::string& path, const std::stop_token& stop = {});

// A graph in DOT, laid out, as an SVG document. Throws UsageError when waymark-layout is not installed, GaveUp for a
// graph that is too large and when it is stopped.
std::string graph_picture(const std::string& dot, const std::stop_token& stop);
// The same, written to `path`.
void draw_graph(const std::string& dot, const std::string& path, const std::stop_token& stop);
using render::most_drawn_edges, render::most_drawn_states;

}  // namespace waymark::tools
