#include "libplan/solve/discounted.hpp"

#include <algorithm>
#include <stdexcept>

#include "libplan/solve/discounted_sweeps.hpp"

namespace waymark::plan {
template <class Model>
std::optional<Decided> greatest_discounted(const ProductMdp<Model>& product, double discount,
                                           const IterationOptions& limits) {
  if (!(discount > 0 && discount < 1)) throw std::invalid_argument("a discount lies between 0 and 1");
  if (product.starts().empty()) return Decided{};
  Decided out;
  out.strategy.start = product.starts().front();
  out.strategy.choice = Choices(product.states());
  if (qualitative(product) == Qualitative::None) return out;
  const double error = limits.tolerance * (1 - discount) / 4;
  DiscountedSweeps sweeps(product, discount);
  if (!sweeps.run(discounted_change(error, discount), limits.stop)) return std::nullopt;
  out.sweeps = sweeps.sweeps();
  for (std::uint32_t i : product.starts())
    if (sweeps.value(i) > sweeps.value(out.strategy.start)) out.strategy.start = i;
  product.for_each_state([&](const auto& s) {
    if (!product.is_goal(s)) out.strategy.choice.set(s.index, sweeps.best(s).choice);
  });
  const double value = sweeps.value(out.strategy.start);
  out.value = {value, std::min(1.0, value + error)};
  const MarkovChain chain(product, out.strategy);
  DiscountedSweeps evaluation(chain, discount);
  if (!evaluation.run(discounted_change(error, discount), limits.stop)) return std::nullopt;
  const double found = evaluation.value(0);
  out.re_evaluated = {found, std::min(1.0, found + error)};
  if (out.re_evaluated.upper < value - limits.tolerance)
    throw std::logic_error("a strategy that is not worth what was claimed");
  return out;
}

template std::optional<Decided> greatest_discounted(const ProductMdp<Mdp>&, double, const IterationOptions&);
template std::optional<Decided> greatest_discounted(const ProductMdp<GridWorld>&, double, const IterationOptions&);

}  // namespace waymark::plan
