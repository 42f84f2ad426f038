#include "libplan/model/formats/generate_roads.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libplan/model/formats/road_mesh.hpp"

namespace waymark::plan {
namespace {

constexpr double shape_points = 3;  // of a street, on average
constexpr double streets_a_junction = 1.4;
constexpr std::array<double, 4> metres_a_second{33, 25, 17, 10};  // by RoadMesh::Kind
constexpr std::uint32_t none = UINT32_MAX;

// Whole numbers between words, in large blocks.
class NumberLines {
 public:
  explicit NumberLines(std::ostream& out) : out_(out) {}
  ~NumberLines() { flush(); }
  NumberLines(const NumberLines&) = delete;
  NumberLines& operator=(const NumberLines&) = delete;
  NumberLines& word(std::string_view text) {
    block_ += text;
    return *this;
  }
  NumberLines& number(std::uint64_t value) {
    std::array<char, 20> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    block_.append(digits.data(), end);
    return *this;
  }
  void end() {
    block_ += '\n';
    if (block_.size() > (std::size_t{1} << 20U)) flush();
  }

 private:
  void flush() {
    out_ << block_;
    block_.clear();
  }
  std::ostream& out_;
  std::string block_;
};

struct Disc {
  double x, y, radius;
};
using Discs = std::vector<Disc>;

bool covers(const Discs& discs, double x, double y) {
  return std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
    return (x - disc.x) * (x - disc.x) + (y - disc.y) * (y - disc.y) < disc.radius * disc.radius;
  });
}

class Country {
 public:
  explicit Country(const RoadRecipe& recipe)
      : recipe_(recipe),
        random_(recipe.seed),
        mesh_(draw_mesh(static_cast<std::uint32_t>(recipe.nodes / (1 + streets_a_junction * shape_points)), random_)) {
    shape();
    hazards_ = discs();
    others_ = discs();
    place_landmarks();
  }

  void write(std::ostream& gr, std::ostream& co, std::ostream& lab) const {
    std::size_t arcs = 0;
    for (std::size_t s = 0; s < mesh_.streets.size(); ++s)
      arcs += (std::size_t{shapes_[s]} + 1) * (mesh_.streets[s].one_way ? 1 : 2);
    NumberLines roads(gr), places(co), labels(lab);
    roads.word("c a country of waymark generate roads, seed ")
        .number(recipe_.seed)
        .word("; costs in tenths of seconds");
    roads.end();
    roads.word("p sp ").number(recipe_.nodes).word(" ").number(arcs).end();
    places.word("p aux sp co ").number(recipe_.nodes).end();
    labels.word("0=\"init\" 1=\"x\" 2=\"y\"");
    for (std::size_t l = 0; l + 1 < stops_.size(); ++l)
      labels.word(" ").number(l + 3).word("=\"").word(std::string(1, static_cast<char>('a' + l))).word("\"");
    labels.end();
    std::size_t street = 0;
    for (std::uint32_t j = 0; j < mesh_.junctions.size(); ++j) {
      write_place(number_[j], mesh_.junctions[j].x, mesh_.junctions[j].y, j, places, labels);
      for (; street < mesh_.streets.size() && mesh_.streets[street].a == j; ++street)
        write_street(street, roads, places, labels);
    }
  }

 private:
  // Every shape point belongs to a street drawn at random; nodes are numbered junction by junction, with the streets
  // that begin there.
  void shape() {
    if (mesh_.junctions.size() > recipe_.nodes) throw std::logic_error("more junctions than nodes");
    shapes_.assign(mesh_.streets.size(), 0);
    for (std::size_t i = mesh_.junctions.size(); i < recipe_.nodes; ++i) ++shapes_[random_.below(shapes_.size())];
    std::uint32_t next = 1;
    std::size_t street = 0;
    for (std::uint32_t j = 0; j < mesh_.junctions.size(); ++j) {
      number_.push_back(next++);
      for (; street < mesh_.streets.size() && mesh_.streets[street].a == j; ++street) next += shapes_[street];
    }
  }

  Discs discs() {
    constexpr int count = 24;
    Discs out;
    for (int i = 0; i < count; ++i) {
      const double radius =
          mesh_.side * std::sqrt(recipe_.avoided / count / 3.14159265358979) * (0.6 + 0.8 * random_.unit());
      const double x = random_.unit() * mesh_.side, y = random_.unit() * mesh_.side;
      out.push_back({x, y, radius});
    }
    return out;
  }

  std::pair<double, double> place(std::size_t street, std::uint32_t shape) const {
    const RoadMesh::Junction &a = mesh_.junctions[mesh_.streets[street].a],
                             &b = mesh_.junctions[mesh_.streets[street].b];
    const double t = static_cast<double>(shape) / (shapes_[street] + 1);
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  }
  bool meets_hazard(std::size_t street) const {
    for (std::uint32_t i = 0; i <= shapes_[street] + 1U; ++i)
      if (const auto [x, y] = place(street, i); covers(hazards_, x, y)) return true;
    return false;
  }

  // In the largest part that two-way streets past no hazard connect; the start is the last.
  void place_landmarks() {
    std::vector<std::uint32_t> root(mesh_.junctions.size()), size(mesh_.junctions.size(), 1);
    for (std::uint32_t j = 0; j < root.size(); ++j) root[j] = j;
    const auto find = [&](std::uint32_t v) {
      while (root[v] != v) v = root[v] = root[root[v]];
      return v;
    };
    for (std::size_t s = 0; s < mesh_.streets.size(); ++s) {
      const std::uint32_t a = find(mesh_.streets[s].a), b = find(mesh_.streets[s].b);
      if (a == b || mesh_.streets[s].one_way || meets_hazard(s)) continue;
      root[a] = b;
      size[b] += size[a];
    }
    std::uint32_t largest = find(0);
    for (std::uint32_t j = 0; j < root.size(); ++j)
      if (size[find(j)] > size[largest]) largest = find(j);
    if (size[largest] <= recipe_.landmarks) throw std::invalid_argument("no room for so many landmarks");
    while (stops_.size() <= recipe_.landmarks) {
      const auto j = static_cast<std::uint32_t>(random_.below(root.size()));
      if (find(j) == largest && std::find(stops_.begin(), stops_.end(), j) == stops_.end()) stops_.push_back(j);
    }
  }

  void write_place(std::uint32_t node, double x, double y, std::uint32_t junction, NumberLines& places,
                   NumberLines& labels) const {
    places.word("v ").number(node).word(" ").number(static_cast<std::uint64_t>(x)).word(" ");
    places.number(static_cast<std::uint64_t>(y)).end();
    const auto stop = junction == none ? stops_.end() : std::find(stops_.begin(), stops_.end(), junction);
    const bool hazard = covers(hazards_, x, y), other = covers(others_, x, y);
    if (stop == stops_.end() && !hazard && !other) return;
    labels.number(node).word(":");
    if (hazard) labels.word(" 1");
    if (other) labels.word(" 2");
    if (stop != stops_.end()) {
      const auto l = static_cast<std::uint64_t>(stop - stops_.begin());
      labels.word(" ").number(l + 1 == stops_.size() ? 0 : l + 3);
    }
    labels.end();
  }

  void write_street(std::size_t s, NumberLines& roads, NumberLines& places, NumberLines& labels) const {
    const RoadMesh::Street& street = mesh_.streets[s];
    const RoadMesh::Junction &a = mesh_.junctions[street.a], &b = mesh_.junctions[street.b];
    const std::uint32_t pieces = shapes_[s] + 1U;
    // Streets bend: up to a third longer than straight lines, by a number that belongs to the street.
    const double bend = 1 + static_cast<double>((s * 2654435761U) % 1000U) / 3000;
    const double tenths =
        10 * bend * std::hypot(b.x - a.x, b.y - a.y) / pieces / metres_a_second[static_cast<std::size_t>(street.kind)];
    const auto cost = static_cast<std::uint64_t>(std::max(1.0, std::nearbyint(tenths)));
    // Its shape points follow those of the streets before it that begin at the same junction.
    std::uint32_t first = number_[street.a] + 1;
    for (std::size_t before = s; before-- > 0 && mesh_.streets[before].a == street.a;) first += shapes_[before];
    std::uint32_t last = number_[street.a];
    for (std::uint32_t i = 1; i <= pieces; ++i) {
      const std::uint32_t here = i == pieces ? number_[street.b] : first + i - 1;
      roads.word("a ").number(last).word(" ").number(here).word(" ").number(cost).end();
      if (!street.one_way) roads.word("a ").number(here).word(" ").number(last).word(" ").number(cost).end();
      last = here;
      if (i == pieces) break;
      const auto [x, y] = place(s, i);
      write_place(here, x, y, none, places, labels);
    }
  }

  const RoadRecipe& recipe_;
  ltl::Random random_;
  RoadMesh mesh_;
  std::vector<std::uint16_t> shapes_;  // by street
  std::vector<std::uint32_t> number_;  // by junction: its node
  Discs hazards_, others_;
  std::vector<std::uint32_t> stops_;  // junctions of the landmarks, then the start
};

}  // namespace

void generate_roads(const RoadRecipe& recipe, std::ostream& gr, std::ostream& co, std::ostream& lab) {
  if (recipe.nodes < 100 || recipe.nodes > 500'000'000)
    throw std::invalid_argument("expected 100 to 500,000,000 nodes");
  if (recipe.landmarks > RoadRecipe::most_landmarks) throw std::invalid_argument("expected at most 20 landmarks");
  if (!(recipe.avoided >= 0 && recipe.avoided <= 0.3)) throw std::invalid_argument("expected a part from 0 to 0.3");
  Country(recipe).write(gr, co, lab);
}

}  // namespace waymark::plan
