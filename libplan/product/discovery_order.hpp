// Pairs of a product in the order in which a search met them, each with its number.
#pragma once
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libplan/product/product.hpp"

namespace waymark::plan {

class DiscoveryOrder {
 public:
  std::pair<std::uint32_t, bool> insert(const ProductState& s) {  // its number; whether it is new
    const auto [at, fresh] = number_.try_emplace(key(s), static_cast<std::uint32_t>(states_.size()));
    if (fresh) states_.push_back(s);
    return {at->second, fresh};
  }
  bool contains(const ProductState& s) const { return number_.contains(key(s)); }
  std::uint32_t number(const ProductState& s) const { return number_.at(key(s)); }
  const std::vector<ProductState>& states() const& { return states_; }
  std::vector<ProductState> states() && { return std::move(states_); }

 private:
  static std::uint64_t key(const ProductState& s) { return std::uint64_t{s.task} << 32U | s.place; }
  std::vector<ProductState> states_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
};

}  // namespace waymark::plan
