// A memo of results by the shape of formulas, for batches that repeat patterns under other names. The memo is safe for
// any number of threads.
#pragma once
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

#include "libltl/structure/shape.hpp"

namespace waymark::ltl {

// Keeps what it has: past `most` results nothing more is kept.
template <class Result>
class ShapeMemo {
 public:
  explicit ShapeMemo(std::size_t most) : most_(most) {}

  struct Entry {                           // what is known of a shape
    std::shared_ptr<const Result> result;  // of compute(f); never null
    bool known = false;                    // computed for another formula: over that one's names
  };
  // compute(f), unless it is known for f's shape. worth_keeping(result): whether it is what any other formula of that
  // shape would get, and small enough. Two threads may compute the same at the same time.
  template <class Compute, class Worth>
  Entry operator()(Formula f, const Compute& compute, const Worth& worth_keeping) {
    std::string key = shape(f);
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = known_.find(key); known != known_.end()) return {known->second, true};
    }
    auto made = std::make_shared<const Result>(compute(f));
    if (worth_keeping(*made)) {
      const std::lock_guard lock(mutex_);
      if (known_.size() < most_) known_.try_emplace(std::move(key), made);
    }
    return {std::move(made), false};
  }

 private:
  std::size_t most_;
  std::mutex mutex_;
  std::unordered_map<std::string, std::shared_ptr<const Result>> known_;
};

}  // namespace waymark::ltl
