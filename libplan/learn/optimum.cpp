#include "libplan/learn/optimum.hpp"

#include "libplan/solve/discounted_sweeps.hpp"

namespace waymark::plan {
namespace {

// A learner's product as solvers see one: actions that are offered are choices.
class AsSolved {
 public:
  static constexpr std::uint32_t trap = UINT32_MAX;
  struct State {
    std::uint32_t index;
  };
  explicit AsSolved(const TabularProduct& product) : product_(product) {}

  std::size_t states() const { return product_.states(); }
  template <class Visit>
  void for_each_state(Visit&& visit) const {
    for (std::uint32_t i = 0; i < states(); ++i) visit(State{i});
  }
  bool is_goal(State s) const { return product_.ending(s.index) == Ending::Accepting; }
  std::uint32_t choices(State s) const { return product_.ending(s.index) == Ending::Open ? product_.actions : 0; }
  template <class Visit>  // nothing comes of an action that is not offered
  void for_each_outcome(State s, std::uint32_t action, Visit&& visit) const {
    const std::uint32_t q = product_.task_of(s.index);
    double before = 0;
    for (const TabularProduct::Outcome& o : product_.outcomes_of(product_.position_of(s.index), action)) {
      const std::uint32_t next = product_.task.after(q, o.letter);
      visit(product_.task.ending[next] == Ending::Trap ? trap : product_.state(o.position, next), o.up_to - before,
            false);
      before = o.up_to;
    }
  }

 private:
  const TabularProduct& product_;
};

}  // namespace

Optimum optimum(const TabularProduct& product, const OptimumOptions& options) {
  const AsSolved solved(product);
  const double discount = options.discount;
  DiscountedSweeps sweeps(solved, discount);
  sweeps.run(discount < 1 ? discounted_change(options.tolerance, discount) : options.tolerance, {}, options.sweeps);
  Optimum best;
  best.sweeps = sweeps.sweeps();
  best.policy.assign(product.states(), no_action);
  solved.for_each_state([&](AsSolved::State s) {
    const std::uint32_t action = sweeps.best(s, 1e-14).choice;
    if (action != Strategy::none) best.policy[s.index] = static_cast<std::uint8_t>(action);
  });
  best.value = value_of(product, best.policy, discount);
  return best;
}

}  // namespace waymark::plan
