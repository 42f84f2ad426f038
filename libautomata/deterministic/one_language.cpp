#include "libautomata/deterministic/one_language.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libautomata/bdd/pair_walk.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libltl/structure/random.hpp"

namespace waymark::automata {

namespace {

constexpr int sample_words = 32;

// By state, one bit a word vʷ, drawn from a fixed seed: is it accepted? States that differ have different languages.
std::vector<std::uint32_t> verdicts(const TransitionRelation& complete) {
  const Mtbdd& diagram = complete.diagram;
  Mtbdd::Variable variables = 0;
  for (Mtbdd::Node n : diagram.reachable(complete.roots)) variables = std::max(variables, diagram.variable(n) + 1);
  ltl::Random random(1);
  const auto states = static_cast<std::uint32_t>(complete.states());
  std::vector<std::uint32_t> out(states), to(states), seen(states), path;
  std::vector<Marks> met(states);  // from q to to[q], reading v
  std::vector<bool> letter(variables), known(states), accepted(states);
  for (int word = 0; word < sample_words; ++word) {
    for (std::uint32_t q = 0; q < states; ++q) to[q] = q;
    met.assign(states, {});
    for (int length = 1 + word % 4; length > 0; --length) {
      for (Mtbdd::Variable v = 0; v < variables; ++v) letter[v] = random.chance(0.5);
      for (std::uint32_t q = 0; q < states; ++q) {
        const auto at = diagram.evaluate(complete.roots[to[q]], [&](Mtbdd::Variable v) { return letter[v]; });
        const Branch& taken = complete.choices[Mtbdd::payload(at)].front();
        to[q] = taken.target;
        met[q] = met[q] | taken.marks;
      }
    }
    known.assign(states, false);
    for (std::uint32_t start = 0; start < states; ++start) {
      path.clear();
      std::uint32_t q = start;
      for (seen.assign(states, 0); !known[q] && seen[q] == 0; q = to[q]) {
        path.push_back(q);
        seen[q] = static_cast<std::uint32_t>(path.size());
      }
      if (!known[q]) {  // the end of the path is a cycle
        Marks for_ever;
        for (std::size_t i = seen[q] - 1; i < path.size(); ++i) for_ever = for_ever | met[path[i]];
        accepted[q] = complete.acceptance.condition.holds(for_ever);
      }
      for (std::uint32_t p : path) {
        known[p] = true;
        accepted[p] = accepted[q];
      }
    }
    for (std::uint32_t q = 0; q < states; ++q) out[q] = out[q] << 1U | (accepted[q] ? 1U : 0U);
  }
  return out;
}

// Pairs (q, r) that no sample word tells apart, and what they lead to: live when some word is accepted from one of
// them only.
class Differences {
 public:
  Differences(const TransitionRelation& complete, Budget& budget)
      : automaton_(complete),
        verdict_(verdicts(complete)),
        pairs_(complete.diagram, complete.diagram, budget),
        number_(complete.states() * complete.states(), none) {
    const std::uint32_t sets = complete.acceptance.sets;
    if (2 * sets > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    const auto states = static_cast<std::uint32_t>(complete.states());
    for (std::uint32_t q = 0; q < states; ++q)
      for (std::uint32_t r = q + 1; r < states; ++r)
        if (verdict_[q] == verdict_[r]) static_cast<void>(number(q, r));
    if (found_.empty()) return;
    std::vector<std::uint32_t> leads_apart;
    for (std::uint32_t i = 0; i < found_.size(); ++i) {  // the list doubles as the queue
      const auto [q, r] = found_[i];
      bool apart = false;
      pairs_.from(complete.roots[q], complete.roots[r], [&](std::uint32_t one, std::uint32_t other) {
        const Branch p = complete.choices[one].front(), s = complete.choices[other].front();
        if (p.target == s.target) return;
        if (verdict_[p.target] != verdict_[s.target])
          apart = true;
        else
          graph_.add(i, {number(p.target, s.target), p.marks | Marks::from_bits(s.marks.bits() << sets)});
      });
      if (apart) leads_apart.push_back(i);
    }
    settle(leads_apart);
  }
  bool differ(std::uint32_t q, std::uint32_t r) const {
    return verdict_[q] != verdict_[r] || live_[number_[place(q, r)]];
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  std::size_t place(std::uint32_t q, std::uint32_t r) const { return q * automaton_.states() + r; }
  std::uint32_t number(std::uint32_t q, std::uint32_t r) {
    std::uint32_t& known = number_[place(q, r)];
    if (known == none) {
      known = static_cast<std::uint32_t>(found_.size());
      found_.emplace_back(q, r);
      graph_.add_state();
    }
    return known;
  }
  void settle(const std::vector<std::uint32_t>& leads_apart) {
    const Condition& one = automaton_.acceptance.condition;
    const Condition other = one.shifted(automaton_.acceptance.sets);
    const Condition only_one =
        Condition::any_of({Condition::all_of({one, other.negated()}), Condition::all_of({one.negated(), other})});
    const LiveComponents found = live_components(graph_, only_one);
    live_ = found.live;
    for (std::uint32_t i : leads_apart) live_[i] = true;
    const Components& by = found.components;
    std::vector<bool> live(by.count);
    for (std::size_t i = 0; i < by.order.size();) {  // successors first
      const std::uint32_t c = by.of[by.order[i]];
      const std::size_t begin = i;
      for (; i < by.order.size() && by.of[by.order[i]] == c; ++i) {
        live[c] = live[c] || live_[by.order[i]];
        for (std::uint32_t j : graph_.successors(by.order[i])) live[c] = live[c] || live[by.of[j]];
      }
      for (std::size_t j = begin; j < i; ++j) live_[by.order[j]] = live[c];
    }
  }

  const TransitionRelation& automaton_;
  std::vector<std::uint32_t> verdict_;
  PairWalk pairs_;
  std::vector<std::uint32_t> number_;  // of pairs, by place
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found_;
  BranchGraph graph_;
  std::vector<bool> live_;
};

}  // namespace

std::vector<std::uint32_t> languages(const TransitionRelation& complete, Budget& budget) {
  const Differences differences(complete, budget);
  std::vector<std::uint32_t> first(complete.states());
  for (std::uint32_t q = 0; q < first.size(); ++q)
    for (first[q] = 0; first[q] < q; ++first[q])
      if (!differences.differ(first[q], q)) break;
  return first;
}

std::optional<TransitionRelation> one_component_each(const TransitionRelation& complete,
                                                     const std::vector<std::uint32_t>& language) {
  const Components found = components(BranchGraph(complete));
  std::vector<std::uint32_t> all(complete.states()), image(complete.states());
  std::iota(all.begin(), all.end(), 0U);
  image = all;
  for (std::uint32_t q : all)
    for (std::uint32_t r : all)
      if (found.of[r] < found.of[image[q]] && language[q] == language[r]) image[q] = r;
  if (image == all) return std::nullopt;
  TransitionRelation out = rebuild(complete, all, [&](std::uint32_t, std::span<const Branch> choice) {
    return std::vector<Branch>{{image[choice.front().target], choice.front().marks}};
  });
  out.initial = image[complete.initial];
  return out;
}

}  // namespace waymark::automata
