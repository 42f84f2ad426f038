#include "libplan/solve/product_search.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>

#include "libplan/solve/dijkstra.hpp"
#include "libplan/solve/grid_bound.hpp"

namespace waymark::plan {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;
constexpr std::uint64_t pairs_between_polls = 1U << 16U;
constexpr std::uint64_t worth_a_bound = 1U << 16U;  // pairs

// The choice that leads from one pair to the other at least cost, the first such.
template <class Model>
std::uint32_t choice_between(const Model& model, const TaskTable& task, std::uint32_t place, std::uint32_t q,
                             std::uint32_t to, std::uint32_t to_q) {
  std::uint32_t best = nothing;
  for (std::uint32_t k = 0; k < model.choices(place); ++k) {
    const ModelOutcome outcome = model.outcome(place, k, 0);
    if (outcome.target != to || task.next(q, outcome.letter).target != to_q) continue;
    if (best == nothing || model.cost(place, k) < model.cost(place, best)) best = k;
  }
  return best;
}

class PairSet {  // of places and states of the task: one bit for every pair there could be
 public:
  PairSet(std::uint64_t places, std::uint32_t states) : places_(places), bits_(places * states / 64 + 1, 0) {}
  bool insert(std::uint32_t place, std::uint32_t q) {  // true: it was not there
    const std::uint64_t pair = q * places_ + place;
    std::uint64_t& word = bits_[pair / 64];
    const std::uint64_t bit = std::uint64_t{1} << (pair % 64);
    if ((word & bit) != 0) return false;
    word |= bit;
    return true;
  }
  bool contains(std::uint32_t place, std::uint32_t q) const {
    const std::uint64_t pair = q * places_ + place;
    return ((bits_[pair / 64] >> (pair % 64)) & 1U) != 0;
  }

 private:
  std::uint64_t places_;
  std::vector<std::uint64_t> bits_;
};

// By state of the task: every route to a goal comes into it, and can do so in one cell only. Once a search arrives
// there, nothing that it has met before matters any more: the task is cut into legs. From the first state on, for as
// long as each can be left for one other alone, in one cell alone.
std::vector<bool> gates(const GridWorld& grid, const TaskTable& task, std::uint32_t first) {
  std::vector<std::uint32_t> cells(grid.letters().size(), 0);  // by letter
  for (std::uint32_t cell = 0; cell < grid.states(); ++cell)
    if (!grid.is_wall(cell)) ++cells[grid.letter(cell).index];
  std::vector<bool> out(task.states(), false);
  for (std::uint32_t q = first; !task.is_goal(q);) {
    std::uint32_t next = nothing, ways = 0;
    for (std::uint32_t l = 0; l < cells.size(); ++l)
      if (const std::uint32_t target = task.next(q, {l}).target;
          cells[l] > 0 && target != q && target != TaskTable::trap) {
        ways += cells[l];
        next = target;
      }
    if (ways != 1 || next == first || out[next]) break;
    out[next] = true;
    q = next;
  }
  return out;
}
std::vector<bool> gates(const Mdp&, const TaskTable& task,
                        std::uint32_t) {  // letters sit on moves, not in places
  return std::vector<bool>(task.states(), false);
}

// Every pair may be on a shortest route.
struct Everywhere {
  bool operator()(std::uint32_t, std::uint32_t, std::uint32_t) const { return true; }
};

// Pairs in the order in which they were met, each with the number of the one it was met from. `may_lie(place, q,
// depth)`: false for pairs that lie on no shortest route, which are passed over.
template <Model M, class MayLie>
class BreadthFirst {
 public:
  BreadthFirst(const Product<M, TaskTable>& product, std::vector<bool> gates, const MayLie& may_lie)
      : product_(product),
        model_(product.model()),
        task_(product.task()),
        may_lie_(may_lie),
        gates_(std::move(gates)),
        seen_(model_.states(), task_.states()) {}

  std::optional<SearchAnswer> run(const ProductState& first, const ltl::Limits& limits) {
    meet(first.place, first.task, nothing);
    SearchAnswer answer;
    std::size_t layer_ends = 0;  // where the pairs of the next depth begin
    for (std::uint32_t i = 0; i < met_.size() && goal_ == nothing; ++i) {
      if (met_.size() > limits.states || (i % pairs_between_polls == 0 && limits.stop.stop_requested()))
        return std::nullopt;
      if (i == layer_ends) {
        ++depth_;
        layer_ends = met_.size();
      }
      const Met from = met_[i];
      const std::uint32_t choices = product_.choices({from.place, from.task});
      answer.statistics.edges += choices;
      for (std::uint32_t k = 0; k < choices && goal_ == nothing && through_ == nothing; ++k)
        product_.for_each_successor({from.place, from.task}, k,
                                    [&](const ProductState& to) { meet(to.place, to.task, i); });
      if (through_ != nothing) {  // on from there, and from nowhere else
        layer_ends = through_;
        i = through_ - 1;
        through_ = nothing;
      }
    }
    answer.statistics.met = met_.size();
    if (goal_ != nothing) answer.route = route();
    return answer;
  }

 private:
  struct Met {
    std::uint32_t place, task, from;
  };
  void meet(std::uint32_t place, std::uint32_t q, std::uint32_t from) {
    if (!may_lie_(place, q, depth_) || !seen_.insert(place, q)) return;
    if (goal_ == nothing && task_.is_goal(q)) goal_ = static_cast<std::uint32_t>(met_.size());
    if (gates_[q]) through_ = static_cast<std::uint32_t>(met_.size());
    gates_[q] = false;
    met_.push_back({place, q, from});
  }
  ChoiceRoute route() const {
    ChoiceRoute out;
    for (std::uint32_t i = goal_; i != nothing; i = met_[i].from) {
      out.places.push_back(met_[i].place);
      if (const std::uint32_t from = met_[i].from; from != nothing)
        out.choices.push_back(
            choice_between(model_, task_, met_[from].place, met_[from].task, met_[i].place, met_[i].task));
    }
    std::reverse(out.places.begin(), out.places.end());
    std::reverse(out.choices.begin(), out.choices.end());
    for (std::size_t i = 0; i < out.choices.size(); ++i) out.cost += model_.cost(out.places[i], out.choices[i]);
    return out;
  }

  const Product<M, TaskTable>& product_;
  const M& model_;
  const TaskTable& task_;
  const MayLie& may_lie_;
  std::vector<bool> gates_;  // those that have not been met
  PairSet seen_;
  std::deque<Met> met_;                               // never copied to grow
  std::uint32_t depth_ = 0;                           // of the pairs met at the moment
  std::uint32_t goal_ = nothing, through_ = nothing;  // a goal; a gate just met
};

// The moves of a shortest route by A* [HNR68]: pairs by depth and bound together, in buckets, deepest first. A pair is
// settled when it is taken out, since the bound is consistent; a bit each and eight bytes for those in buckets.
class BestFirst {
 public:
  BestFirst(const Product<GridWorld, TaskTable>& product, std::vector<bool> gates, const GridBound& bound)
      : product_(product),
        grid_(product.model()),
        task_(product.task()),
        bound_(bound),
        gates_(std::move(gates)),
        settled_(grid_.states(), task_.states()) {}

  // nullopt: stopped, no route, or given up: `most` pairs were settled, or the way is more than twice as long as the
  // bound had it, so that walls decide and the bound hardly helps.
  std::optional<std::uint32_t> moves(const ProductState& first, std::uint64_t most, const std::stop_token& stop) {
    put(first, 0);
    const std::size_t longest = 2 * buckets_.size();
    for (std::uint32_t f = 0; f < buckets_.size() && f < longest; ++f)
      while (!buckets_[f].empty()) {
        const auto [place, q] = buckets_[f].back();
        buckets_[f].pop_back();
        if (!settled_.insert(place, q)) continue;
        if (task_.is_goal(q)) return f;
        if (gates_[q]) buckets_ = std::vector<std::vector<ProductState>>(buckets_.size());
        gates_[q] = false;
        if (++statistics_.met > most || (statistics_.met % pairs_between_polls == 0 && stop.stop_requested()))
          return std::nullopt;
        statistics_.edges += 4;
        const std::uint32_t depth = f - bound_(place, q);
        for (std::uint32_t k = 0; k < 4; ++k)
          product_.for_each_successor({place, q}, k, [&](const ProductState& to) {
            if (!settled_.contains(to.place, to.task)) put(to, depth + 1);
          });
      }
    return std::nullopt;
  }
  const SearchStatistics& statistics() const { return statistics_; }

 private:
  void put(const ProductState& s, std::uint32_t depth) {
    const std::uint32_t rest = bound_(s.place, s.task);
    if (rest == GridBound::never) return;
    if (depth + rest >= buckets_.size()) buckets_.resize(depth + rest + 1);
    buckets_[depth + rest].push_back(s);
  }

  const Product<GridWorld, TaskTable>& product_;
  const GridWorld& grid_;
  const TaskTable& task_;
  const GridBound& bound_;
  std::vector<bool> gates_;  // those that have not been settled
  PairSet settled_;
  std::vector<std::vector<ProductState>> buckets_;  // by depth + bound
  SearchStatistics statistics_;
};

struct Bounded {  // what A* found: the moves of a shortest route, and the bound that it found them by
  std::optional<GridBound> bound;
  std::optional<std::uint32_t> moves;
  SearchStatistics statistics;
};
Bounded by_best_first(const Product<GridWorld, TaskTable>& product, const ProductState& first,
                      const ltl::Limits& limits) {
  const GridWorld& grid = product.model();
  const TaskTable& task = product.task();
  const std::uint64_t pairs = std::uint64_t{task.states()} * grid.states();
  Bounded out;
  if (pairs < worth_a_bound) return out;
  out.bound = GridBound::of(grid, task);
  if (!out.bound) return out;
  BestFirst search(product, gates(grid, task, first.task), *out.bound);
  out.moves = search.moves(first, std::min<std::uint64_t>(limits.states, pairs / 4), limits.stop);
  out.statistics = search.statistics();
  return out;
}
Bounded by_best_first(const Product<Mdp, TaskTable>&, const ProductState&, const ltl::Limits&) {
  return {};  // no places to measure between
}

// Breadth first. On a grid A* comes first, for a quarter of the pairs there are at most: where it finds how many moves
// it takes, breadth first looks only at pairs whose depth and bound do not exceed them, and finds the same route.
template <Model M>
std::optional<SearchAnswer> in_layers(const Product<M, TaskTable>& product, const ProductState& first,
                                      const ltl::Limits& limits) {
  const Bounded known = by_best_first(product, first, limits);
  const auto within = [&](std::uint32_t place, std::uint32_t q, std::uint32_t depth) {
    const std::uint32_t rest = (*known.bound)(place, q);
    return rest != GridBound::never && depth + rest <= *known.moves;
  };
  const std::vector<bool> legs = gates(product.model(), product.task(), first.task);
  auto answer = known.moves ? BreadthFirst(product, legs, within).run(first, limits)
                            : BreadthFirst(product, legs, Everywhere{}).run(first, limits);
  if (answer) {
    answer->statistics.met += known.statistics.met;
    answer->statistics.edges += known.statistics.edges;
  }
  return answer;
}

}  // namespace

template <class Model>
std::optional<double> uniform_cost(const Model& model) {
  std::optional<double> cost;
  for (std::uint32_t s = 0; s < model.states(); ++s)
    for (std::uint32_t k = 0; k < model.choices(s); ++k) {
      if (!cost) cost = model.cost(s, k);
      if (model.cost(s, k) != *cost) return std::nullopt;
    }
  return cost;
}

template <Model M>
std::optional<SearchAnswer> search(const Product<M, TaskTable>& product, const ltl::Limits& limits) {
  if (!product.model().is_deterministic())
    throw std::invalid_argument("a search for a route needs a deterministic model");
  std::optional<ProductState> first;  // one at most: a DFA does not jump
  product.for_each_start([&](const ProductState& s) { first = s; });
  if (!first) return SearchAnswer{};
  if (uniform_cost(product.model())) return in_layers(product, *first, limits);
  return dijkstra(product, *first, limits);
}

template <class Model>
ltl::Trace word_of(const Model& model, const ChoiceRoute& route) {
  std::vector<ltl::Letter> letters{model.letters()[model.initial_letter()]};
  for (std::size_t i = 0; i < route.choices.size(); ++i) {
    const ModelOutcome outcome = model.outcome(route.places[i], route.choices[i], 0);
    if (outcome.target != route.places[i + 1]) throw std::logic_error("a route that takes a step it cannot take");
    letters.push_back(model.letters()[outcome.letter]);
  }
  return ltl::Trace(std::move(letters));
}

template std::optional<double> uniform_cost(const Mdp&);
template std::optional<double> uniform_cost(const GridWorld&);
template std::optional<SearchAnswer> search(const Product<Mdp, TaskTable>&, const ltl::Limits&);
template std::optional<SearchAnswer> search(const Product<GridWorld, TaskTable>&, const ltl::Limits&);
template ltl::Trace word_of(const Mdp&, const ChoiceRoute&);
template ltl::Trace word_of(const GridWorld&, const ChoiceRoute&);

}  // namespace waymark::plan
