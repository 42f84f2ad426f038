#include "libplan/product/buchi_product.hpp"

#include <stdexcept>

#include "libplan/product/discovery_order.hpp"

namespace waymark::plan {

template <Model M>
BuchiProduct compose(const M& model, const automata::Automaton& automaton, automata::Budget& budget) {
  if (!model.is_deterministic()) throw std::invalid_argument("a lasso needs a deterministic model");
  if (!automaton.acceptance().is_generalized_buchi())
    throw std::invalid_argument("a lasso needs a generalised Büchi automaton");
  const BuchiTask task(automaton, model.letters());
  const Product product(model, task);
  DiscoveryOrder order(model.states(), task.states());
  const auto meet = [&](const ProductState& s) {
    const auto [number, fresh] = order.insert(s);
    if (fresh) budget.state();
    return number;
  };
  BuchiProduct out;
  out.graph.sets = automaton.acceptance().sets;
  product.for_each_start([&](const ProductState& s) { out.graph.starts.push_back(meet(s)); });
  for (std::uint32_t v = 0; v < order.states().size(); ++v) {  // grows while we look: breadth first
    const ProductState from = order.states()[v];
    budget.step(product.choices(from));
    out.graph.first.push_back(static_cast<std::uint32_t>(out.graph.edges.size()));
    for (auto [e, end] = out_edges(from, product); e != end; ++e)
      out.graph.edges.push_back({v, meet(e->to), e->choice, product.step(*e).marks, product.cost(*e)});
  }
  out.graph.first.push_back(static_cast<std::uint32_t>(out.graph.edges.size()));
  out.states = std::move(order).states();
  return out;
}

template BuchiProduct compose(const Mdp&, const automata::Automaton&, automata::Budget&);
template BuchiProduct compose(const GridWorld&, const automata::Automaton&, automata::Budget&);

}  // namespace waymark::plan
