// The product of a model and a task with its reachable pairs numbered, two bits a pair: what value iteration works on.
//
// Reachable pairs are numbered in ascending order of (task, place): a component of the automaton is a range of numbers,
// no outcome leads into a higher range. An outcome from which the task cannot be met leads to `trap`. Solvers are
// written against what is public here; MarkovChain (solve/markov_chain.hpp) has it too. As a graph this is a
// Boost.Graph IncidenceGraph and VertexListGraph.
#pragma once
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/product/product.hpp"
#include "libplan/product/ranked_set.hpp"
#include "libplan/product/task_table.hpp"

namespace waymark::plan {

template <Model M>
class ProductMdp : public Product<M, TaskTable> {
  using Base = Product<M, TaskTable>;

 public:
  struct State {                                             // a pair with its number
    std::uint32_t index;                                     // among the reachable pairs
    std::uint32_t place, task;                               // the pair
    operator ProductState() const { return {place, task}; }  // NOLINT(google-explicit-constructor): its pair
  };

  // The reachable part; model and task must outlive it. nullopt: more states than the limit, or stopped. Large ones are
  // searched by so many threads.
  static std::optional<ProductMdp> explore(const M& model, const TaskTable& task,
                                           const ltl::Limits& limits = {.states = SIZE_MAX}, std::size_t threads = 1);

  std::uint32_t states() const { return states_; }  // reachable pairs
  std::uint64_t edges() const { return edges_; }    // outcomes of all choices, those into the trap left out
  // Where a run may begin: the first letter is read, after a jump or none. Empty: the task cannot be met from the
  // start.
  const std::vector<std::uint32_t>& starts() const { return starts_; }
  State state(std::uint32_t index) const {
    const std::uint64_t pair = pairs_.select(index);
    return {index, static_cast<std::uint32_t>(pair % places_), static_cast<std::uint32_t>(pair / places_)};
  }
  using Compact = ProductState;  // a state in eight bytes, index left out
  Compact compact(const State& s) const { return s; }
  State state(Compact c) const { return {index(c.place, c.task), c.place, c.task}; }
  template <class Visit>  // visit(State), ascending: those with first ≤ index < last
  void for_each_state(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    if (first >= last) return;
    std::uint32_t index = first;
    pairs_.for_each(pairs_.select(first), [&](std::uint64_t pair) {
      if (index == last) return false;
      visit(State{index++, static_cast<std::uint32_t>(pair % places_), static_cast<std::uint32_t>(pair / places_)});
      return true;
    });
  }
  template <class Visit>
  void for_each_state(Visit&& visit) const {
    for_each_state(0, states_, visit);
  }
  // Ranges of indices that no outcome leaves upwards, ascending.
  const std::vector<std::uint32_t>& blocks() const { return blocks_; }
  static constexpr std::uint32_t trap = UINT32_MAX;
  template <class Visit>  // visit(index or trap, probability, is the edge marked)
  void for_each_outcome(State s, std::uint32_t k, Visit&& visit) const {
    if (const std::uint32_t own = this->model().choices(s.place); k >= own) {
      visit(index(s.place, this->task().jumps(s.task)[k - own]), 1.0, false);
      return;
    }
    this->model().for_each_outcome(s.place, k, [&](std::uint32_t place, LetterId letter, double probability) {
      const TaskTable::Successor step = this->task().next(s.task, letter);
      visit(step.target == TaskTable::trap ? trap : index(place, step.target), probability, step.marked);
    });
  }
  template <class Visit>  // visit(index or trap): where some choice may lead, some more than once
  void for_each_target(State s, Visit&& visit) const requires TargetModel<M> {
    if (this->task().is_over(s.task)) return;
    this->model().for_each_target(s.place, [&](std::uint32_t place, LetterId letter, std::uint32_t) {
      const std::uint32_t q = this->task().next(s.task, letter).target;
      visit(q == TaskTable::trap ? trap : index(place, q));
    });
    for (std::uint32_t q : this->task().jumps(s.task)) visit(index(s.place, q));
  }
  bool has_marks() const { return this->task().has_marks(); }  // may an edge be marked?
  template <class Visit>  // visit(State): among others every state with an outcome into s
  void for_each_predecessor(State s, Visit&& visit) const {
    const auto offer = [&](std::uint32_t place, std::uint32_t task) {
      if (pairs_.contains(pair(place, task))) visit(State{index(place, task), place, task});
    };
    const auto enters = [&](std::uint32_t q) {
      if constexpr (TargetModel<M>) return this->task().next(q, this->model().letter(s.place)).target == s.task;
      return true;
    };
    this->model().for_each_predecessor(s.place, [&](std::uint32_t place) {
      for (std::uint32_t q : this->task().sources(s.task))
        if (enters(q)) offer(place, q);
    });
    for (std::uint32_t q : this->task().jump_sources(s.task)) offer(s.place, q);
  }

  // ---- the graph: vertices are listed in the order of their numbers
  using traversal_category = ListedProduct;
  using vertices_size_type = std::size_t;
  class vertex_iterator : public boost::iterator_facade<vertex_iterator, const ProductState,
                                                        boost::single_pass_traversal_tag, ProductState> {
   public:
    vertex_iterator() = default;
    vertex_iterator(const ProductMdp& product, std::uint32_t index) : product_(&product), index_(index) {}

   private:
    friend class boost::iterator_core_access;
    ProductState dereference() const { return product_->state(index_); }
    void increment() { ++index_; }
    bool equal(const vertex_iterator& other) const { return index_ == other.index_; }
    const ProductMdp* product_ = nullptr;
    std::uint32_t index_ = 0;
  };
  // What Boost.Graph asks of a graph with a list of vertices.
  friend std::pair<vertex_iterator, vertex_iterator> vertices(const ProductMdp& g) {
    return {vertex_iterator(g, 0), vertex_iterator(g, g.states())};
  }
  friend vertices_size_type num_vertices(const ProductMdp& g) { return g.states(); }

 private:
  ProductMdp(const M& model, const TaskTable& task)
      : Base(model, task), places_(model.states()), pairs_(places_ * task.states()) {}
  std::uint64_t pair(std::uint32_t place, std::uint32_t task) const { return task * places_ + place; }
  std::uint32_t index(std::uint32_t place, std::uint32_t task) const { return pairs_.rank(pair(place, task)); }
  template <class Visit>
  void for_each_edge(const ProductState& s, Visit&& visit) const;
  void number();

  std::uint64_t places_;
  RankedSet pairs_;
  std::uint32_t states_ = 0;
  std::uint64_t edges_ = 0;
  std::vector<std::uint32_t> starts_, blocks_;
};

}  // namespace waymark::plan
