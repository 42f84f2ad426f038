#include "libplan/world/hallways.hpp"

#include <cassert>
#include <stdexcept>

namespace waymark::plan {
namespace {

std::string show(const Node& node) { return "(" + std::to_string(node.x) + "," + std::to_string(node.y) + ")"; }

// heading / 90 of the step from one node to its neighbour; nullopt when they are no orthogonal neighbours.
std::optional<std::size_t> quarter(const Node& from, const Node& to) {
  const int dx = to.x - from.x, dy = to.y - from.y;
  if (dx == 0 && dy == -1) return 0;
  if (dx == 1 && dy == 0) return 1;
  if (dx == 0 && dy == 1) return 2;
  if (dx == -1 && dy == 0) return 3;
  return std::nullopt;
}

}  // namespace

std::string show(const Pose& pose) {
  return "(" + std::to_string(pose.x) + "," + std::to_string(pose.y) + "," + std::to_string(pose.heading) + ")";
}

void Hallways::add_node(Node node) {
  if (node.x < -max_coordinate || node.x > max_coordinate || node.y < -max_coordinate || node.y > max_coordinate)
    throw std::invalid_argument("coordinates run from " + std::to_string(-max_coordinate) + " to " +
                                std::to_string(max_coordinate));
  if (node.place && (*node.place < 1 || *node.place > max_place))
    throw std::invalid_argument("places are numbered 1 to " + std::to_string(max_place));
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  if (!index_.try_emplace({node.x, node.y}, index).second)
    throw std::invalid_argument("there is already a node at " + show(node));
  nodes_.push_back(std::move(node));
  ways_.push_back({-1, -1, -1, -1});
}

void Hallways::add_edge(Edge edge) {
  if (edge.a >= nodes_.size() || edge.b >= nodes_.size())
    throw std::invalid_argument("an edge names a node that is not there");
  const Node& a = nodes_[edge.a];
  const Node& b = nodes_[edge.b];
  const std::string ends = show(a) + " and " + show(b);
  const auto there = quarter(a, b), back = quarter(b, a);
  if (!there) throw std::invalid_argument(ends + " are not orthogonal neighbours at distance 1");
  if (ways_[edge.a][*there] >= 0) throw std::invalid_argument(ends + " are already joined by an edge");
  const auto index = static_cast<std::int32_t>(edges_.size());
  ways_[edge.a][*there] = index;
  ways_[edge.b][*back] = index;
  edges_.push_back(std::move(edge));
}

std::optional<std::uint32_t> Hallways::node_at(int x, int y) const {
  const auto it = index_.find({x, y});
  if (it == index_.end()) return std::nullopt;
  return it->second;
}

const Edge* Hallways::hallway(std::uint32_t node, int heading) const {
  assert(heading % 90 == 0 && heading >= 0 && heading < 360);
  const std::int32_t edge = ways_[node][static_cast<std::size_t>(heading) / 90];
  return edge < 0 ? nullptr : &edges_[static_cast<std::size_t>(edge)];
}

std::optional<std::uint32_t> Hallways::neighbour(std::uint32_t node, int heading) const {
  const Edge* edge = hallway(node, heading);
  if (edge == nullptr) return std::nullopt;
  return edge->a == node ? edge->b : edge->a;
}

}  // namespace waymark::plan
