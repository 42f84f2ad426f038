#include "libplan/product/product_mdp.hpp"

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan {

template <Model M>
std::optional<ProductMdp<M>> ProductMdp<M>::explore(const M& model, const TaskTable& task, const ltl::Limits& limits) {
  ProductMdp out(model, task);
  std::vector<ProductState> open, first;
  const auto reach = [&](const ProductState& s) {
    if (!out.pairs_.insert(out.pair(s.place, s.task))) return;
    ++out.states_;
    open.push_back(s);
  };
  out.for_each_start([&](const ProductState& s) {
    reach(s);
    first.push_back(s);
  });
  constexpr std::size_t polling_interval = 4096;
  for (std::size_t done = 0; !open.empty(); ++done) {
    if (out.states_ > limits.states || (done % polling_interval == 0 && limits.stop.stop_requested()))
      return std::nullopt;
    const ProductState s = open.back();
    open.pop_back();
    out.for_each_edge(s, [&](const ProductState& t, std::uint32_t times) {
      out.edges_ += times;
      reach(t);
    });
  }
  out.number();
  for (const ProductState& s : first) out.starts_.push_back(out.index(s.place, s.task));
  return out;
}

// visit(pair, times): by how many outcomes of all choices the pair is reached.
template <Model M>
template <class Visit>
void ProductMdp<M>::for_each_edge(const ProductState& s, Visit&& visit) const {
  if constexpr (TargetModel<M>) {
    if (this->task().is_over(s.task)) return;
    this->model().for_each_target(s.place, [&](std::uint32_t place, LetterId letter, std::uint32_t times) {
      for (const auto& step : this->task().steps(s.task, letter)) visit(ProductState{place, step.target}, times);
    });
    for (std::uint32_t q : this->task().jumps(s.task)) visit(ProductState{s.place, q}, 1);
  } else {
    for (std::uint32_t k = 0, choices = this->choices(s); k < choices; ++k)
      this->for_each_successor(s, k, [&](const ProductState& t) { visit(t, 1); });
  }
}

template <Model M>
void ProductMdp<M>::number() {
  pairs_.rank();
  for (std::uint32_t q : this->task().components()) blocks_.push_back(pairs_.rank(q * places_));
}

template class ProductMdp<Mdp>;
template class ProductMdp<GridWorld>;

}  // namespace waymark::plan
