#include "libplan/learn/tabular_product.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace waymark::plan {
namespace {

// The actions of the model, in the order of a state that offers most of them; where some state offers two of one name,
// by their place.
struct Actions {
  std::vector<std::string> names;
  bool by_place = false;
};

template <class Model>
Actions actions_of(const Model& model) {
  const auto states = static_cast<std::uint32_t>(model.states());
  std::uint32_t richest = 0;
  for (std::uint32_t s = 1; s < states; ++s)
    if (model.choices(s) > model.choices(richest)) richest = s;
  Actions actions;
  const auto add_those_of = [&](std::uint32_t s) {
    std::set<std::string_view> own;
    for (std::uint32_t k = 0; k < model.choices(s); ++k) {
      const std::string_view name = model.action(s, k);
      actions.by_place |= !own.insert(name).second;
      if (std::find(actions.names.begin(), actions.names.end(), name) == actions.names.end())
        actions.names.emplace_back(name);
    }
  };
  add_those_of(richest);
  for (std::uint32_t s = 0; s < states; ++s) add_those_of(s);
  if (!actions.by_place) return actions;
  actions.names.clear();
  for (std::uint32_t k = 0; k < model.choices(richest); ++k) actions.names.push_back(std::to_string(k));
  return actions;
}

// By action: the choice of state s that it is, or none.
template <class Model>
std::vector<std::uint32_t> choices_by_action(const Model& model, std::uint32_t s, const Actions& actions) {
  std::vector<std::uint32_t> choice(actions.names.size(), UINT32_MAX);
  for (std::uint32_t k = 0; k < model.choices(s); ++k) {
    const auto found = std::find(actions.names.begin(), actions.names.end(), model.action(s, k));
    choice[actions.by_place ? k : static_cast<std::size_t>(found - actions.names.begin())] = k;
  }
  return choice;
}

template <class Model>
void add_choice(TabularProduct& product, const Model& model, std::uint32_t s, std::uint32_t k) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> merged;  // (target, letter) → probability
  model.for_each_outcome(s, k, [&](std::uint32_t target, LetterId letter, double probability) {
    merged[{target, product.task.classes.of(letter)}] += probability;
  });
  double sum = 0;
  for (const auto& [outcome, probability] : merged)
    product.outcomes.push_back({outcome.first, outcome.second, sum += probability});
  product.outcomes.back().up_to = 1;
  product.cost.back() = model.cost(s, k);
}

template <class Model>
TabularProduct compose_model(const Model& model, TaskRows task) {
  if (model.states() * task.tasks > TabularProduct::max_states)
    throw std::length_error("the product is too large to be learnt in tables");
  TabularProduct product;
  product.task = std::move(task);
  product.positions = static_cast<std::uint32_t>(model.states());
  const Actions actions = actions_of(model);
  product.names = actions.names;
  product.actions = static_cast<std::uint32_t>(product.names.size());
  for (std::uint32_t s = 0; s < product.positions; ++s) {
    if (model.choices(s) == 0) throw std::invalid_argument("nothing can be done in state " + model.name(s));
    for (const std::uint32_t k : choices_by_action(model, s, actions)) {
      product.first.push_back(static_cast<std::uint32_t>(product.outcomes.size()));
      product.cost.push_back(0);
      if (k != UINT32_MAX) add_choice(product, model, s, k);
    }
  }
  product.first.push_back(static_cast<std::uint32_t>(product.outcomes.size()));
  const std::uint32_t first = product.task.classes.of(model.initial_letter());
  product.starts.push_back({product.state(model.initial(), product.task.after(product.task.initial, first)), 1});
  return product;
}

}  // namespace

bool TabularProduct::is_deterministic() const {
  for (std::size_t choice = 0; choice + 1 < first.size(); ++choice)
    if (first[choice + 1] - first[choice] > 1) return false;
  return true;
}

bool TabularProduct::is_over() const {
  return std::all_of(starts.begin(), starts.end(),
                     [&](const Start& start) { return ending(start.state) != Ending::Open; });
}

TabularProduct compose(const Mdp& model, TaskRows task) { return compose_model(model, std::move(task)); }
TabularProduct compose(const GridWorld& model, TaskRows task) { return compose_model(model, std::move(task)); }

TabularProduct tabulate(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                        const MapNoise& noise) {
  if (starts.empty()) throw std::invalid_argument("a product without a start");
  std::vector<TabularProduct::Start> all;
  TabularProduct product;
  for (const PoseId start : starts) {
    const Mdp model = mdp_of(map, start, noise);
    product = compose(model, tabulate(dfa, model.letters()));
    all.push_back({product.starts[0].state, 1.0 / static_cast<double>(starts.size())});
  }
  product.starts = std::move(all);
  return product;
}

}  // namespace waymark::plan
