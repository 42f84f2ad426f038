// Masks of a network's symbols, lent to one thread at a time, so that none is made twice by the same thread.
#pragma once
#include <mutex>
#include <utility>
#include <vector>

#include "libparser/model/network_scorer.hpp"

namespace waymark::parser {

class MaskPool {
 public:
  explicit MaskPool(const TypedPostfix& symbols) : symbols_(&symbols) {}

  // use(ChoiceMasks&), from several threads at once.
  template <class Use>
  auto lend(const Use& use) {
    ChoiceMasks masks = take();
    auto result = use(masks);
    if (masks.size() <= most_masks) {
      const std::lock_guard lock(mutex_);
      idle_.push_back(std::move(masks));
    }
    return result;
  }

 private:
  static constexpr std::size_t most_masks = 20'000;  // kept by each; some 500 bytes a mask

  ChoiceMasks take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return ChoiceMasks(*symbols_);
    ChoiceMasks last = std::move(idle_.back());
    idle_.pop_back();
    return last;
  }

  const TypedPostfix* symbols_;
  std::mutex mutex_;
  std::vector<ChoiceMasks> idle_;
};

}  // namespace waymark::parser
