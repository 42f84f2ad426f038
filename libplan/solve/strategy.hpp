// A strategy without memory, by state of a product: which choice is made.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace waymark::plan {

// A choice for every state, or none. One byte a state while choices are few, four from the first that is not.
class Choices {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;  // no choice
  Choices() = default;
  explicit Choices(std::size_t states) : narrow_(states, no_byte) {}

  std::size_t size() const { return wide_.empty() ? narrow_.size() : wide_.size(); }
  std::uint32_t operator[](std::size_t state) const {
    if (!wide_.empty()) return wide_[state];
    return narrow_[state] == no_byte ? none : narrow_[state];
  }
  void set(std::size_t state, std::uint32_t choice) {  // of one state
    if (wide_.empty() && choice >= no_byte && choice != none) widen();
    if (wide_.empty())
      narrow_[state] = choice == none ? no_byte : static_cast<std::uint8_t>(choice);
    else
      wide_[state] = choice;
  }

 private:
  static constexpr std::uint8_t no_byte = UINT8_MAX;
  void widen() {
    std::vector<std::uint32_t> wide(narrow_.size());
    for (std::size_t i = 0; i < wide.size(); ++i) wide[i] = (*this)[i];
    wide_.swap(wide);
    std::vector<std::uint8_t>().swap(narrow_);
  }
  std::vector<std::uint8_t> narrow_;
  std::vector<std::uint32_t> wide_;  // in the place of the other, once it is not empty
};

struct Strategy {
  static constexpr std::uint32_t none = Choices::none;  // a goal, or a state that the strategy never meets
  Choices choice;                                       // by state
  std::uint32_t start = 0;                              // in which of the product's starts it begins
};

}  // namespace waymark::plan
