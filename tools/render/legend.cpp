#include "tools/render/legend.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tools/render/floors.hpp"
#include "tools/render/map_picture.hpp"
#include "tools/render/pictograms.hpp"
#include "tools/render/route_picture.hpp"

namespace waymark::render {
namespace {

constexpr double row_height = 29, heading_height = 23, section_gap = 8, sample_width = 34, text_size = 13;

struct Entry {
  std::string name;
  std::function<void(Svg&, Point centre)> sample;
};
struct Section {
  std::string title;
  std::vector<Entry> entries;
};

// The names of `all` that occur, in the order of `all`.
template <typename Occurs>
std::vector<std::string> occurring(const std::vector<std::string>& all, Occurs occurs) {
  std::vector<std::string> found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found), occurs);
  return found;
}

Section floors_of(const plan::Map& map) {
  Section section{"Floors", {}};
  for (const std::string& floor : occurring(map.floors(), [&](const std::string& name) {
         return std::any_of(map.edges().begin(), map.edges().end(),
                            [&](const plan::Edge& e) { return e.floor == name; });
       }))
    section.entries.push_back({floor, [&map, floor](Svg& svg, Point centre) {
                                 svg.rectangle(
                                     {centre.x - 14, centre.y - 10}, 28, 20,
                                     floor_fill(map.floors(), floor) + R"( stroke="#2b2b2b" stroke-width="1.2")");
                               }});
  return section;
}

// Names that are written out on the map explain themselves.
Section objects_of(const plan::Map& map) {
  Section section{"Furniture", {}};
  for (const std::string& object : occurring(map.objects(), [&](const std::string& name) {
         return !is_written_out(name) && std::any_of(map.nodes().begin(), map.nodes().end(),
                                                     [&](const plan::Node& n) { return n.object == name; });
       })) {
    if (!has_drawing(object)) section.title = "Objects";
    section.entries.push_back({object, [object](Svg& svg, Point centre) { draw_object(svg, object, centre, 20); }});
  }
  return section;
}

Section paintings_of(const plan::Map& map) {
  Section section{"Paintings", {}};
  for (const std::string& wall : occurring(map.walls(), [&](const std::string& name) {
         return std::any_of(map.edges().begin(), map.edges().end(),
                            [&](const plan::Edge& e) { return e.wall == name; });
       }))
    section.entries.push_back({wall, [wall](Svg& svg, Point centre) { draw_painting(svg, wall, centre, 17); }});
  return section;
}

Section marks_of(const plan::Map& map, RouteMarks marks) {
  Section section{"Marks", {}};
  if (marks != RouteMarks::None) {
    section.entries.push_back({"start", [](Svg& svg, Point centre) { draw_start_mark(svg, centre, 90); }});
    if (marks == RouteMarks::Route)
      section.entries.push_back({"end", [](Svg& svg, Point centre) { draw_end_mark(svg, centre, 90); }});
    else
      section.entries.push_back({"for ever from here", [](Svg& svg, Point centre) { draw_cycle_mark(svg, centre); }});
    section.entries.push_back({"n-th action", [](Svg& svg, Point centre) { draw_step_number(svg, centre, "n"); }});
  }
  if (std::any_of(map.nodes().begin(), map.nodes().end(), [](const plan::Node& n) { return n.place.has_value(); }))
    section.entries.push_back({"place", [](Svg& svg, Point centre) { draw_place_badge(svg, centre, 1); }});
  return section;
}

std::vector<Section> sections_of(const plan::Map& map, RouteMarks marks) {
  std::vector<Section> sections{floors_of(map), paintings_of(map), objects_of(map), marks_of(map, marks)};
  sections.erase(std::remove_if(sections.begin(), sections.end(), [](const Section& s) { return s.entries.empty(); }),
                 sections.end());
  return sections;
}

std::size_t columns(const std::vector<Section>& sections, double width) {
  double widest = 0;
  for (const Section& section : sections)
    for (const Entry& entry : section.entries) widest = std::max(widest, text_width(entry.name) * text_size);
  return static_cast<std::size_t>(std::max(1.0, std::floor(width / (sample_width + widest + 12))));
}

std::size_t rows(const Section& section, std::size_t columns) {
  return (section.entries.size() + columns - 1) / columns;
}

}  // namespace

double legend_height(const plan::Map& map, double width, RouteMarks marks) {
  const auto sections = sections_of(map, marks);
  double height = 0;
  for (const Section& section : sections)
    height += heading_height + row_height * static_cast<double>(rows(section, columns(sections, width))) + section_gap;
  return height;
}

void draw_legend(Svg& svg, const plan::Map& map, Point corner, double width, RouteMarks marks) {
  const auto sections = sections_of(map, marks);
  const std::size_t across = columns(sections, width);
  double y = corner.y;
  for (const Section& section : sections) {
    svg.text({corner.x, y + 14}, 13, section.title, R"(font-weight="bold" fill="#20242b")");
    y += heading_height;
    for (std::size_t i = 0; i < section.entries.size(); ++i) {
      const double x = corner.x + width / static_cast<double>(across) * static_cast<double>(i % across);
      const double middle = y + row_height * (static_cast<double>(i / across) + 0.5);
      section.entries[i].sample(svg, {x + 14, middle});
      svg.text({x + sample_width, middle + 4.5}, text_size, section.entries[i].name, R"(fill="#20242b")");
    }
    y += row_height * static_cast<double>(rows(section, across)) + section_gap;
  }
}

}  // namespace waymark::render
