// Which pairs can reach a target, and which can do so almost surely: the graph questions before value iteration, by
// searches that every rank makes in its band, and that go on in the bands of the neighbours where a border row changed.
//
// No end components are computed. Almost surely winning, for goals as for edges that are to be met for ever, is
//   νX μY. goal ∨ ∃ choice: all outcomes in X, and one of them marked or in Y      [BK08, Sec. 10.6]
// and from what can reach it the greatest probability is that of reaching it. A search over all pairs is a fixpoint of
// monotone updates, so the order of updates, and with it the number of ranks, is of no influence on the sets.
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "libplan/solve/optimistic_iteration.hpp"
#include "tools/distributed/band_product.hpp"
#include "tools/distributed/halo.hpp"

namespace waymark::tools {

enum class SharedMeasure : std::uint8_t { MaxProbability, MinCost, Discounted };  // what is asked

class BandSets {
 public:
  // Collective, as all that is not const. Product and halo (of all its planes) must outlive the object.
  BandSets(const Ranks& ranks, const BandProduct& product, const Halo& halo);

  void reach();                       // from the start
  void solve(SharedMeasure measure);  // after reach(): targets and unknowns

  // Of a pair, an own one or one of the halo. A target's value is 1, or cost 0; what is neither a target nor unknown
  // has value 0, or no finite cost.
  bool is_reached(std::uint32_t pair) const { return has(pair, Reached); }
  bool is_target(std::uint32_t pair) const { return has(pair, Target); }
  bool is_unknown(std::uint32_t pair) const { return has(pair, Unknown); }
  // The own unknown pairs whose automaton state is one of these, next to what is known first.
  std::vector<std::uint32_t> unknowns(std::uint32_t first_state, std::uint32_t last_state) const;
  const std::vector<std::uint32_t>& starts() const { return starts_; }  // own pairs: where a run may begin
  // Of all ranks: reached pairs; outcomes of their choices, those into the trap left out.
  std::uint64_t pairs() const { return pairs_; }
  std::uint64_t edges() const { return edges_; }

 private:
  enum Flag : std::uint8_t { Reached = 1, Inside = 2, Joined = 4, Target = 8, Unknown = 16 };
  bool has(std::uint32_t pair, std::uint8_t flag) const { return (flags_[pair] & flag) != 0; }
  void set(std::uint32_t pair, std::uint8_t flag) { flags_[pair] = static_cast<std::uint8_t>(flags_[pair] | flag); }
  void clear(std::uint32_t pair, std::uint8_t flag) { flags_[pair] = static_cast<std::uint8_t>(flags_[pair] & ~flag); }
  bool is_open(std::uint32_t pair) const { return has(pair, Reached) && !product_->is_goal(pair); }
  std::uint32_t directions_into(const BandProduct::Around& around, std::uint8_t flag) const;
  std::uint32_t directions_to_trap(const BandProduct::Around& around) const;

  void count();
  void replace(std::uint8_t from, std::uint8_t to);
  bool differ(std::uint8_t a, std::uint8_t b) const;
  bool stays_inside(std::uint32_t pair) const;
  bool joins_surely(std::uint32_t pair, bool by_mark) const;
  bool joins_by_chance(std::uint32_t pair) const;
  void keep_inside();
  template <class Seed, class Joins>
  void join(const Seed& is_seed, const Joins& joins);
  template <class Look>
  void settle(std::deque<std::uint32_t> open, const Look& look);
  void almost_surely();

  const Ranks* ranks_;
  const BandProduct* product_;
  const Halo* halo_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint8_t> seen_;     // of the halo, when its predecessors were last looked at
  std::vector<std::uint32_t> joined_;  // own pairs in the order in which the last search joined them
  std::vector<std::uint32_t> starts_;
  std::uint64_t pairs_ = 0, edges_ = 0;
};

}  // namespace waymark::tools
