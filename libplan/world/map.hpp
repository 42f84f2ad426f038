// The map 𝓜 = (S, A, T, P, L): poses, the three actions, and a labelling function with letters on moves.
//
// S are poses (x, y, heading): nodes of a hallway map times the four headings; A = FORWARD, LEFT, RIGHT. The first
// letter of a word is L(start). Each action appends L(pose after the action) with the event propositions of the action
// (`moved`, `turned_left`, `turned_right`): docs/conventions.md 1. world/labelling.hpp defines the observables,
// world/hallways.hpp the geometry.
//
// Equal letters are stored once. A letter has a small id, so automata and feature extractors can tabulate by LetterId.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"
#include "libplan/world/hallways.hpp"
#include "libplan/world/labelling.hpp"
#include "libplan/world/letters.hpp"

namespace waymark::plan {

enum class Action : std::uint8_t { Forward, Left, Right };                                         // what one can do
inline constexpr std::array<Action, 3> all_actions{Action::Forward, Action::Left, Action::Right};  // the tie order
std::string_view name(Action action);  // "FORWARD", "LEFT", "RIGHT"

struct PoseId {             // of one map
  std::uint32_t index = 0;  // 4 · node + heading / 90
  friend auto operator<=>(const PoseId&, const PoseId&) = default;
};

class Map {
 public:
  static constexpr std::size_t max_size = std::size_t{1} << 24U;  // nodes · propositions: the letters fit in memory

  // Throws std::invalid_argument on a map without nodes, on one beyond max_size, and as world/hallways.hpp and
  // world/labelling.hpp say. places: the highest place number of the nodes.
  Map(std::string name, Hallways hallways, std::vector<std::string> objects, std::vector<std::string> floors,
      std::vector<std::string> walls);
  Map(std::string name, const std::vector<Node>& nodes, const std::vector<Edge>& edges,
      std::vector<std::string> objects, std::vector<std::string> floors, std::vector<std::string> walls);

  // As the file has them.
  const std::string& name() const { return name_; }
  const Hallways& hallways() const { return hallways_; }
  const std::vector<Node>& nodes() const { return hallways_.nodes(); }
  const std::vector<Edge>& edges() const { return hallways_.edges(); }
  // The names of what can be observed, and the greatest place number.
  const std::vector<std::string>& objects() const { return observables_.objects; }
  const std::vector<std::string>& floors() const { return observables_.floors; }
  const std::vector<std::string>& walls() const { return observables_.walls; }
  int places() const { return observables_.places; }

  const ltl::Vocabulary& vocabulary() const { return letters_.vocabulary(); }  // the propositions of the map
  std::size_t poses() const { return 4 * nodes().size(); }                     // four for each node
  Pose pose(PoseId p) const;                                                   // of a number
  std::optional<PoseId> find(const Pose& pose) const;                          // nothing when there is no such place
  std::uint32_t node_of(PoseId p) const { return p.index / 4; }                // where the pose is
  std::optional<std::uint32_t> neighbour(std::uint32_t node, int heading) const {  // along a hallway
    return hallways_.neighbour(node, heading);
  }
  // Null where there is a wall.
  const Edge* hallway(std::uint32_t node, int heading) const { return hallways_.hallway(node, heading); }

  std::optional<PoseId> successor(PoseId p, Action action) const {  // nullopt: FORWARD into a wall
    const std::uint32_t to = successors_[p.index][static_cast<std::size_t>(action)];
    return to == wall_ahead ? std::nullopt : std::optional(PoseId{to});
  }
  // The one pose from which the action leads to p, if there is one: actions are injective. O(1).
  std::optional<PoseId> predecessor(PoseId p, Action action) const;
  double cost(Action) const { return 1.0; }  // conventions.md 4

  const ltl::Letter& label(PoseId p) const { return letter(label_id(p)); }  // L(p), without events
  const ltl::Letter& letter(PoseId after, Action by) const { return letter(letter_id(after, by)); }  // with events
  LetterId label_id(PoseId p) const { return letter_ids_[p.index][3]; }  // of L(p), without an event
  // Of L(after) with the event of the action.
  LetterId letter_id(PoseId after, Action by) const { return letter_ids_[after.index][static_cast<std::size_t>(by)]; }
  const ltl::Letter& letter(LetterId id) const { return letters_[id]; }
  const Letters& letters() const { return letters_; }  // the distinct letters

 private:
  static constexpr std::uint32_t wall_ahead = UINT32_MAX;
  void tabulate_letters();
  void tabulate_successors();

  std::string name_;
  Hallways hallways_;
  Observables observables_;
  Letters letters_;
  std::vector<std::array<LetterId, 4>> letter_ids_;       // by pose: after each action, then L(pose) itself
  std::vector<std::array<std::uint32_t, 3>> successors_;  // by pose and action
};

}  // namespace waymark::plan
