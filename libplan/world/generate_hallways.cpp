#include "libplan/world/generate_hallways.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "libltl/structure/random.hpp"

namespace waymark::plan {
namespace {

constexpr std::array<std::string_view, 6> objects{"barstool", "chair", "easel", "hatrack", "lamp", "sofa"};
constexpr std::array<std::string_view, 8> floors{"blue",  "brick",  "concrete", "flower",
                                                 "grass", "gravel", "wood",     "yellow"};
constexpr std::array<std::string_view, 3> walls{"butterfly", "fish", "tower"};

using Segment = std::pair<std::uint32_t, std::uint32_t>;  // two places, the lower number first

template <std::size_t N>
std::string list(const std::array<std::string_view, N>& names) {
  std::string out;
  for (std::string_view name : names) out += (out.empty() ? "\"" : ", \"") + std::string(name) + '"';
  return '[' + out + ']';
}

class HallwayDrawing {
 public:
  explicit HallwayDrawing(const HallwayRecipe& recipe)
      : width_(recipe.width), places_(recipe.width * recipe.height), random_(recipe.seed) {}

  std::string draw(const HallwayRecipe& recipe) {
    grow_tree();
    add_segments();
    std::vector<std::string_view> furniture(places_);
    for (std::uint32_t i = 0; i < recipe.objects; ++i) {
      std::uint32_t place = below(places_);
      while (!furniture[place].empty()) place = (place + 1) % places_;
      furniture[place] = objects[i % objects.size()];
    }
    std::string out = "{\"name\": \"hallway-" + std::to_string(recipe.width) + 'x' + std::to_string(recipe.height) +
                      "-s" + std::to_string(recipe.seed) + "\",\n \"objects\": " + list(objects) +
                      ",\n \"floors\": " + list(floors) + ",\n \"walls\": " + list(walls) + ",\n \"nodes\": [\n";
    for (std::uint32_t p = 0; p < places_; ++p)
      out += "  {\"x\": " + std::to_string(p % width_) + ", \"y\": " + std::to_string(p / width_) +
             (furniture[p].empty() ? "" : ", \"object\": \"" + std::string(furniture[p]) + '"') +
             (p + 1 < places_ ? "},\n" : "}\n");
    out += " ],\n \"edges\": [\n";
    for (std::size_t i = 0; i < segments_.size(); ++i)
      out += "  " + segment(segments_[i]) + (i + 1 < segments_.size() ? ",\n" : "\n");
    return out + " ]}\n";
  }

 private:
  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(random_.below(bound)); }

  std::vector<std::uint32_t> neighbours(std::uint32_t p) const {
    std::vector<std::uint32_t> out;
    if (p >= width_) out.push_back(p - width_);
    if (p % width_ + 1 < width_) out.push_back(p + 1);
    if (p + width_ < places_) out.push_back(p + width_);
    if (p % width_ > 0) out.push_back(p - 1);
    return out;
  }

  void grow_tree() {
    std::vector<bool> met(places_);
    std::vector<std::uint32_t> trail{0};
    met[0] = true;
    while (!trail.empty()) {
      const std::uint32_t here = trail.back();
      std::vector<std::uint32_t> ways;
      for (std::uint32_t next : neighbours(here))
        if (!met[next]) ways.push_back(next);
      if (ways.empty()) {
        trail.pop_back();
        continue;
      }
      const std::uint32_t next = ways[below(static_cast<std::uint32_t>(ways.size()))];
      met[next] = true;
      segments_.emplace_back(std::min(here, next), std::max(here, next));
      trail.push_back(next);
    }
  }

  void add_segments() {
    const std::vector<Segment> tree = segments_;
    std::vector<std::array<bool, 2>> there(places_);  // a segment eastwards, southwards
    for (const auto& [a, b] : tree) there[a][b == a + 1 ? 0 : 1] = true;
    for (std::uint32_t p = 0; p < places_; ++p) {
      if (p % width_ + 1 < width_ && !there[p][0] && below(3) == 0) segments_.emplace_back(p, p + 1);
      if (p + width_ < places_ && !there[p][1] && below(3) == 0) segments_.emplace_back(p, p + width_);
    }
  }

  std::string segment(const Segment& s) {
    const auto place = [&](std::uint32_t p) {
      return '[' + std::to_string(p % width_) + ',' + std::to_string(p / width_) + ']';
    };
    const std::string_view floor = floors[below(static_cast<std::uint32_t>(floors.size()))],
                           wall = walls[below(static_cast<std::uint32_t>(walls.size()))];
    return "{\"a\": " + place(s.first) + ", \"b\": " + place(s.second) + ", \"floor\": \"" + std::string(floor) +
           "\", \"wall\": \"" + std::string(wall) + "\"}";
  }

  const std::uint32_t width_, places_;
  ltl::Random random_;
  std::vector<Segment> segments_;
};

}  // namespace

std::string generate_hallways(const HallwayRecipe& recipe) {
  const std::uint64_t places = std::uint64_t{recipe.width} * recipe.height;
  if (places < 2 || places > 10'000) throw std::invalid_argument("a hallway map has 2 to 10000 places");
  if (recipe.objects > places) throw std::invalid_argument("more objects than places");
  return HallwayDrawing(recipe).draw(recipe);
}

}  // namespace waymark::plan
