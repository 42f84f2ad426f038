// The fewest conjuncts to drop from a conjunction that cannot be satisfied, and a smallest set that cannot hold
// together. Minimum violation planning [TRCK13] with equal priorities, over top-level conjuncts.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/word.hpp"
#include "libplan/world/letters.hpp"

namespace waymark::plan {

struct Violation {                     // why a conjunction cannot be satisfied
  std::vector<ltl::Formula> conflict;  // cannot be met together; any one less can
  std::vector<ltl::Formula>
      dropped;  // fewest conjuncts without which the rest can be met; empty when there are none to keep
};

// For a formula that is not possible. Asks about every set of dropped conjuncts in the order of its size up to
// most_sets of them, then only drops one after the other, those of the conflicts: still enough, perhaps not fewest.
constexpr std::size_t most_sets = 512;
Violation fewest_dropped(ltl::Formula f, const std::function<bool(ltl::Formula)>& is_possible);

// "no strategy is sure to satisfy F a and G !a together"; where it need not be sure: "has a chance to satisfy".
std::string in_words(const Violation& violation, bool must_be_sure);
// "F a and G !a together" behind other words.
std::string conflict_behind(std::string_view words, const Violation& violation);

// Propositions of the formulas that no letter within reach of the start carries, sorted.
template <class Model>
std::vector<std::string> never_seen(const Model& model, const std::vector<ltl::Formula>& formulas);

// The same, given what is seen.
std::vector<std::string> absent(const ltl::Letter& seen, const ltl::Vocabulary& vocabulary,
                                const std::vector<ltl::Formula>& formulas);

template <class Model>
std::vector<std::string> never_seen(const Model& model, const std::vector<ltl::Formula>& formulas) {
  std::vector<bool> reached(model.states(), false), read(model.letters().size(), false);
  std::vector<std::uint32_t> open{model.initial()};
  reached[model.initial()] = true;
  read[model.initial_letter().index] = true;
  while (!open.empty()) {
    const std::uint32_t s = open.back();
    open.pop_back();
    for (std::uint32_t k = 0; k < model.choices(s); ++k)
      model.for_each_outcome(s, k, [&](std::uint32_t t, LetterId letter, double) {
        read[letter.index] = true;
        if (!reached[t]) open.push_back(t);
        reached[t] = true;
      });
  }
  ltl::Letter seen;
  for (std::uint32_t i = 0; i < read.size(); ++i)
    if (read[i]) seen.insert_all(model.letters()[LetterId{i}]);
  return absent(seen, model.letters().vocabulary(), formulas);
}

}  // namespace waymark::plan
