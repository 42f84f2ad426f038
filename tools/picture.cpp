#include "tools/picture.hpp"

#include "libautomata/hoa/dot_finite.hpp"
#include "libautomata/hoa/dot_omega.hpp"
#include "libltl/text/print.hpp"
#include "tools/answer.hpp"
#include "tools/render/page.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

std::string caption(const Picture& picture) {
  std::string text = "map " + picture.map->name();
  if (!picture.route) return text;
  const plan::Trajectory walk = trajectory_of(*picture.route, *picture.map);
  const plan::Pose start = picture.map->pose(walk.poses.front());
  text +=
      ", from (" + std::to_string(start.x) + ',' + std::to_string(start.y) + ") facing " + heading_name(start.heading);
  text += ", " + counted(walk.actions.size(), "action");
  if (const std::size_t cycle = repeated_actions(*picture.route))
    text += ", the last " + std::to_string(cycle) + " for ever";
  if (picture.lost)
    text += ", lost at " + (*picture.lost == 0 ? "the start" : "action " + std::to_string(*picture.lost));
  return certifier(*picture.route) ? text + ", certified" : text;
}

}  // namespace

Drawn drawn(const Picture& picture) {
  render::Page page{.map = picture.map, .instruction = picture.instruction, .caption = caption(picture)};
  if (picture.route) {
    page.route = trajectory_of(*picture.route, *picture.map);
    page.repeated = repeated_actions(*picture.route);
  }
  if (picture.formula) page.formula = ltl::print(*picture.formula, ltl::Style::Unicode);
  if (picture.dfa != nullptr) {
    automata::DotOptions look;
    look.trap = automata::DotOptions::Trap::Omit;
    page.automaton = render::lay_out(automata::write_dot(*picture.dfa, look));
    const AutomatonSize size = size_of(*picture.dfa);
    page.automaton_caption = counted(size.states, "state") + ", " + counted(size.edges, "edge");
  }
  if (picture.omega != nullptr) {
    constexpr std::size_t most_edges = 1000;  // more cannot be read
    if (const auto dot = automata::write_dot_within(*picture.omega, most_edges)) page.automaton = render::lay_out(*dot);
    page.automaton_caption = counted(picture.omega->states(), "state") + ", " +
                             counted(automata::count_edges(picture.omega->transitions()), "edge");
  }
  const bool left_out = (picture.dfa != nullptr || picture.omega != nullptr) && !page.automaton;
  return {render::draw_page(page), left_out};
}

std::string drawn_whole(const Picture& picture) {
  Drawn page = drawn(picture);
  if (page.automaton_left_out)
    complain("note", "the automaton is left out of the picture: it is too large, or waymark-layout is not installed");
  return std::move(page.svg);
}

void draw(const Picture& picture, const std::string& path) { write_file(path, drawn_whole(picture)); }

std::string graph_picture(const std::string& dot) {
  const auto drawing = render::lay_out(dot, {});
  if (!drawing) (void)needed_helper("waymark-layout", "lays graphs out");
  return render::alone(*drawing);
}

void draw_graph(const std::string& dot, const std::string& path) { write_file(path, graph_picture(dot)); }

}  // namespace waymark::tools
