// Pairs of a product in the order in which a search met them, each with its number: four bytes for every place and
// every state of the task that was met, eight for every pair that was.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "libplan/product/product.hpp"

namespace waymark::plan {

class DiscoveryOrder {
 public:
  DiscoveryOrder(std::size_t places, std::size_t tasks) : places_(places), rows_(tasks) {}

  std::pair<std::uint32_t, bool> insert(const ProductState& s) {  // its number; whether it is new
    std::vector<std::uint32_t>& row = rows_[s.task];
    if (row.empty()) row.resize(places_, none);
    if (row[s.place] != none) return {row[s.place], false};
    row[s.place] = static_cast<std::uint32_t>(states_.size());
    states_.push_back(s);
    return {row[s.place], true};
  }
  // Was the pair met?
  bool contains(const ProductState& s) const { return !rows_[s.task].empty() && number(s) != none; }
  std::uint32_t number(const ProductState& s) const { return rows_[s.task][s.place]; }  // none when it was not met
  // In the order in which they were met.
  const std::vector<ProductState>& states() const& { return states_; }
  std::vector<ProductState> states() && { return std::move(states_); }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  std::size_t places_;
  std::vector<std::vector<std::uint32_t>> rows_;  // by task, empty until one of its pairs is met; by place
  std::vector<ProductState> states_;
};

}  // namespace waymark::plan
