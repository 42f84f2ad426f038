// Hallway maps as Markov decision processes: as they are (MapMdp), or written out, with chances to slip (mdp_of).
//
// State p is the pose with that PoseId, choices are the actions that are possible there in the order FORWARD, LEFT,
// RIGHT, letters are the map's with the events of the action.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

class MapMdp {  // every action does what is meant; a view, the map must outlive it
 public:
  explicit MapMdp(const Map& map, PoseId start = {}) : map_(&map), start_(start) {}

  // What the concept of a model (model.hpp) asks, and the map and the move of a choice.
  const Map& map() const { return *map_; }
  std::size_t states() const { return map_->poses(); }
  std::uint32_t initial() const { return start_.index; }
  LetterId initial_letter() const { return map_->label_id(start_); }
  const Letters& letters() const { return map_->letters(); }
  static bool is_deterministic() { return true; }
  std::uint32_t choices(std::uint32_t s) const {
    return map_->successor(PoseId{s}, Action::Forward) ? 3U : 2U;  // turns are always possible
  }
  Action move(std::uint32_t s, std::uint32_t k) const { return all_actions[k + 3 - choices(s)]; }
  std::string_view action(std::uint32_t s, std::uint32_t k) const { return plan::name(move(s, k)); }
  double cost(std::uint32_t s, std::uint32_t k) const { return map_->cost(move(s, k)); }
  static std::uint32_t outcome_count(std::uint32_t, std::uint32_t) { return 1; }
  ModelOutcome outcome(std::uint32_t s, std::uint32_t k, std::uint32_t) const {
    const Action by = move(s, k);
    const PoseId to = *map_->successor(PoseId{s}, by);
    return {to.index, map_->letter_id(to, by), 1};
  }
  template <class Visit>
  void for_each_outcome(std::uint32_t s, std::uint32_t k, Visit&& visit) const {
    const ModelOutcome o = outcome(s, k, 0);
    visit(o.target, o.letter, o.probability);
  }
  template <class Visit>
  void for_each_predecessor(std::uint32_t s, Visit&& visit) const {
    for (const Action by : all_actions)
      if (const auto from = map_->predecessor(PoseId{s}, by)) visit(from->index);
  }
  std::string name(std::uint32_t s) const { return show(map_->pose(PoseId{s})); }

 private:
  const Map* map_;
  PoseId start_;
};
static_assert(Model<MapMdp>);

struct TurnChances {  // what a turn may do instead; the rest is as meant
  double stay = 0;    // comes to nothing
  double beyond = 0;  // goes on to the opposite heading
  friend bool operator==(const TurnChances&, const TurnChances&) = default;
};
struct MapNoise {                               // chances of both kinds of actions
  MapNoise(const SlipChances& of_forward = {},  // NOLINT(google-explicit-constructor): most noise is that alone
           const TurnChances& of_turns = {})
      : forward(of_forward), turn(of_turns) {}
  SlipChances forward;  // of FORWARD
  TurnChances turn;     // of LEFT and RIGHT
  friend bool operator==(const MapNoise&, const MapNoise&) = default;
};

// FORWARD slips into the hallway on the left, on the right or
// behind, heading kept, and stays where there is none. Whatever comes of an action, its event is read. Throws
// std::invalid_argument for chances of a turn that are negative or leave nothing for turning.
Mdp mdp_of(const Map& map, PoseId start, const MapNoise& noise = {});

}  // namespace waymark::plan
