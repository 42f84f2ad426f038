// The budget of a construction: steps, states, and the deadline or stop request of the caller. A construction counts
// its own steps, so one Budget may cover several constructions. Budget::Exceeded is thrown when the budget runs out and
// caught where another construction can be tried.
#pragma once
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <utility>

namespace waymark::automata {

class Budget {
 public:
  struct Exceeded {                                // thrown
    enum class Reason { Steps, States, Stopped };  // what ran out
    Reason reason;                                 // of this exception
  };

  Budget() = default;  // without limits
  Budget(std::size_t steps, std::size_t states, std::stop_token stop)
      : steps_left_(steps), states_left_(states), stop_(std::move(stop)) {}

  void step(std::size_t n = 1) {  // each a few tens of nanoseconds to a microsecond of work
    if (steps_left_ < n) throw Exceeded{Exceeded::Reason::Steps};
    const std::size_t before = steps_left_ / 4096;
    steps_left_ -= n;
    if (steps_left_ / 4096 != before) poll();
  }
  void state() {  // counts a state
    ++states_;
    if (states_left_-- == 0) throw Exceeded{Exceeded::Reason::States};
  }
  void poll() const {  // throws when a stop was requested
    if (stop_.stop_requested()) throw Exceeded{Exceeded::Reason::Stopped};
  }
  // As much as is left, but no more than so many steps; spending it does not count here.
  Budget at_most(std::size_t steps) const { return {steps < steps_left_ ? steps : steps_left_, states_left_, stop_}; }
  Budget of_stop() const { return {SIZE_MAX, SIZE_MAX, stop_}; }  // stopped when this one is, else without limits
  std::size_t steps_left() const { return steps_left_; }
  std::size_t states() const { return states_; }  // made so far

 private:
  std::size_t steps_left_ = SIZE_MAX, states_left_ = SIZE_MAX, states_ = 0;
  std::stop_token stop_;
};

}  // namespace waymark::automata
