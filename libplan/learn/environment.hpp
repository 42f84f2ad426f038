// The step loop of an episode: a learner acts, the model draws an outcome, the task reads its letter.
//
// An episode begins in a start and ends where the task does, or is cut after `horizon` steps. A cut is no ending: what
// would have come is unknown, not nothing.
#pragma once
#include "libltl/structure/random.hpp"
#include "libplan/learn/tabular_product.hpp"

namespace waymark::plan {

class Environment {  // product and generator must outlive it
 public:
  struct Transition {                                               // what a step has done
    std::uint32_t position = 0, letter = 0;                         // of the outcome
    std::uint32_t state = 0;                                        // of the product, after it
    Ending ending = Ending::Open;                                   // of the task
    bool cut = false;                                               // by the horizon
    bool is_last() const { return cut || ending != Ending::Open; }  // the next step begins an episode
  };

  // The product is not over at every start.
  Environment(const TabularProduct& product, std::size_t horizon, ltl::Random& random)
      : product_(&product), random_(&random), horizon_(horizon) {
    reset();
  }

  std::uint32_t state() const { return state_; }  // of the product, now
  void reset() {                                  // begins an episode in a start, drawn
    do state_ = draw_start();
    while (product_->ending(state_) != Ending::Open);
    age_ = 0;
  }
  void reset(std::uint32_t state) {  // an open one
    state_ = state;
    age_ = 0;
  }

  Transition step(std::uint32_t action) {  // one that is offered
    const auto outcomes = product_->outcomes_of(product_->position_of(state_), action);
    std::size_t i = 0;
    if (outcomes.size() > 1)
      for (const double draw = random_->unit(); outcomes[i].up_to <= draw;) ++i;
    const std::uint32_t q = product_->task.after(product_->task_of(state_), outcomes[i].letter);
    state_ = product_->state(outcomes[i].position, q);
    return {outcomes[i].position, outcomes[i].letter, state_, product_->task.ending[q], ++age_ >= horizon_};
  }

  std::uint32_t random_action() {  // each one offered here is equally likely
    const std::uint32_t position = product_->position_of(state_);
    while (true) {
      const auto action = static_cast<std::uint32_t>(random_->below(product_->actions));
      if (product_->is_offered(position, action)) return action;
    }
  }

 private:
  std::uint32_t draw_start() {
    if (product_->starts.size() == 1) return product_->starts[0].state;
    double draw = random_->unit();
    for (const TabularProduct::Start& start : product_->starts) {
      if (draw < start.probability) return start.state;
      draw -= start.probability;
    }
    return product_->starts.back().state;
  }

  const TabularProduct* product_;
  ltl::Random* random_;
  std::size_t horizon_, age_ = 0;
  std::uint32_t state_ = 0;
};

}  // namespace waymark::plan
