#include "libplan/solve/least_routes.hpp"

#include <algorithm>
#include <queue>
#include <stdexcept>
#include <unordered_map>

namespace waymark::plan {
namespace {

template <Model M>
class WalkSearch {
  static constexpr std::uint32_t no_walk = UINT32_MAX;

 public:
  WalkSearch(const Product<M, TaskTable>& product, std::size_t most) : product_(product), most_(most) {}

  std::optional<RoutesAnswer> run(const ProductState& first, const ltl::Limits& limits) {
    constexpr std::uint64_t walks_between_polls = 1U << 12U;
    RoutesAnswer answer;
    walks_.push_back({first, no_walk, no_walk, 0});
    heap_.push({0, 0});
    while (!heap_.empty() && answer.routes.size() < most_) {
      if (walks_.size() > std::min<std::size_t>(limits.states, no_walk - 1) ||
          (answer.statistics.met % walks_between_polls == 0 && limits.stop.stop_requested()))
        return std::nullopt;
      const std::uint32_t i = heap_.top().second;
      heap_.pop();
      if (!settle(walks_[i])) continue;
      ++answer.statistics.met;
      if (product_.is_goal(walks_[i].state))
        answer.routes.push_back(route(i));
      else
        expand(i, answer.statistics);
    }
    return answer;
  }

 private:
  struct Walk {
    ProductState state;
    std::uint32_t from, choice;
    double cost;
  };
  using Entry = std::pair<double, std::uint32_t>;  // cost, number: ties by which walk was met first

  bool settle(const Walk& walk) {  // goals end walks of their own, all of them routes
    return product_.is_goal(walk.state) ||
           settled_[walk.state.task * std::uint64_t{product_.model().states()} + walk.state.place]++ < most_;
  }

  void expand(std::uint32_t i, SearchStatistics& statistics) {
    next_.clear();
    const Walk from = walks_[i];
    for (std::uint32_t k = 0; k < product_.choices(from.state); ++k, ++statistics.edges)
      product_.for_each_successor(from.state, k, [&](const ProductState& to) {
        const Walk walk{to, i, k, from.cost + product_.cost(from.state, k)};
        const auto twin =
            std::find_if(next_.begin(), next_.end(), [&](const Walk& other) { return other.state == to; });
        if (twin == next_.end())
          next_.push_back(walk);
        else if (walk.cost < twin->cost)
          *twin = walk;
      });
    for (const Walk& walk : next_) {
      heap_.push({walk.cost, static_cast<std::uint32_t>(walks_.size())});
      walks_.push_back(walk);
    }
  }

  ChoiceRoute route(std::uint32_t end) const {
    ChoiceRoute out;
    out.cost = walks_[end].cost;
    for (std::uint32_t i = end; i != no_walk; i = walks_[i].from) {
      out.places.push_back(walks_[i].state.place);
      if (walks_[i].from != no_walk) out.choices.push_back(walks_[i].choice);
    }
    std::reverse(out.places.begin(), out.places.end());
    std::reverse(out.choices.begin(), out.choices.end());
    return out;
  }

  const Product<M, TaskTable>& product_;
  const std::size_t most_;
  std::vector<Walk> walks_, next_;
  std::unordered_map<std::uint64_t, std::size_t> settled_;  // by pair
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;
};

}  // namespace

template <Model M>
std::optional<RoutesAnswer> least_routes(const Product<M, TaskTable>& product, std::size_t most,
                                         const ltl::Limits& limits) {
  if (!product.model().is_deterministic())
    throw std::invalid_argument("a search for routes needs a deterministic model");
  std::optional<ProductState> first;  // one at most: a DFA does not jump
  product.for_each_start([&](const ProductState& s) { first = s; });
  if (!first) return RoutesAnswer{};
  return WalkSearch<M>(product, most).run(*first, limits);
}

template std::optional<RoutesAnswer> least_routes(const Product<Mdp, TaskTable>&, std::size_t, const ltl::Limits&);
template std::optional<RoutesAnswer> least_routes(const Product<GridWorld, TaskTable>&, std::size_t,
                                                  const ltl::Limits&);

}  // namespace waymark::plan
