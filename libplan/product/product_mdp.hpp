// The product 𝓜 ⊗ 𝒜 of a model and a task as a Markov decision process, implicit: what is stored is which pairs can be
// reached, two bits a pair, and successors are computed when asked for.
//
// A state is a pair (place, task): the task is the automaton's state after it has read the letter of the place
// [BK08, Def. 10.49]. Its choices are those of the model, then one for every jump of the automaton, which costs nothing
// and stays in the place. Reachable pairs are numbered in ascending order of (task, place): a component of the automaton is a range of
// numbers, no outcome leads into a higher range. Goals have no choices. An outcome from which the task cannot be met is `lost`.
//
// Model: Mdp or GridWorld. Solvers are written against what is public here, and MarkovChain (solve/markov_chain.hpp) has it too.
#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "libplan/product/task_table.hpp"

namespace waymark::plan {

// A set of pairs (place, task) that knows how many members come before each.
class RankedSet {
 public:
  explicit RankedSet(std::uint64_t size) : words_(size / 64 + 1) {}
  bool contains(std::uint64_t i) const { return ((words_[i / 64].bits >> (i % 64)) & 1U) != 0; }
  bool insert(std::uint64_t i) {  // false: it was there
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    if ((words_[i / 64].bits & bit) != 0) return false;
    words_[i / 64].bits |= bit;
    return true;
  }
  void rank();  // after the last insert
  std::uint32_t rank(std::uint64_t i) const {
    const Word& word = words_[i / 64];
    return word.before +
           static_cast<std::uint32_t>(std::popcount(word.bits & ((std::uint64_t{1} << (i % 64)) - 1)));
  }
  std::uint64_t select(std::uint32_t rank) const;  // the member with that rank, O(log size)
  template <class Visit>  // visit(member), ascending from `first` on, until it says false
  void for_each(std::uint64_t first, Visit&& visit) const {
    std::uint64_t skip = ~std::uint64_t{0} << (first % 64);
    for (std::uint64_t w = first / 64; w < words_.size(); ++w, skip = ~std::uint64_t{0})
      for (std::uint64_t bits = words_[w].bits & skip; bits != 0; bits &= bits - 1)
        if (!visit(64 * w + static_cast<std::uint64_t>(std::countr_zero(bits)))) return;
  }
  std::size_t bytes() const { return words_.size() * sizeof(Word); }

 private:
  struct Word {
    std::uint64_t bits = 0;
    std::uint32_t before = 0;
  };
  std::vector<Word> words_;
};

template <class Model>
class ProductMdp {
 public:
  struct State {
    std::uint32_t index;  // among the reachable pairs
    std::uint32_t place, task;
  };

  // The reachable part; model and task must outlive it. nullopt: more states than the limit, or stopped.
  static std::optional<ProductMdp> explore(const Model& model, const TaskTable& task,
                                           std::size_t limit = SIZE_MAX, const std::stop_token& stop = {});

  std::uint32_t states() const { return states_; }
  std::uint64_t edges() const { return edges_; }  // outcomes of all choices that are not lost
  // Where a run may begin: the first letter is read, after a jump or none. Empty: the task is lost from the start.
  const std::vector<std::uint32_t>& starts() const { return starts_; }
  State state(std::uint32_t index) const {
    const std::uint64_t pair = pairs_.select(index);
    return {index, static_cast<std::uint32_t>(pair % places_), static_cast<std::uint32_t>(pair / places_)};
  }
  struct Compact {  // a state in eight bytes, index left out
    std::uint32_t place, task;
  };
  Compact compact(const State& s) const { return {s.place, s.task}; }
  State state(Compact c) const { return {index(c.place, c.task), c.place, c.task}; }
  template <class Visit>  // visit(State), ascending: those with first ≤ index < last
  void for_each_state(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    if (first >= last) return;
    std::uint32_t index = first;
    pairs_.for_each(pairs_.select(first), [&](std::uint64_t pair) {
      if (index == last) return false;
      visit(State{index++, static_cast<std::uint32_t>(pair % places_),
                  static_cast<std::uint32_t>(pair / places_)});
      return true;
    });
  }
  template <class Visit>
  void for_each_state(Visit&& visit) const {
    for_each_state(0, states_, visit);
  }
  // Ranges of indices that no outcome leaves upwards, ascending.
  const std::vector<std::uint32_t>& blocks() const { return blocks_; }
  bool is_goal(State s) const { return task_->is_goal(s.task); }

  std::uint32_t choices(State s) const {
    if (is_goal(s)) return 0;
    return model_->choices(s.place) + static_cast<std::uint32_t>(task_->jumps(s.task).size());
  }
  bool is_jump(State s, std::uint32_t k) const { return k >= model_->choices(s.place); }
  double cost(State s, std::uint32_t k) const { return is_jump(s, k) ? 0 : model_->cost(s.place, k); }
  static constexpr std::uint32_t lost = UINT32_MAX;
  template <class Visit>  // visit(index or lost, probability, is the edge marked)
  void for_each_outcome(State s, std::uint32_t k, Visit&& visit) const {
    if (const std::uint32_t own = model_->choices(s.place); k >= own) {
      visit(index(s.place, task_->jumps(s.task)[k - own]), 1.0, false);
      return;
    }
    model_->for_each_outcome(s.place, k, [&](std::uint32_t place, LetterId letter, double probability) {
      const TaskTable::Step step = task_->next(s.task, letter);
      visit(step.target == TaskTable::lost ? lost : index(place, step.target), probability, step.marked);
    });
  }
  template <class Visit>  // visit(State): among others every state with an outcome into s
  void for_each_predecessor(State s, Visit&& visit) const {
    const auto offer = [&](std::uint32_t place, std::uint32_t task) {
      if (pairs_.contains(pair(place, task))) visit(State{index(place, task), place, task});
    };
    model_->for_each_predecessor(s.place, [&](std::uint32_t place) {
      for (std::uint32_t q : task_->sources(s.task)) offer(place, q);
    });
    for (std::uint32_t q : task_->jump_sources(s.task)) offer(s.place, q);
  }
  const Model& model() const { return *model_; }
  const TaskTable& task() const { return *task_; }

 private:
  ProductMdp(const Model& model, const TaskTable& task)
      : model_(&model), task_(&task), places_(model.states()), pairs_(places_ * task.states()) {}
  std::uint64_t pair(std::uint32_t place, std::uint32_t task) const { return task * places_ + place; }
  std::uint32_t index(std::uint32_t place, std::uint32_t task) const {
    return pairs_.rank(pair(place, task));
  }
  void number();

  const Model* model_;
  const TaskTable* task_;
  std::uint64_t places_;
  RankedSet pairs_;
  std::uint32_t states_ = 0;
  std::uint64_t edges_ = 0;
  std::vector<std::uint32_t> starts_, blocks_;
};

template <class Model>
std::optional<ProductMdp<Model>> ProductMdp<Model>::explore(const Model& model, const TaskTable& task,
                                                            std::size_t limit, const std::stop_token& stop) {
  ProductMdp out(model, task);
  std::vector<State> open;  // index is not known yet
  const auto reach = [&](std::uint32_t place, std::uint32_t q) {
    if (!out.pairs_.insert(out.pair(place, q))) return;
    ++out.states_;
    open.push_back({0, place, q});
  };
  std::vector<State> first;
  const auto begin = [&](std::uint32_t q) {
    const std::uint32_t after = task.next(q, model.initial_letter()).target;
    if (after == TaskTable::lost) return;
    reach(model.initial(), after);
    first.push_back({0, model.initial(), after});
  };
  if (task.initial() != TaskTable::lost) {
    begin(task.initial());
    for (std::uint32_t q : task.jumps(task.initial())) begin(q);
  }
  constexpr std::size_t polling_interval = 4096;
  for (std::size_t done = 0; !open.empty(); ++done) {
    if (out.states_ > limit || (done % polling_interval == 0 && stop.stop_requested())) return std::nullopt;
    const State s = open.back();
    open.pop_back();
    if (out.is_goal(s)) continue;
    for (std::uint32_t q : task.jumps(s.task)) reach(s.place, q);
    out.edges_ += task.jumps(s.task).size();
    for (std::uint32_t k = 0; k < model.choices(s.place); ++k)
      model.for_each_outcome(s.place, k, [&](std::uint32_t place, LetterId letter, double) {
        const TaskTable::Step step = task.next(s.task, letter);
        if (step.target == TaskTable::lost) return;
        ++out.edges_;
        reach(place, step.target);
      });
  }
  out.number();
  for (const State& s : first) out.starts_.push_back(out.index(s.place, s.task));
  return out;
}

template <class Model>
void ProductMdp<Model>::number() {
  pairs_.rank();
  for (std::uint32_t q : task_->components()) blocks_.push_back(pairs_.rank(q * places_));
}

}  // namespace waymark::plan
