#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry of Debian 12 includes one of its own
#include "libplan/model/formats/road_network.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libplan/world/street_map.hpp"

namespace waymark::plan {
namespace {

namespace bg = boost::geometry;
using Plane = bg::model::d2::point_xy<double>;
using Space = bg::model::point<double, 3, bg::cs::cartesian>;  // on the unit sphere: distances order as on the ground

constexpr double earth_radius =
    6'371'008.8;  // metres, the mean radius of WGS 84 [Moritz, Geodetic Reference System 1980]
constexpr std::size_t most_points = 10'000'000;

Space on_sphere(const GlobePoint& p) {
  const double lambda = p.longitude * std::numbers::pi / 180, phi = p.latitude * std::numbers::pi / 180;
  return {std::cos(phi) * std::cos(lambda), std::cos(phi) * std::sin(lambda), std::sin(phi)};
}

double metres(const GlobePoint& a, const GlobePoint& b) {
  return 2 * earth_radius * std::asin(std::min(1.0, bg::distance(on_sphere(a), on_sphere(b)) / 2));
}

template <class Point, class Project>
auto tree_of(const std::vector<GlobePoint>& points, Project project) {
  std::vector<std::pair<Point, std::uint32_t>> entries;
  entries.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) entries.emplace_back(project(points[i]), i);
  return bg::index::rtree<std::pair<Point, std::uint32_t>, bg::index::rstar<16>>(entries);
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

Mdp model_of(const RoadNetwork& network, std::string_view source, std::string_view start) {
  if (network.nodes.empty()) throw ltl::FormatError(source, 0, 0, "expected a node at least");
  ltl::Vocabulary vocabulary;
  for (const RoadNetwork::Node& node : network.nodes)
    for (const std::string& name : node.landmarks) vocabulary.add(name);
  if (vocabulary.size() == 0)
    throw ltl::FormatError(source, 0, 0, "there is no landmark: nothing has a name that a formula could use");
  MdpBuilder builder{vocabulary};
  std::vector<LetterId> letters;
  for (const RoadNetwork::Node& node : network.nodes) {
    ltl::Letter letter;
    for (const std::string& name : node.landmarks) letter.insert(*vocabulary.find(name));
    letters.push_back(builder.letter(letter));
  }
  for (const RoadNetwork::Node& node : network.nodes) {
    builder.add_state(node.name);
    for (const RoadNetwork::Road& road : node.roads) {
      builder.add_choice(network.nodes[road.to].name, road.cost);
      builder.add_outcome(road.to, letters[road.to]);
    }
  }
  const auto first = std::find_if(network.nodes.begin(), network.nodes.end(), [&](const RoadNetwork::Node& node) {
    if (start.empty()) return !node.landmarks.empty();
    return node.name == start || std::find(node.landmarks.begin(), node.landmarks.end(), start) != node.landmarks.end();
  });
  if (first == network.nodes.end()) {
    std::string message = "there is no node or landmark '" + std::string(start) + "'";
    if (const auto meant = vocabulary.nearest(start)) message += " (did you mean '" + *meant + "'?)";
    throw ltl::FormatError(source, 0, 0, message);
  }
  const auto s = static_cast<std::uint32_t>(first - network.nodes.begin());
  return std::move(builder).build(s, letters[s]);
}

std::uint32_t GlobeRoads::add_point(const GlobePoint& at, const std::string& name) {
  const auto [found, fresh] = numbers_.try_emplace(name, static_cast<std::uint32_t>(points_.size()));
  if (fresh) {
    if (points_.size() == most_points)
      throw ltl::FormatError(source_, 0, 0, "expected at most 10,000,000 points of roads");
    points_.push_back(at);
    network_.nodes.push_back({name, {}, {}});
  }
  return found->second;
}

void GlobeRoads::add_road(std::uint32_t a, std::uint32_t b, Direction direction) {
  if (a == b) return;
  const double length = metres(points_[a], points_[b]);
  if (direction != Direction::Backward) network_.nodes[a].roads.push_back({b, length});
  if (direction != Direction::Forward) network_.nodes[b].roads.push_back({a, length});
}

void GlobeRoads::add_landmark(const GlobePoint& at, std::string_view name) {
  if (std::string proposition = landmark_name(name); !proposition.empty())
    landmarks_.push_back({at, std::move(proposition)});
}

void GlobeRoads::add_area(const std::vector<Ring>& rings, std::string_view name) {
  if (std::string proposition = landmark_name(name); !proposition.empty() && !rings.empty())
    areas_.push_back({rings, std::move(proposition)});
}

RoadNetwork GlobeRoads::build() && {
  if (points_.empty()) throw ltl::FormatError(source_, 0, 0, "there is no road");
  place_landmarks();
  place_areas();
  return std::move(network_);
}

void GlobeRoads::place_landmarks() {
  if (landmarks_.empty()) return;
  const auto tree = tree_of<Space>(points_, on_sphere);
  std::vector<std::pair<Space, std::uint32_t>> found;
  for (const Landmark& landmark : landmarks_) {
    found.clear();
    tree.query(bg::index::nearest(on_sphere(landmark.at), 1), std::back_inserter(found));
    add_once(network_.nodes[found.front().second].landmarks, landmark.name);
  }
}

void GlobeRoads::place_areas() {
  if (areas_.empty()) return;
  const auto on_plane = [](const GlobePoint& p) { return Plane(p.longitude, p.latitude); };
  const auto tree = tree_of<Plane>(points_, on_plane);
  std::vector<std::pair<Plane, std::uint32_t>> inside;
  for (const Area& area : areas_) {
    bg::model::polygon<Plane> polygon;
    polygon.inners().resize(area.rings.size() - 1);
    for (std::size_t r = 0; r < area.rings.size(); ++r)
      for (const GlobePoint& p : area.rings[r])
        (r == 0 ? polygon.outer() : polygon.inners()[r - 1]).push_back(on_plane(p));
    bg::correct(polygon);  // closed, and every ring in its direction
    inside.clear();
    tree.query(bg::index::covered_by(bg::return_envelope<bg::model::box<Plane>>(polygon)), std::back_inserter(inside));
    for (const auto& [point, node] : inside)
      if (bg::covered_by(point, polygon)) add_once(network_.nodes[node].landmarks, area.name);
  }
}

}  // namespace waymark::plan
