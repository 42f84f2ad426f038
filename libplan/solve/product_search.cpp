#include "libplan/solve/product_search.hpp"

#include <algorithm>
#include <deque>
#include <queue>
#include <stdexcept>
#include <unordered_map>

namespace waymark::plan {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;
constexpr std::uint64_t polling_interval = 1U << 16U;

struct Target {
  std::uint32_t place = 0;
  LetterId letter;
};
template <class Model>
Target target_of(const Model& model, std::uint32_t place, std::uint32_t k) {
  Target out;
  model.for_each_outcome(place, k, [&](std::uint32_t t, LetterId letter, double) { out = {t, letter}; });
  return out;
}

// The choice that leads from one pair to the other at least cost, the first such.
template <class Model>
std::uint32_t choice_between(const Model& model, const TaskTable& task, std::uint32_t place, std::uint32_t q,
                             std::uint32_t to, std::uint32_t to_q) {
  std::uint32_t best = nothing;
  for (std::uint32_t k = 0; k < model.choices(place); ++k) {
    const auto target = target_of(model, place, k);
    if (target.place != to || task.next(q, target.letter).target != to_q) continue;
    if (best == nothing || model.cost(place, k) < model.cost(place, best)) best = k;
  }
  return best;
}

// Pairs in the order in which they were met, each with the number of the one it was met from.
template <class Model>
class BreadthFirst {
 public:
  BreadthFirst(const Model& model, const TaskTable& task)
      : model_(model), task_(task), places_(model.states()), seen_(places_ * task.states() / 64 + 1, 0) {}

  std::optional<SearchAnswer> run(std::uint32_t first, std::size_t limit, const std::stop_token& stop) {
    meet(model_.initial(), first, nothing);
    SearchAnswer answer;
    for (std::uint32_t i = 0; i < met_.size() && goal_ == nothing; ++i) {
      if (met_.size() > limit || (i % polling_interval == 0 && stop.stop_requested())) return std::nullopt;
      const Met from = met_[i];
      const std::uint32_t choices = model_.choices(from.place);
      answer.effort.edges += choices;
      for (std::uint32_t k = 0; k < choices && goal_ == nothing; ++k)
        model_.for_each_outcome(from.place, k, [&](std::uint32_t place, LetterId letter, double) {
          if (const std::uint32_t q = task_.next(from.task, letter).target; q != TaskTable::lost)
            meet(place, q, i);
        });
    }
    answer.effort.met = met_.size();
    if (goal_ != nothing) answer.route = route();
    return answer;
  }

 private:
  struct Met {
    std::uint32_t place, task, from;
  };
  void meet(std::uint32_t place, std::uint32_t q, std::uint32_t from) {
    const std::uint64_t pair = q * places_ + place;
    std::uint64_t& word = seen_[pair / 64];
    const std::uint64_t bit = std::uint64_t{1} << (pair % 64);
    if ((word & bit) != 0) return;
    word |= bit;
    if (goal_ == nothing && task_.is_goal(q)) goal_ = static_cast<std::uint32_t>(met_.size());
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
    for (std::size_t i = 0; i < out.choices.size(); ++i)
      out.cost += model_.cost(out.places[i], out.choices[i]);
    return out;
  }

  const Model& model_;
  const TaskTable& task_;
  std::uint64_t places_;
  std::vector<std::uint64_t> seen_;
  std::deque<Met> met_;  // never copied to grow
  std::uint32_t goal_ = nothing;
};

template <class Model>
class Dijkstra {
 public:
  Dijkstra(const Model& model, const TaskTable& task) : model_(model), task_(task), places_(model.states()) {}

  std::optional<SearchAnswer> run(std::uint32_t first, std::size_t limit, const std::stop_token& stop) {
    relax(model_.initial(), first, 0, nothing, 0);
    SearchAnswer answer;
    for (std::uint64_t done = 0; !heap_.empty(); ++done) {
      if (met_.size() > limit || (done % polling_interval == 0 && stop.stop_requested())) return std::nullopt;
      const auto [cost, i] = heap_.top();
      heap_.pop();
      if (cost > met_[i].cost) continue;
      if (task_.is_goal(met_[i].task)) {
        answer.route = route(i);
        break;
      }
      const std::uint32_t place = met_[i].place, q = met_[i].task;
      for (std::uint32_t k = 0; k < model_.choices(place); ++k, ++answer.effort.edges) {
        const auto target = target_of(model_, place, k);
        const std::uint32_t next = task_.next(q, target.letter).target;
        if (next != TaskTable::lost) relax(target.place, next, cost + model_.cost(place, k), i, k);
      }
    }
    answer.effort.met = met_.size();
    return answer;
  }

 private:
  struct Met {
    std::uint32_t place, task, from, choice;
    double cost;
  };
  using Entry = std::pair<double, std::uint32_t>;  // cost, number: ties by who was met first

  void relax(std::uint32_t place, std::uint32_t q, double cost, std::uint32_t from, std::uint32_t choice) {
    const auto [at, fresh] =
        number_.try_emplace(q * places_ + place, static_cast<std::uint32_t>(met_.size()));
    if (fresh)
      met_.push_back({place, q, from, choice, cost});
    else if (cost < met_[at->second].cost)
      met_[at->second] = {place, q, from, choice, cost};
    else
      return;
    heap_.push({cost, at->second});
  }
  ChoiceRoute route(std::uint32_t goal) const {
    ChoiceRoute out;
    out.cost = met_[goal].cost;
    for (std::uint32_t i = goal; i != nothing; i = met_[i].from) {
      out.places.push_back(met_[i].place);
      if (met_[i].from != nothing) out.choices.push_back(met_[i].choice);
    }
    std::reverse(out.places.begin(), out.places.end());
    std::reverse(out.choices.begin(), out.choices.end());
    return out;
  }

  const Model& model_;
  const TaskTable& task_;
  std::uint64_t places_;
  std::vector<Met> met_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;
};

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

template <class Model>
std::optional<SearchAnswer> search(const Model& model, const TaskTable& task, std::size_t limit,
                                   const std::stop_token& stop) {
  if (!model.is_deterministic())
    throw std::invalid_argument("a search for a route needs a deterministic model");
  if (task.initial() == TaskTable::lost) return SearchAnswer{};
  const std::uint32_t first = task.next(task.initial(), model.initial_letter()).target;
  if (first == TaskTable::lost) return SearchAnswer{};
  if (uniform_cost(model)) return BreadthFirst<Model>(model, task).run(first, limit, stop);
  return Dijkstra<Model>(model, task).run(first, limit, stop);
}

template <class Model>
ltl::Trace word_of(const Model& model, const ChoiceRoute& route) {
  std::vector<ltl::Letter> letters{model.letters()[model.initial_letter()]};
  for (std::size_t i = 0; i < route.choices.size(); ++i) {
    const auto target = target_of(model, route.places[i], route.choices[i]);
    if (target.place != route.places[i + 1])
      throw std::logic_error("a route that takes a step it cannot take");
    letters.push_back(model.letters()[target.letter]);
  }
  return ltl::Trace(std::move(letters));
}

template std::optional<double> uniform_cost(const Mdp&);
template std::optional<double> uniform_cost(const GridWorld&);
template std::optional<SearchAnswer> search(const Mdp&, const TaskTable&, std::size_t,
                                            const std::stop_token&);
template std::optional<SearchAnswer> search(const GridWorld&, const TaskTable&, std::size_t,
                                            const std::stop_token&);
template ltl::Trace word_of(const Mdp&, const ChoiceRoute&);
template ltl::Trace word_of(const GridWorld&, const ChoiceRoute&);

}  // namespace waymark::plan
