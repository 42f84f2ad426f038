#include "libplan/model/mdp.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace waymark::plan {

void Mdp::tabulate_predecessors() {
  std::vector<std::uint32_t> last_source(states(), UINT32_MAX);
  const auto for_each_pair = [&](auto&& visit) {  // (source, target), each once
    std::fill(last_source.begin(), last_source.end(), UINT32_MAX);
    for (std::uint32_t s = 0; s < states(); ++s)
      for (std::uint32_t o = choices_[first_choice_[s]].first_outcome; o < choices_[first_choice_[s + 1]].first_outcome;
           ++o) {
        const std::uint32_t target = outcomes_[o].target;
        if (last_source[target] == s) continue;
        last_source[target] = s;
        visit(s, target);
      }
  };
  first_predecessor_.assign(states() + 1, 0);
  for_each_pair([&](std::uint32_t, std::uint32_t target) { ++first_predecessor_[target + 1]; });
  for (std::uint32_t s = 0; s < states(); ++s) first_predecessor_[s + 1] += first_predecessor_[s];
  predecessors_.resize(first_predecessor_.back());
  std::vector<std::uint32_t> next(first_predecessor_.begin(), first_predecessor_.end() - 1);
  for_each_pair([&](std::uint32_t source, std::uint32_t target) { predecessors_[next[target]++] = source; });
}

MdpBuilder::MdpBuilder(ltl::Vocabulary vocabulary) { mdp_.letters_ = Letters(std::move(vocabulary)); }

std::uint32_t MdpBuilder::add_state(std::string_view name) {
  const auto state = static_cast<std::uint32_t>(mdp_.first_choice_.size());
  mdp_.first_choice_.push_back(static_cast<std::uint32_t>(mdp_.choices_.size()));
  if (!name.empty()) {
    mdp_.names_.resize(state);
    mdp_.names_.emplace_back(name);
  }
  return state;
}

std::uint32_t MdpBuilder::number_of(std::string_view action) {
  const auto [at, fresh] =
      action_numbers_.try_emplace(std::string(action), static_cast<std::uint32_t>(mdp_.actions_.size()));
  if (fresh) mdp_.actions_.emplace_back(action);
  return at->second;
}

void MdpBuilder::add_choice(std::string_view action, double cost) {
  mdp_.choices_.push_back({static_cast<std::uint32_t>(mdp_.outcomes_.size()), number_of(action), cost});
}

void MdpBuilder::add_taken_choice(std::string_view action, double cost, std::size_t outcomes) {
  mdp_.choices_.push_back({static_cast<std::uint32_t>(taken_), number_of(action), cost});
  taken_ += outcomes;
}

void MdpBuilder::add_outcome(std::uint32_t target, LetterId letter, double probability) {
  mdp_.outcomes_.push_back({target, letter, probability});
}

void MdpBuilder::check_choice(std::uint32_t state, std::uint32_t k) const {
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument("state " + std::to_string(state) + ": " + what);
  };
  double sum = 0;
  for (const ModelOutcome& o : mdp_.outcomes(state, k)) {
    if (o.target >= mdp_.states()) fail("there is no state " + std::to_string(o.target));
    if (!(o.probability > 0 && o.probability <= 1)) fail("a probability outside of (0, 1]");
    sum += o.probability;
  }
  if (!(std::abs(sum - 1) <= 1e-9)) fail("the probabilities of a choice do not add up to 1");
  if (!(mdp_.cost(state, k) >= 0 && mdp_.cost(state, k) <= most_cost)) fail("a cost outside of [0, 1e100]");
}

Mdp MdpBuilder::build(std::uint32_t initial, LetterId initial_letter) && {
  mdp_.initial_ = initial;
  mdp_.initial_letter_ = initial_letter;
  mdp_.first_choice_.push_back(static_cast<std::uint32_t>(mdp_.choices_.size()));
  mdp_.choices_.push_back({static_cast<std::uint32_t>(mdp_.outcomes_.size()), 0, 0});
  if (!mdp_.names_.empty()) mdp_.names_.resize(mdp_.states());
  if (initial >= mdp_.states()) throw std::invalid_argument("the initial state does not exist");
  for (std::uint32_t s = 0; s < mdp_.states(); ++s)
    for (std::uint32_t k = 0; k < mdp_.choices(s); ++k) check_choice(s, k);
  mdp_.tabulate_predecessors();
  return std::move(mdp_);
}

}  // namespace waymark::plan
