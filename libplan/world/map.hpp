// The map 𝓜 = (S, A, T, P, L): poses, the three actions, and a labelling function with letters on moves.
//
// S are poses (x, y, heading): nodes of a hallway map times the four headings; A = FORWARD, LEFT, RIGHT.
// y grows downwards (south); headings in degrees clockwise: 0 is y − 1, 90 is x + 1, 180 is y + 1, 270 is x − 1.
// The first letter of a word is L(start); each action appends L(pose after it) together with the event propositions
// of the action (`moved`, `turned_left`, `turned_right`): docs/conventions.md 1.
// What the observables are called and mean: world/labelling.hpp.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"

namespace waymark::plan {

enum class Action : std::uint8_t { Forward, Left, Right };
inline constexpr std::array<Action, 3> all_actions{Action::Forward, Action::Left, Action::Right};  // the tie order
std::string_view name(Action action);  // "FORWARD", "LEFT", "RIGHT"

struct Pose {
  int x = 0, y = 0, heading = 0;  // heading ∈ {0, 90, 180, 270}
  friend auto operator<=>(const Pose&, const Pose&) = default;
};

struct PoseId {
  std::uint32_t index = 0;  // 4 · node + heading / 90
  friend auto operator<=>(const PoseId&, const PoseId&) = default;
};

struct Node {
  int x = 0, y = 0;
  std::optional<std::string> object;  // furniture standing here
  std::optional<int> place;           // numbered position
};

struct Edge {                         // undirected, between orthogonal neighbours at distance 1
  std::uint32_t a = 0, b = 0;         // node indices
  std::string floor, wall;            // pattern of the floor, painting on the wall
};

class Map {
 public:
  // The parts of a hallway map. Throws std::invalid_argument on two nodes in one place, or an edge that does not
  // join orthogonal neighbours or leaves the map.
  Map(std::string name, std::vector<Node> nodes, std::vector<Edge> edges, std::vector<std::string> objects,
      std::vector<std::string> floors, std::vector<std::string> walls);

  const std::string& name() const { return name_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<std::string>& objects() const { return objects_; }
  const std::vector<std::string>& floors() const { return floors_; }
  const std::vector<std::string>& walls() const { return walls_; }

  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }
  std::size_t poses() const { return 4 * nodes_.size(); }
  Pose pose(PoseId p) const;
  std::optional<PoseId> find(const Pose& pose) const;
  std::uint32_t node_of(PoseId p) const { return p.index / 4; }
  std::optional<std::uint32_t> neighbour(std::uint32_t node, int heading) const;  // along a hallway
  const Edge* hallway(std::uint32_t node, int heading) const;                      // nullptr: a wall

  std::optional<PoseId> successor(PoseId p, Action action) const;  // nullopt: FORWARD into a wall
  double cost(Action) const { return 1.0; }                        // conventions.md 4
  const ltl::Letter& label(PoseId p) const;                        // L(p), without events
  const ltl::Letter& letter(PoseId after, Action by) const;        // L(p) ∪ events: the letter that an action appends

 private:
  std::string name_;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::vector<std::string> objects_, floors_, walls_;
  ltl::Vocabulary vocabulary_;
  std::vector<std::array<std::int32_t, 4>> ways_;      // edge index by node and heading, −1: a wall
  std::vector<std::array<ltl::Letter, 4>> letters_;    // by pose: label, then the label after each action
};

}  // namespace waymark::plan
