#include "libplan/model/formats/road_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace waymark::plan {
namespace {

constexpr unsigned deepest = 16;                // divisions: the sides of squares are 2^(16 − depth) units
constexpr std::uint32_t units = 1U << deepest;  // of the whole side
constexpr std::uint32_t raster = 256;           // squares a side in which density is constant
constexpr double country_block = 900;           // metres between junctions far from towns
constexpr double kept_besides_tree = 0.37;      // chance of a street that the tree does not need
constexpr double one_way = 0.06;                // chance of such a street in a town
constexpr double junctions_a_town = 4000;

struct Town {
  double x, y;       // of the side
  double radius;     // of the side
  double divisions;  // more in its middle
};

struct Square {
  std::uint32_t curve;  // the Morton number of its first unit
  std::uint8_t depth;
};

std::uint32_t spread(std::uint32_t v) {  // a bit free between any two
  v = (v | (v << 8U)) & 0x00FF00FFU;
  v = (v | (v << 4U)) & 0x0F0F0F0FU;
  v = (v | (v << 2U)) & 0x33333333U;
  return (v | (v << 1U)) & 0x55555555U;
}
std::uint32_t gather(std::uint32_t v) {
  v &= 0x55555555U;
  v = (v | (v >> 1U)) & 0x33333333U;
  v = (v | (v >> 2U)) & 0x0F0F0F0FU;
  v = (v | (v >> 4U)) & 0x00FF00FFU;
  return (v | (v >> 8U)) & 0x0000FFFFU;
}
std::uint32_t curve_of(std::uint32_t x, std::uint32_t y) { return spread(x) | (spread(y) << 1U); }

// A number in [0, 1) that belongs to a square and a seed.
double noise(std::uint32_t curve, unsigned depth, std::uint64_t seed) {
  std::uint64_t z = seed + (std::uint64_t{curve} << 8U) + depth + 0x9E3779B97F4A7C15U;  // SplitMix64
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

class Mesh {
 public:
  Mesh(std::uint32_t junctions, ltl::Random& random) : random_(random), seed_(random.below(SIZE_MAX)) {
    draw_towns(junctions);
    divide(junctions);
  }

  RoadMesh draw() {
    place_junctions();
    join_neighbours();
    draw_main_roads();
    thin_out();
    return std::move(mesh_);
  }

 private:
  // Sizes fall off with the rank of a town, as Zipf's law has it.
  void draw_towns(std::uint32_t junctions) {
    const auto count = static_cast<std::size_t>(std::max(4.0, junctions / junctions_a_town));
    for (std::size_t i = 0; i < count; ++i) {
      const double size = 1 / std::sqrt(static_cast<double>(i + 1));
      towns_.push_back(
          {0.02 + 0.96 * random_.unit(), 0.02 + 0.96 * random_.unit(),
           0.35 * size / std::sqrt(static_cast<double>(count)) + 0.08 / std::sqrt(static_cast<double>(count)),
           2.5 + 1.5 * size});
    }
    denser_.assign(std::size_t{raster} * raster, 0);
    for (const Town& town : towns_)
      for (std::uint32_t y = 0; y < raster; ++y)
        for (std::uint32_t x = 0; x < raster; ++x) {
          const double dx = (x + 0.5) / raster - town.x, dy = (y + 0.5) / raster - town.y;
          double& here = denser_[std::size_t{y} * raster + x];
          here = std::max(here, town.divisions * std::exp(-std::hypot(dx, dy) / town.radius));
        }
  }

  bool is_divided(std::uint32_t curve, unsigned depth, double base) const {
    if (depth >= deepest) return false;
    const std::uint32_t half = units >> (depth + 1), x = gather(curve) + half, y = gather(curve >> 1U) + half;
    const double wanted = base + denser_[std::size_t{y * raster / units} * raster + x * raster / units];
    return depth + noise(curve, depth, seed_) < wanted;
  }
  template <class Visit>
  void for_each_square(double base, std::uint32_t curve, unsigned depth, const Visit& visit) const {
    if (!is_divided(curve, depth, base)) return visit(Square{curve, static_cast<std::uint8_t>(depth)});
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
      for_each_square(base, curve + (quarter << (2 * (deepest - depth - 1))), depth + 1, visit);
  }

  // As many squares as wanted: their number grows with the base.
  void divide(std::uint32_t junctions) {
    double low = 0, high = deepest;
    for (int i = 0; i < 12; ++i) {
      const double base = (low + high) / 2;
      std::uint32_t count = 0;
      // More would only be counted to be thrown away.
      if (std::exp2(2 * base) > 4.0 * junctions)
        count = UINT32_MAX;
      else
        for_each_square(base, 0, 0, [&](const Square&) { ++count; });
      (count > junctions ? high : low) = base;
    }
    for_each_square(low, 0, 0, [&](const Square& square) { squares_.push_back(square); });
    mesh_.side = country_block * std::exp2(low);
  }

  void place_junctions() {
    for (const Square& square : squares_) {
      const double size = units >> square.depth;
      const auto inside = [&](std::uint32_t from) {
        return (from + size * (0.2 + 0.6 * random_.unit())) / units * mesh_.side;
      };
      const double x = inside(gather(square.curve)), y = inside(gather(square.curve >> 1U));
      mesh_.junctions.push_back({x, y});
    }
  }

  std::uint32_t square_at(std::uint32_t x, std::uint32_t y) const {
    const auto after = std::upper_bound(squares_.begin(), squares_.end(), curve_of(x, y),
                                        [](std::uint32_t c, const Square& square) { return c < square.curve; });
    return static_cast<std::uint32_t>(after - squares_.begin() - 1);
  }

  // Every side of a square beside the middle of another one's: each pair once, from the smaller square.
  void join_neighbours() {
    for (std::uint32_t i = 0; i < squares_.size(); ++i) {
      const std::uint32_t size = units >> squares_[i].depth, x = gather(squares_[i].curve),
                          y = gather(squares_[i].curve >> 1U);
      const auto join = [&](std::uint32_t to_x, std::uint32_t to_y) {  // outside of the country: past 2^32
        if (to_x >= units || to_y >= units) return;
        const std::uint32_t j = square_at(to_x, to_y);
        if (squares_[j].depth > squares_[i].depth || (squares_[j].depth == squares_[i].depth && j < i)) return;
        mesh_.streets.push_back({std::min(i, j), std::max(i, j), kind_of(i, j), false});
      };
      join(x + size, y + size / 2);
      join(x - 1, y + size / 2);
      join(x + size / 2, y + size);
      join(x + size / 2, y - 1);
    }
    std::sort(mesh_.streets.begin(), mesh_.streets.end(), before);
  }
  static bool before(const RoadMesh::Street& s, const RoadMesh::Street& t) {
    return std::pair(s.a, s.b) < std::pair(t.a, t.b);
  }
  RoadMesh::Kind kind_of(std::uint32_t i, std::uint32_t j) const {
    const double metres = mesh_.side / std::exp2(std::min(squares_[i].depth, squares_[j].depth));
    return metres < country_block / 3 ? RoadMesh::Kind::Town : RoadMesh::Kind::Country;
  }

  // From every town straight to the two nearest that are larger.
  void draw_main_roads() {
    main_.assign(mesh_.streets.size(), false);
    for (std::size_t t = 1; t < towns_.size(); ++t) {
      std::vector<std::pair<double, std::size_t>> larger;
      for (std::size_t u = 0; u < t; ++u)
        larger.emplace_back(std::hypot(towns_[u].x - towns_[t].x, towns_[u].y - towns_[t].y), u);
      std::sort(larger.begin(), larger.end());
      if (larger.size() > 2) larger.resize(2);
      const bool large = t < std::max<std::size_t>(4, towns_.size() / 6);
      for (const auto& [distance, u] : larger)
        draw_line(towns_[t], towns_[u], large ? RoadMesh::Kind::Motorway : RoadMesh::Kind::Main);
    }
  }
  void draw_line(const Town& from, const Town& to, RoadMesh::Kind kind) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy) * units;
    std::optional<std::uint32_t> last;
    for (double at = 0; at < length;) {
      const auto x = static_cast<std::uint32_t>((from.x + dx * at / length) * units),
                 y = static_cast<std::uint32_t>((from.y + dy * at / length) * units);
      const std::uint32_t here = square_at(std::min(x, units - 1), std::min(y, units - 1));
      if (last && *last != here) mark(*last, here, kind);
      last = here;
      at += 0.5;  // half a unit: two squares in a row share a side, or a corner where no street is marked
      const double size = units >> squares_[here].depth;
      if (size > 4) at += leaps_over(here, x, y) * 0.5;
    }
  }
  // How far one can go from a point of a square without leaving it, at least.
  double leaps_over(std::uint32_t square, std::uint32_t x, std::uint32_t y) const {
    const std::uint32_t size = units >> squares_[square].depth, left = gather(squares_[square].curve),
                        low = gather(squares_[square].curve >> 1U);
    const std::uint32_t inside = std::min({x - left, left + size - 1 - x, y - low, low + size - 1 - y});
    return std::min<std::uint32_t>(inside, size);
  }
  void mark(std::uint32_t i, std::uint32_t j, RoadMesh::Kind kind) {
    const RoadMesh::Street wanted{std::min(i, j), std::max(i, j)};
    const auto street = std::lower_bound(mesh_.streets.begin(), mesh_.streets.end(), wanted, before);
    if (street == mesh_.streets.end() || street->a != wanted.a || street->b != wanted.b) return;
    street->kind = std::min(street->kind, kind);
    main_[static_cast<std::size_t>(street - mesh_.streets.begin())] = true;
  }

  // A spanning tree drawn at random, main roads, and some of the rest.
  void thin_out() {
    std::vector<std::uint32_t> order(mesh_.streets.size()), root(squares_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::iota(root.begin(), root.end(), 0U);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random_.below(i)]);
    const auto find = [&](std::uint32_t v) {
      while (root[v] != v) v = root[v] = root[root[v]];
      return v;
    };
    std::vector<bool> kept(order.size(), false);
    for (const std::uint32_t s : order) {
      RoadMesh::Street& street = mesh_.streets[s];
      const std::uint32_t a = find(street.a), b = find(street.b);
      kept[s] = a != b || main_[s];
      if (a == b && !main_[s]) {
        kept[s] = random_.chance(kept_besides_tree);
        street.one_way = street.kind == RoadMesh::Kind::Town && random_.chance(one_way);
      }
      root[a] = b;
    }
    std::size_t at = 0;
    for (std::size_t s = 0; s < kept.size(); ++s)
      if (kept[s]) mesh_.streets[at++] = mesh_.streets[s];
    mesh_.streets.resize(at);
  }

  ltl::Random& random_;
  std::uint64_t seed_;
  std::vector<Town> towns_;  // the largest first
  std::vector<double> denser_;
  std::vector<Square> squares_;  // by curve
  std::vector<bool> main_;       // by street
  RoadMesh mesh_;
};

}  // namespace

RoadMesh draw_mesh(std::uint32_t junctions, ltl::Random& random) {
  return Mesh(std::max(junctions, 16U), random).draw();
}

}  // namespace waymark::plan
