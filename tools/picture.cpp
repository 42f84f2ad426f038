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

Drawn drawn(const Picture& picture, const render::Layout& layout) {
  render::Page page{.map = picture.map, .instruction = picture.instruction, .caption = caption(picture)};
  if (picture.route) {
    page.route = trajectory_of(*picture.route, *picture.map);
    page.repeated = repeated_actions(*picture.route);
  }
  if (picture.formula) page.formula = ltl::print(*picture.formula, ltl::Style::Unicode);
  std::string left_out;
  if (picture.dfa != nullptr) {
    automata::DotOptions look;
    look.trap = automata::DotOptions::Trap::Omit;
    page.automaton = render::lay_out_or_leave_out(automata::write_dot(*picture.dfa, look), layout, left_out);
    const AutomatonSize size = size_of(*picture.dfa);
    page.automaton_caption = counted(size.states, "state") + ", " + counted(size.edges, "edge");
  }
  if (picture.omega != nullptr) {
    const std::size_t edges = automata::count_edges(picture.omega->transitions());
    const auto dot = automata::write_dot_within(*picture.omega, layout.edges);
    if (dot)
      page.automaton = render::lay_out_or_leave_out(*dot, layout, left_out);
    else
      left_out = "it has " + counted(edges, "edge") + ", and " + std::to_string(layout.edges) + " can be drawn";
    page.automaton_caption = counted(picture.omega->states(), "state") + ", " + counted(edges, "edge");
  }
  return {render::draw_page(page), left_out};
}

std::string drawn_whole(const Picture& picture, const std::stop_token& stop) {
  Drawn page = drawn(picture, {.stop = stop});
  if (!page.left_out.empty()) complain("note", "the automaton is left out of the picture: " + page.left_out);
  return std::move(page.svg);
}

void draw(const Picture& picture, const std::string& path, const std::stop_token& stop) {
  write_file(path, drawn_whole(picture, stop));
}

std::string graph_picture(const std::string& dot, const std::stop_token& stop) {
  const auto drawing = render::lay_out(dot, {.attributes = {}, .stop = stop});
  if (!drawing) (void)needed_helper("waymark-layout", "lays graphs out");
  return render::alone(*drawing);
}

void draw_graph(const std::string& dot, const std::string& path, const std::stop_token& stop) {
  write_file(path, graph_picture(dot, stop));
}

}  // namespace waymark::tools
