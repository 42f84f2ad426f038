#include "libplan/learn/optimum.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::plan {
namespace {

double after(const TabularProduct& product, const std::vector<double>& value, std::uint32_t position,
             std::uint32_t q, std::uint32_t action, double discount) {
  double sum = 0, before = 0;
  for (const TabularProduct::Outcome& o : product.outcomes_of(position, action)) {
    const std::uint32_t next = product.task.after(q, o.letter);
    const double probability = o.up_to - before;
    before = o.up_to;
    switch (product.task.ending[next]) {
      case Ending::Accepting: sum += probability; break;
      case Ending::Trap: break;
      case Ending::Open: sum += probability * discount * value[product.state(o.position, next)]; break;
    }
  }
  return sum;
}

template <class Visit>  // visit(position, task) for every open pair
void for_each_open(const TabularProduct& product, Visit&& visit) {
  for (std::uint32_t position = 0; position < product.positions; ++position)
    for (std::uint32_t q = 0; q < product.task.tasks; ++q)
      if (product.task.ending[q] == Ending::Open) visit(position, q);
}

}  // namespace

Optimum optimum(const TabularProduct& product, const OptimumOptions& options) {
  std::vector<double> value(product.states(), 0);
  Optimum best;
  const double discount = options.discount;
  const double enough = discount < 1 ? options.tolerance * (1 - discount) : options.tolerance;
  for (double change = 1; change > enough && best.sweeps < options.sweeps; ++best.sweeps) {
    change = 0;
    for_each_open(product, [&](std::uint32_t position, std::uint32_t q) {
      double most = 0;
      for (std::uint32_t a = 0; a < product.actions; ++a)
        if (product.is_offered(position, a))
          most = std::max(most, after(product, value, position, q, a, discount));
      double& v = value[product.state(position, q)];
      change = std::max(change, std::abs(most - v));
      v = most;
    });
  }
  best.policy.assign(product.states(), no_action);
  for_each_open(product, [&](std::uint32_t position, std::uint32_t q) {
    double most = 0;
    for (std::uint32_t a = 0; a < product.actions; ++a) {
      if (!product.is_offered(position, a)) continue;
      const double worth = after(product, value, position, q, a, discount);
      if (worth <= most + 1e-15) continue;  // the first of equals, and none where nothing is to be gained
      most = worth;
      best.policy[product.state(position, q)] = static_cast<std::uint8_t>(a);
    }
  });
  best.value = value_of(product, best.policy, discount);
  return best;
}

}  // namespace waymark::plan
