#include "tools/studio/maps.hpp"

#include "tools/render/floors.hpp"
#include "tools/render/map_picture.hpp"
#include "tools/render/plan_view.hpp"
#include "tools/shell/options.hpp"

namespace waymark::studio {
namespace {

using tools::Json;
using tools::JsonArray;
using tools::JsonObject;

std::string drawing_of(render::PlanView& view) {
  const plan::Map& map = view.map();
  render::Svg svg;
  svg.open_picture(view.width(), view.height());
  svg.open("defs");
  render::define_floors(svg, map.floors());
  svg.close("defs");
  render::draw_map(svg, view);
  render::draw_place_numbers(svg, view);
  svg.close("svg");
  return svg.str();
}

JsonArray json_of(const std::vector<std::string>& texts) {
  JsonArray out;
  for (const std::string& text : texts) out.add(text);
  return out;
}

JsonArray nodes_json(const render::PlanView& view) {
  JsonArray out;
  const auto& nodes = view.map().nodes();
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const render::Point centre = view.centre(i);
    JsonArray ways;
    for (const int heading : {0, 90, 180, 270})
      if (view.map().neighbour(i, heading)) ways.add(heading);
    JsonObject node;
    node.add("x", nodes[i].x).add("y", nodes[i].y).add("at", JsonArray().add(centre.x).add(centre.y));
    if (nodes[i].object) node.add("object", *nodes[i].object);
    if (nodes[i].place) node.add("place", *nodes[i].place);
    out.add(node.add("ways", ways));
  }
  return out;
}

JsonObject json_of(const World& world) {
  const plan::Map& map = world.map;
  render::PlanView view(map);
  const plan::Pose start = map.pose(tools::start_poses("", map).front());
  return JsonObject()
      .add("map", world.id)
      .add("name", map.name())
      .add("start", JsonArray().add(start.x).add(start.y).add(start.heading))
      .add("nodes", nodes_json(view))
      .add("propositions", json_of(map.vocabulary().names()))
      .add("floors", json_of(map.floors()))
      .add("width", view.width())
      .add("height", view.height())
      .add("svg", drawing_of(view));
}

}  // namespace

JsonObject list_maps(const Context& context) { return JsonObject().add("maps", json_of(context.worlds.names())); }

JsonObject show_map(const Request& request, const Context& context) {
  return json_of(*context.worlds.of(request.text_or("map", "grid")));
}

JsonObject add_map(std::string_view file, const Context& context) { return json_of(*context.worlds.add(file)); }

}  // namespace waymark::studio
