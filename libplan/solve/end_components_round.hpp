// One round of the search for end components: the strongly connected components of choices that stay.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "libplan/solve/reachability.hpp"

namespace waymark::plan {

struct EndComponents {                               // disjoint sets of states
  static constexpr std::uint32_t none = UINT32_MAX;  // in no end component
  std::vector<std::uint32_t> of;                     // by state
  std::uint32_t count = 0;                           // how many
};

// Does the choice stay in the component of its state, whatever comes of it?
template <class Product>
bool stays(const Product& product, const typename Product::State& s, std::uint32_t k, const EndComponents& components) {
  bool all = components.of[s.index] != EndComponents::none;
  product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) {
    all = all && t != Product::trap && components.of[t] == components.of[s.index];
  });
  return all;
}

// One round: the strongly connected components of the choices that stay [Tar72], open calls on a stack.
template <class Product, class Usable>
class EndComponentsRound {
 public:
  EndComponentsRound(const Product& product, const EndComponents& last, const Usable& usable)
      : product_(product), last_(last), usable_(usable), low_(product.states(), unseen) {
    next_.of.assign(product.states(), EndComponents::none);
  }

  EndComponents run() {  // of all states
    for (std::uint32_t i = 0; i < product_.states(); ++i)
      if (last_.of[i] != EndComponents::none && low_[i] == unseen) search(i);
    return std::move(next_);
  }

 private:
  static constexpr std::uint32_t unseen = UINT32_MAX, closed = UINT32_MAX - 1;
  struct Call {
    std::uint32_t state, number;
    std::size_t first;  // its successors are those of pending_ from here on
    bool moves;         // has a choice that stays
  };

  void enter(std::uint32_t i) {
    const auto s = product_.state(i);
    calls_.push_back({i, visited_, pending_.size(), false});
    low_[i] = visited_++;
    open_.push_back(i);
    const std::uint32_t choices = product_.choices(s);
    if (choices > 1 && all_stay(s, choices)) {  // most states are like this, and choices share targets
      calls_.back().moves = true;
      for_each_target(product_, s, [&](std::uint32_t t) { pending_.push_back(t); });
      return;
    }
    for (std::uint32_t k = 0; k < choices; ++k) {
      if (!usable_(s, k) || !stays(product_, s, k, last_)) continue;
      calls_.back().moves = true;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) { pending_.push_back(t); });
    }
  }

  bool all_stay(const auto& s, std::uint32_t choices) const {
    bool all = true;
    for_each_target(product_, s,
                    [&](std::uint32_t t) { all = all && t != Product::trap && last_.of[t] == last_.of[s.index]; });
    for (std::uint32_t k = 0; k < choices && all; ++k) all = usable_(s, k);
    return all;
  }

  void search(std::uint32_t root) {
    enter(root);
    while (!calls_.empty()) {
      Call& call = calls_.back();
      if (pending_.size() > call.first) {
        const std::uint32_t t = pending_.back();
        pending_.pop_back();
        if (low_[t] == unseen)
          enter(t);
        else if (low_[t] != closed)
          low_[call.state] = std::min(low_[call.state], low_[t]);
        continue;
      }
      leave();
    }
  }

  void leave() {
    const Call call = calls_.back();
    calls_.pop_back();
    const std::uint32_t low = low_[call.state];
    if (low < call.number) {
      low_[calls_.back().state] = std::min(low_[calls_.back().state], low);
      return;
    }
    const bool kept = call.moves;  // else one state without a choice that stays
    for (std::uint32_t i = EndComponents::none; i != call.state;) {
      i = open_.back();
      open_.pop_back();
      low_[i] = closed;
      if (kept) next_.of[i] = next_.count;
    }
    if (kept) ++next_.count;
  }

  const Product& product_;
  const EndComponents& last_;
  const Usable& usable_;
  EndComponents next_;
  std::vector<std::uint32_t> low_, open_, pending_;
  std::vector<Call> calls_;
  std::uint32_t visited_ = 0;
};

}  // namespace waymark::plan
