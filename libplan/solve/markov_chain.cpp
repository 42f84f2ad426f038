#include "libplan/solve/markov_chain.hpp"

namespace waymark::plan {

void MarkovChain::finish() {
  first_.push_back(static_cast<std::uint32_t>(outcomes_.size()));
  blocks_ = {0, states()};
  first_source_.assign(states() + 1, 0);
  for (const Outcome& o : outcomes_)
    if (o.target != trap) ++first_source_[o.target + 1];
  for (std::uint32_t i = 0; i < states(); ++i) first_source_[i + 1] += first_source_[i];
  sources_.resize(first_source_.back());
  std::vector<std::uint32_t> next(first_source_.begin(), first_source_.end() - 1);
  for (std::uint32_t i = 0; i < states(); ++i)
    for (std::uint32_t o = first_[i]; o < first_[i + 1]; ++o)
      if (outcomes_[o].target != trap) sources_[next[outcomes_[o].target]++] = i;
}

}  // namespace waymark::plan
