// Bounds of values, by state: of all states, or of those alone that somebody will ask for again.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <vector>

#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/reachability.hpp"

namespace waymark::plan {

// Sixteen bytes a state that is kept, and two bits a state there is, unless all are.
class KeptBounds {
 public:
  KeptBounds() = default;
  explicit KeptBounds(std::uint32_t states) : lower_(states, 0), upper_(states, 0) {}  // of all
  explicit KeptBounds(const StateSet& kept) : kept_(kept.size()) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (!kept[i]) continue;
      kept_->insert(i);
      ++count;
    }
    kept_->rank();
    lower_.assign(count, 0);
    upper_.assign(count, 0);
  }

  // Are bounds of the state remembered?
  bool keeps(std::uint32_t state) const { return !kept_ || kept_->contains(state); }
  double lower(std::uint32_t state) const { return lower_[place(state)]; }  // of states that are kept
  double upper(std::uint32_t state) const { return upper_[place(state)]; }  // of states that are kept
  void set(std::uint32_t state, double lower, double upper) {               // of others nothing is remembered
    if (!keeps(state)) return;
    lower_[place(state)] = lower;
    upper_[place(state)] = upper;
  }

 private:
  std::uint32_t place(std::uint32_t state) const { return kept_ ? kept_->rank(state) : state; }
  std::optional<RankedSet> kept_;
  std::vector<double> lower_, upper_;
};

struct Values {                       // the answer
  KeptBounds bounds;                  // of targets 1 (probability) or 0 (cost)
  std::pmr::vector<double> attained;  // by state: the bound that a choice attains, the lower one of probabilities
  std::uint64_t sweeps = 0;           // over all blocks
};

// What is remembered of states whose block has been solved.
struct Keep {
  const StateSet* bounds = nullptr;  // of these states, which include those that other blocks lead into; none: of all
  bool attained = false;             // also the attained values
};

// The unknown states that outcomes lead into from a block above theirs, and the starts: whose values are asked for
// after their block has been solved.
template <class Product>
StateSet entries(const Product& product, const StateSet& unknown, const std::vector<std::uint32_t>& starts,
                 std::size_t threads = 1) {
  StateSet out(product.states());
  for (std::uint32_t i : starts) out.insert(i);
  const std::vector<std::uint32_t>& blocks = product.blocks();
  for_each_state(product, threads, [&](const auto& s) {
    if (!unknown[s.index]) return;
    for_each_target(product, s, [&](std::uint32_t t) {
      if (t >= s.index || out[t]) return;
      const std::uint32_t block = *(std::upper_bound(blocks.begin(), blocks.end(), s.index) - 1);
      if (t < block) out.join(t);
    });
  });
  return out;
}

}  // namespace waymark::plan
