#include "libplan/motion/clearance.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <set>
#include <stdexcept>

#include "libltl/rewriting/nnf.hpp"

namespace waymark::plan {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint>;

// Holes of the result are filled: what a region encloses within the reach is no way for the body.
Polygon grown(const Polygon& polygon, double distance) {
  BoostPolygon from;
  for (const Point& p : polygon) bg::append(from.outer(), BoostPoint(p.x, p.y));
  bg::correct(from);
  constexpr double rounding = 1e-6;  // relative: the result must not fall short
  bg::model::multi_polygon<BoostPolygon> to;
  bg::buffer(from, to, bg::strategy::buffer::distance_symmetric<double>(distance * (1 + rounding)),
             bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_miter(),
             bg::strategy::buffer::end_flat(), bg::strategy::buffer::point_square());
  if (to.size() != 1) throw std::logic_error("a polygon was widened to " + std::to_string(to.size()) + " polygons");
  Polygon out;
  for (const BoostPoint& p : to.front().outer()) out.push_back({p.x(), p.y()});
  out.pop_back();  // Boost repeats the first corner
  return out;
}

void add_literals(ltl::Formula f, std::set<ltl::Proposition>& wanted, std::set<ltl::Proposition>& avoided) {
  for (const ltl::Formula g : ltl::subformulas(f)) {
    if (g.op() == ltl::Op::Not) avoided.insert(g[0].proposition());
    for (const ltl::Formula operand : g.operands())
      if (operand.op() == ltl::Op::Atom && g.op() != ltl::Op::Not) wanted.insert(operand.proposition());
  }
  if (f.op() == ltl::Op::Atom) wanted.insert(f.proposition());
}

}  // namespace

double reach(const Robot& robot) {
  const auto* disc = std::get_if<Disc>(&robot);
  return disc != nullptr ? disc->radius : reach(std::get<Car>(robot));
}

std::vector<ltl::Proposition> avoided(ltl::Formula f) {
  std::set<ltl::Proposition> wanted, unwanted;
  add_literals(ltl::nnf(f), wanted, unwanted);
  for (const ltl::Proposition p : unwanted)
    if (wanted.contains(p))
      throw std::invalid_argument("'" + f.arena().vocabulary().name(p) +
                                  "' is to be avoided and to be reached: its clearance has no meaning");
  return {unwanted.begin(), unwanted.end()};
}

Terrain widened(const Terrain& terrain, const std::vector<std::string>& names, double distance) {
  std::vector<NamedRegion> regions = terrain.regions();
  if (distance > 0)
    for (NamedRegion& region : regions)
      if (std::find(names.begin(), names.end(), region.name) != names.end())
        region.border = grown(region.border, distance);
  return {terrain.name(), terrain.border(), terrain.obstacles(), std::move(regions)};
}

}  // namespace waymark::plan
