#include "libplan/motion/cells.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::plan {
namespace {

constexpr double least = 1e-9;  // width of a slab, length of a passage: less is rounding

double height_at(const Terrain::Edge& edge, double x) {
  return edge.a.y + (edge.b.y - edge.a.y) * (x - edge.a.x) / (edge.b.x - edge.a.x);
}

std::vector<Terrain::Edge> edges_of(const Terrain& terrain) {
  std::vector<Terrain::Edge> edges = terrain.walls();
  edges.insert(edges.end(), terrain.region_edges().begin(), terrain.region_edges().end());
  return edges;
}

// Of every corner and every crossing, ascending.
std::vector<double> cuts_of(const std::vector<Terrain::Edge>& edges) {
  std::vector<double> cuts;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [a, b] = edges[i];
    cuts.push_back(a.x);
    for (std::size_t j = 0; j < i; ++j) {
      const auto [c, d] = edges[j];
      const bool parallel = (b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x);
      if (!parallel && distance(a, b, c, d) == 0) cuts.push_back(meeting(a, b, c, d).x);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b - a < least; }), cuts.end());
  return cuts;
}

}  // namespace

TerrainCells::TerrainCells(const Terrain& terrain) {
  const std::vector<Terrain::Edge> edges = edges_of(terrain);
  const std::vector<double> cuts = cuts_of(edges);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    add_slab(terrain, edges, cuts[i], cuts[i + 1]);
    if (i > 0) join_slabs(slabs_[i - 1], slabs_[i]);
  }
}

void TerrainCells::add_slab(const Terrain& terrain, const std::vector<Terrain::Edge>& edges, double left,
                            double right) {
  const double middle = (left + right) / 2;
  std::vector<Terrain::Edge> across;
  for (const Terrain::Edge& edge : edges)
    if (std::min(edge.a.x, edge.b.x) < middle && std::max(edge.a.x, edge.b.x) > middle) across.push_back(edge);
  std::sort(across.begin(), across.end(), [&](const Terrain::Edge& a, const Terrain::Edge& b) {
    return height_at(a, middle) < height_at(b, middle);
  });
  const auto first = static_cast<std::uint32_t>(cells_.size());
  bool above_is_free = false;
  for (std::size_t i = 0; i + 1 < across.size(); ++i) {
    const Terrain::Edge &top = across[i], &bottom = across[i + 1];
    if (height_at(bottom, middle) - height_at(top, middle) < least) continue;  // the same border twice
    const Point inside{middle, (height_at(top, middle) + height_at(bottom, middle)) / 2};
    const bool is_free = terrain.contains(inside);
    const Point top_left{left, height_at(top, left)}, top_right{right, height_at(top, right)};
    if (is_free)
      add_cell(terrain,
               {top_left, top_right, Point{right, height_at(bottom, right)}, Point{left, height_at(bottom, left)}});
    const auto here = static_cast<std::uint32_t>(cells_.size() - 1);
    if (is_free && above_is_free) join(here - 1, here, top_left, top_right);
    above_is_free = is_free;
  }
  slabs_.push_back({left, right, first, static_cast<std::uint32_t>(cells_.size())});
}

void TerrainCells::add_cell(const Terrain& terrain, const std::array<Point, 4>& corners) {
  TerrainCell cell;
  cell.corners = corners;
  for (const Point& p : corners) cell.centre = {cell.centre.x + p.x / 4, cell.centre.y + p.y / 4};
  cell.area = std::abs(signed_area(Polygon(corners.begin(), corners.end())));
  const ltl::Letter letter = terrain.label(cell.centre);
  const auto known = std::find(letters_.begin(), letters_.end(), letter);
  cell.letter = static_cast<std::uint32_t>(known - letters_.begin());
  if (known == letters_.end()) letters_.push_back(letter);
  cells_.push_back(std::move(cell));
}

void TerrainCells::join(std::uint32_t a, std::uint32_t b, Point from, Point to) {
  cells_[a].passages.push_back({b, from, to});
  cells_[b].passages.push_back({a, from, to});
}

void TerrainCells::join_slabs(const Slab& left, const Slab& right) {
  for (std::uint32_t a = left.first; a < left.last; ++a)
    for (std::uint32_t b = right.first; b < right.last; ++b) {
      const double top = std::max(cells_[a].corners[1].y, cells_[b].corners[0].y);
      const double bottom = std::min(cells_[a].corners[2].y, cells_[b].corners[3].y);
      if (bottom - top > least) join(a, b, {left.right, top}, {left.right, bottom});
    }
}

std::optional<std::uint32_t> TerrainCells::at(Point p) const {
  for (const Slab& slab : slabs_) {
    if (p.x < slab.left || p.x > slab.right) continue;
    const double share = (p.x - slab.left) / (slab.right - slab.left);
    for (std::uint32_t cell = slab.first; cell < slab.last; ++cell) {
      const auto& [top_left, top_right, bottom_right, bottom_left] = cells_[cell].corners;
      const double top = top_left.y + share * (top_right.y - top_left.y);
      const double bottom = bottom_left.y + share * (bottom_right.y - bottom_left.y);
      if (p.y >= top && p.y <= bottom) return cell;
    }
  }
  return std::nullopt;
}

}  // namespace waymark::plan
