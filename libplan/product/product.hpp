// The product 𝓜 ⊗ 𝒜 of a model and a task, implicit: nothing is stored, successors are computed when asked for.
//
// A state is a pair (place, task): the task is the automaton's state after it has read the letter of the place
// [BK08, Def. 10.49]. Its choices are those of the model, then one for every jump of the automaton, which costs nothing
// and stays in the place.
//
// A product is a Boost.Graph IncidenceGraph: a vertex is a pair, an edge one step of the task on one outcome of one
// choice, in that order. Searches that need no vertex list (breadth_first_visit, *_no_init) run on it as it is.
// ProductMdp and MapProduct are products whose reachable pairs are numbered, and so list their vertices.
#pragma once
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "libplan/model/model.hpp"
#include "libplan/product/task.hpp"

namespace waymark::plan {

struct ProductState {                 // a vertex
  std::uint32_t place = 0, task = 0;  // states of the model and of the automaton
  friend auto operator<=>(const ProductState&, const ProductState&) = default;
};

struct ProductEdge {                                // an edge
  ProductState from, to;                            // its ends
  std::uint32_t choice = 0, outcome = 0, step = 0;  // of the model; of the choice; of the task
  friend bool operator==(const ProductEdge&, const ProductEdge&) = default;
};

// The traversal category of a product whose vertices are listed.
struct ListedProduct : virtual boost::incidence_graph_tag, virtual boost::vertex_list_graph_tag {};

template <Model M, Task T>
class Product {
 public:
  Product(const M& model, const T& task) : model_(&model), task_(&task) {}  // both must outlive the product

  // The factors.
  const M& model() const { return *model_; }
  const T& task() const { return *task_; }
  bool is_goal(const ProductState& s) const { return task_->is_goal(s.task); }  // may the run stop here?
  std::uint32_t choices(const ProductState& s) const {                          // of the model, then the jumps
    if (task_->is_over(s.task)) return 0;
    return model_->choices(s.place) + static_cast<std::uint32_t>(task_->jumps(s.task).size());
  }
  // a choice of the automaton alone.
  bool is_jump(const ProductState& s, std::uint32_t k) const { return k >= model_->choices(s.place); }
  // a jump costs nothing.
  double cost(const ProductState& s, std::uint32_t k) const { return is_jump(s, k) ? 0 : model_->cost(s.place, k); }
  template <class Visit>  // visit(pair): where a run may begin that starts in the place with that letter
  void for_each_start(std::uint32_t place, LetterId letter, Visit&& visit) const {
    for (const std::uint32_t q : task_->initial_states())
      for (const auto& step : task_->steps(q, letter)) visit(ProductState{place, step.target});
  }
  template <class Visit>  // the same of the model's own start
  void for_each_start(Visit&& visit) const {
    for_each_start(model_->initial(), model_->initial_letter(), visit);
  }
  template <class Visit>  // visit(pair): where the choice may lead, outcomes into traps left out
  void for_each_successor(const ProductState& s, std::uint32_t k, Visit&& visit) const {
    if (const std::uint32_t own = model_->choices(s.place); k >= own)
      return visit(ProductState{s.place, task_->jumps(s.task)[k - own]});
    model_->for_each_outcome(s.place, k, [&](std::uint32_t place, LetterId letter, double) {
      for (const auto& step : task_->steps(s.task, letter)) visit(ProductState{place, step.target});
    });
  }

  // ---- the graph
  using vertex_descriptor = ProductState;
  using edge_descriptor = ProductEdge;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using traversal_category = boost::incidence_graph_tag;
  using degree_size_type = std::size_t;

  // Over the outcomes of all choices.
  class out_edge_iterator
      : public boost::iterator_facade<out_edge_iterator, const ProductEdge, boost::single_pass_traversal_tag> {
   public:
    out_edge_iterator() = default;
    out_edge_iterator(const Product& product, const ProductState& from, std::uint32_t choice)
        : product_(&product), choices_(product.choices(from)) {
      edge_.from = from;
      edge_.choice = choice;
      settle();
    }

   private:
    friend class boost::iterator_core_access;
    const ProductEdge& dereference() const { return edge_; }
    void increment() {
      ++edge_.step;
      settle();
    }
    bool equal(const out_edge_iterator& other) const {
      return edge_.choice == other.edge_.choice && edge_.outcome == other.edge_.outcome &&
             edge_.step == other.edge_.step;
    }
    // To the first edge at or after (choice, outcome, step), or to the end (choices, 0, 0).
    void settle() {
      for (; edge_.choice < choices_; ++edge_.choice, edge_.outcome = 0)
        for (; edge_.outcome < product_->outcomes(edge_.from, edge_.choice); ++edge_.outcome, edge_.step = 0)
          if (product_->find_target(edge_)) return;
    }
    const Product* product_ = nullptr;
    std::uint32_t choices_ = 0;
    ProductEdge edge_;
  };

  // What Boost.Graph asks of a graph.
  friend std::pair<out_edge_iterator, out_edge_iterator> out_edges(const ProductState& v, const Product& g) {
    return {out_edge_iterator(g, v, 0), out_edge_iterator(g, v, g.choices(v))};
  }
  friend degree_size_type out_degree(const ProductState& v, const Product& g) {
    const auto [begin, end] = out_edges(v, g);
    return static_cast<degree_size_type>(std::distance(begin, end));
  }
  friend ProductState source(const ProductEdge& e, const Product&) { return e.from; }
  friend ProductState target(const ProductEdge& e, const Product&) { return e.to; }
  double cost(const ProductEdge& e) const { return cost(e.from, e.choice); }  // of the choice
  auto step(const ProductEdge& e) const {                                     // of the task; the edge is no jump
    return task_->steps(e.from.task, model_->outcome(e.from.place, e.choice, e.outcome).letter)[e.step];
  }

 private:
  std::uint32_t outcomes(const ProductState& s, std::uint32_t k) const {
    return is_jump(s, k) ? 1 : model_->outcome_count(s.place, k);
  }
  bool find_target(ProductEdge& e) const {  // false: the outcome has no such step
    if (const std::uint32_t own = model_->choices(e.from.place); e.choice >= own) {
      e.to = {e.from.place, task_->jumps(e.from.task)[e.choice - own]};
      return e.step == 0;
    }
    const ModelOutcome outcome = model_->outcome(e.from.place, e.choice, e.outcome);
    const auto steps = task_->steps(e.from.task, outcome.letter);
    if (e.step >= steps.size()) return false;
    e.to = {outcome.target, steps[e.step].target};
    return true;
  }

  const M* model_;
  const T* task_;
};

}  // namespace waymark::plan
