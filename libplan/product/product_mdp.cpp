#include "libplan/product/product_mdp.hpp"

#include <atomic>
#include <utility>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/product/shared_work.hpp"

namespace waymark::plan {

template <Model M>
std::optional<ProductMdp<M>> ProductMdp<M>::explore(const M& model, const TaskTable& task, const ltl::Limits& limits,
                                                    std::size_t threads) {
  constexpr std::uint64_t polling_interval = 4096, large = 1U << 17U;
  ProductMdp out(model, task);
  if (out.places_ * task.states() < large) threads = 1;
  const auto is_new = [&](const ProductState& s) {
    const std::uint64_t pair = out.pair(s.place, s.task);
    return threads == 1 ? out.pairs_.insert(pair) : out.pairs_.insert_together(pair);
  };
  std::vector<ProductState> first;
  const auto begin = [&](std::size_t, const auto& put) {
    out.for_each_start([&](const ProductState& s) {
      if (is_new(s)) put(s);
      first.push_back(s);
    });
  };
  struct alignas(64) Found {  // by one thread, in a line of the cache of its own
    std::uint64_t states = 0, edges = 0, told = 0;
  };
  std::vector<Found> found(threads);
  std::atomic<std::uint64_t> all{0};  // states that threads have told of
  const auto expand = [&](const ProductState& s, const auto& put, std::size_t thread) {
    Found& own = found[thread];
    if (own.states++ % polling_interval == 0) {
      all += own.states - std::exchange(own.told, own.states);
      if (all > limits.states || limits.stop.stop_requested()) return false;
    }
    out.for_each_edge(s, [&](const ProductState& t, std::uint32_t times) {
      own.edges += times;
      if (is_new(t)) put(t);
    });
    return true;
  };
  if (!search_together<ProductState>(1, threads, begin, expand)) return std::nullopt;
  std::uint64_t states = 0;
  for (const Found& own : found) {
    states += own.states;
    out.edges_ += own.edges;
  }
  if (states > limits.states) return std::nullopt;
  out.states_ = static_cast<std::uint32_t>(states);
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
