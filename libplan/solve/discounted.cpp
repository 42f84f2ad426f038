#include "libplan/solve/discounted.hpp"

#include <algorithm>
#include <stdexcept>

namespace waymark::plan {
namespace {

template <class Product>
class Sweeps {
 public:
  Sweeps(const Product& product, double discount)
      : product_(product), discount_(discount), values_(product.states(), 0) {
    product.for_each_state([&](const auto& s) {
      if (product.is_goal(s)) values_[s.index] = 1 / discount;  // so that γ V is 1
    });
  }

  // Until values are proved to be no further off than that, or than rounding lets them be; false: stopped.
  bool run(double error, const std::stop_token& stop) {
    const double enough = std::max(error, 1e-15) * (1 - discount_) / discount_;
    for (double change = 2 * enough; change > enough; ++sweeps_) {
      if (stop.stop_requested()) return false;
      change = 0;
      product_.for_each_state([&](const auto& s) {
        if (product_.is_goal(s)) return;
        const double value = best(s).value;
        change = std::max(change, value - values_[s.index]);
        values_[s.index] = std::max(values_[s.index], value);
      });
    }
    return true;
  }

  struct Best {
    std::uint32_t choice = Strategy::none;
    double value = 0;
  };
  template <class State>
  Best best(const State& s) const {  // the first best choice; none where nothing is to be gained
    Best out;
    for (std::uint32_t k = 0; k < product_.choices(s); ++k) {
      double sum = 0;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::lost) sum += p * discount_ * values_[t];
      });
      if (sum > out.value) out = {k, sum};
    }
    return out;
  }
  double value(std::uint32_t i) const { return std::min(values_[i], 1.0); }
  std::uint64_t sweeps() const { return sweeps_; }

 private:
  const Product& product_;
  double discount_;
  std::vector<double> values_;
  std::uint64_t sweeps_ = 0;
};

}  // namespace

template <class Model>
std::optional<Decided> greatest_discounted(const ProductMdp<Model>& product, double discount,
                                           const DecisionLimits& limits) {
  if (!(discount > 0 && discount < 1)) throw std::invalid_argument("a discount lies between 0 and 1");
  if (product.starts().empty()) return Decided{};
  Decided out;
  out.strategy.start = product.starts().front();
  out.strategy.choice.assign(product.states(), Strategy::none);
  if (chance(product) == Chance::None) return out;
  const double error = limits.tolerance * (1 - discount) / 4;
  Sweeps sweeps(product, discount);
  if (!sweeps.run(error, limits.stop)) return std::nullopt;
  out.sweeps = sweeps.sweeps();
  for (std::uint32_t i : product.starts())
    if (sweeps.value(i) > sweeps.value(out.strategy.start)) out.strategy.start = i;
  product.for_each_state([&](const auto& s) {
    if (!product.is_goal(s)) out.strategy.choice[s.index] = sweeps.best(s).choice;
  });
  const double value = sweeps.value(out.strategy.start);
  out.value = {value, std::min(1.0, value + error)};
  const MarkovChain chain(product, out.strategy);
  Sweeps evaluation(chain, discount);
  if (!evaluation.run(error, limits.stop)) return std::nullopt;
  const double found = evaluation.value(0);
  out.re_evaluated = {found, std::min(1.0, found + error)};
  if (out.re_evaluated.upper < value - limits.tolerance)
    throw std::logic_error("a strategy that is not worth what was claimed");
  return out;
}

template std::optional<Decided> greatest_discounted(const ProductMdp<Mdp>&, double, const DecisionLimits&);
template std::optional<Decided> greatest_discounted(const ProductMdp<GridWorld>&, double,
                                                    const DecisionLimits&);

}  // namespace waymark::plan
