#include "tools/terminal_map.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t least_name = 1, greatest_name = 10, hallway = 3;

// What a character of the picture belongs to; greater ones are drawn over others.
enum class Part : std::uint8_t { Nothing, Hallway, Place, Route, Cycle, Start, End };

struct Glyphs {
  std::array<std::string_view, 3> across, down;  // of hallways, of the route, of its cycle
  std::array<std::string_view, 4> arrows;        // by heading / 90
  std::string_view place, end;
};
constexpr Glyphs unicode{{"─", "━", "═"}, {"│", "┃", "║"}, {"▲", "▶", "▼", "◀"}, "·", "◎"};
constexpr Glyphs ascii{{"-", "=", "~"}, {"|", "H", "S"}, {"^", ">", "v", "<"}, "+", "@"};

// The first characters of a text in UTF-8.
std::string cut(const std::string& text, std::size_t characters) {
  std::string out;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U && ltl::utf8_length(out) == characters) break;
    out += c;
  }
  return out;
}

class Canvas {
 public:
  Canvas(const plan::Map& map, const Glyphs& glyphs, std::size_t columns) : map_(map), glyphs_(glyphs) {
    const auto& nodes = map.nodes();
    const auto [west, east] =
        std::minmax_element(nodes.begin(), nodes.end(), [](auto& a, auto& b) { return a.x < b.x; });
    const auto [north, south] =
        std::minmax_element(nodes.begin(), nodes.end(), [](auto& a, auto& b) { return a.y < b.y; });
    west_ = west->x, north_ = north->y;
    const auto wide = static_cast<std::size_t>(east->x - west->x) + 1,
               high = static_cast<std::size_t>(south->y - north_) + 1;
    std::size_t longest = least_name;
    for (const plan::Node& node : nodes)
      if (node.object) longest = std::max(longest, ltl::utf8_length(*node.object));
    const std::size_t room = (columns + hallway) / wide;  // for a place, its two marks and the hallway behind it
    name_ =
        std::clamp(room > hallway + 2 ? room - hallway - 2 : least_name, least_name, std::min(longest, greatest_name));
    cells_.assign(2 * high - 1, std::vector<Cell>(wide * pitch() - hallway));
  }

  void draw_map() {
    for (const plan::Edge& edge : map_.edges()) connect(edge.a, edge.b, Part::Hallway);
    for (std::uint32_t n = 0; n < map_.nodes().size(); ++n) {
      const auto& object = map_.nodes()[n].object;
      const std::string text = object ? cut(*object, name_) : std::string(glyphs_.place);
      const std::size_t width = ltl::utf8_length(text), from = column(n) + 1 + (name_ - width) / 2;
      for (std::size_t i = 0, at = 0; i < width; ++i) {
        std::size_t end = at + 1;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
        set(row(n), from + i, text.substr(at, end - at), Part::Place);
        at = end;
      }
    }
  }

  void draw_route(const plan::Trajectory& route, std::size_t repeated) {
    const std::size_t prefix = route.actions.size() - repeated;
    for (std::size_t i = 0; i < route.actions.size(); ++i)
      if (route.actions[i] == plan::Action::Forward)
        connect(map_.node_of(route.poses[i]), map_.node_of(route.poses[i + 1]), i < prefix ? Part::Route : Part::Cycle);
    const std::uint32_t start = map_.node_of(route.poses.front()), end = map_.node_of(route.poses.back());
    set(row(start), column(start), std::string(glyphs_.arrows[route.poses.front().index % 4]), Part::Start);
    set(row(end), column(end) + name_ + 1, std::string(glyphs_.end), repeated > 0 ? Part::Cycle : Part::End);
  }

  std::string text(const Terminal& terminal) const {
    std::string out;
    for (const std::vector<Cell>& line : cells_) {
      auto last = line.end();
      while (last != line.begin() && (last - 1)->part == Part::Nothing) --last;
      for (auto at = line.begin(); at != last;) {
        const Part part = at->part;
        std::string run;
        for (; at != last && at->part == part; ++at) run += at->glyph;
        out += painted(run, part, terminal);
      }
      out += '\n';
    }
    return out;
  }

 private:
  struct Cell {
    std::string glyph = " ";
    Part part = Part::Nothing;
  };

  std::size_t pitch() const { return name_ + 2 + hallway; }
  std::size_t column(std::uint32_t n) const { return static_cast<std::size_t>(map_.nodes()[n].x - west_) * pitch(); }
  std::size_t row(std::uint32_t n) const { return 2 * static_cast<std::size_t>(map_.nodes()[n].y - north_); }
  void set(std::size_t row, std::size_t column, std::string glyph, Part part) {
    Cell& cell = cells_[row][column];
    if (part >= cell.part) cell = {std::move(glyph), part};
  }
  void connect(std::uint32_t a, std::uint32_t b, Part part) {
    const std::size_t kind = part == Part::Hallway ? 0 : part == Part::Route ? 1 : 2;
    if (row(a) == row(b)) {
      const std::size_t from = std::min(column(a), column(b)), to = std::max(column(a), column(b));
      // from behind the name and its mark to before the mark of the next
      for (std::size_t c = from + name_ + 2; c < to; ++c) set(row(a), c, std::string(glyphs_.across[kind]), part);
    } else {
      const std::size_t from = std::min(row(a), row(b)), to = std::max(row(a), row(b));
      for (std::size_t r = from + 1; r < to; ++r)
        set(r, column(a) + 1 + (name_ - 1) / 2, std::string(glyphs_.down[kind]), part);
    }
  }
  static std::string painted(const std::string& run, Part part, const Terminal& terminal) {
    switch (part) {
      case Part::Nothing:
      case Part::Place: return run;
      case Part::Hallway: return terminal.paint(Paint::Dim, run);
      case Part::Start: return terminal.paint(Paint::Green, run);
      case Part::Cycle: return terminal.paint(Paint::Blue, run);
      case Part::Route:
      case Part::End: break;
    }
    return terminal.paint(Paint::Red, run);
  }

  const plan::Map& map_;
  const Glyphs& glyphs_;
  int west_ = 0, north_ = 0;
  std::size_t name_ = least_name;
  std::vector<std::vector<Cell>> cells_;
};

}  // namespace

std::string terminal_map(const plan::Map& map, const std::optional<ShownRoute>& route, const Terminal& terminal,
                         std::size_t columns) {
  const Glyphs& glyphs = terminal.unicode ? unicode : ascii;
  Canvas canvas(map, glyphs, columns);
  canvas.draw_map();
  std::string legend;
  if (route) {
    const std::size_t cycle = repeated_actions(*route);
    const plan::Trajectory walk = trajectory_of(*route, map);
    canvas.draw_route(walk, cycle);
    legend = '\n' + std::string(glyphs.arrows[walk.poses.front().index % 4]) + " start   " +
             std::string(glyphs.across[1]) +
             (cycle > 0 ? " prefix   " + std::string(glyphs.across[2]) + " cycle   " : " route   ") +
             std::string(glyphs.end) + (cycle > 0 ? " where the cycle begins and ends\n" : " end\n");
  }
  return canvas.text(terminal) + legend;
}

}  // namespace waymark::tools
