// The greatest probability with which a strategy satisfies a parity condition in a small Markov decision process:
// accepting end components by definition, then value iteration. [BK08, Sec. 10.6]
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/parity.hpp"
#include "libautomata/graph/scc.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"
#include "libltl/structure/random.hpp"

namespace waymark::automata::referee {

struct Outcome {
  double probability;
  std::uint32_t target, colour;
};
using Action = std::vector<Outcome>;  // less than one in sum: the rest is lost
struct Decisions {
  std::vector<std::vector<Action>> actions;  // by state
};

// The states of maximal end components whose actions are among those allowed: 0 outside, else a number from 1.
inline std::vector<std::uint32_t> end_components(const Decisions& mdp, std::vector<std::vector<bool>> allowed) {
  struct Graph {
    std::vector<std::vector<std::uint32_t>> targets;
    std::size_t size() const { return targets.size(); }
    const std::vector<std::uint32_t>& successors(std::uint32_t s) const { return targets[s]; }
  };
  while (true) {
    Graph graph{std::vector<std::vector<std::uint32_t>>(mdp.actions.size())};
    for (std::uint32_t s = 0; s < graph.size(); ++s)
      for (std::size_t a = 0; a < mdp.actions[s].size(); ++a)
        if (allowed[s][a])
          for (const Outcome& o : mdp.actions[s][a]) graph.targets[s].push_back(o.target);
    const Components found = components(graph);
    bool changed = false;
    for (std::uint32_t s = 0; s < graph.size(); ++s)
      for (std::size_t a = 0; a < mdp.actions[s].size(); ++a) {
        if (!allowed[s][a]) continue;
        double stays = 0;
        for (const Outcome& o : mdp.actions[s][a])
          if (found.of[o.target] == found.of[s]) stays += o.probability;
        if (stays > 1 - 1e-9) continue;
        allowed[s][a] = false;
        changed = true;
      }
    if (changed) continue;
    std::vector<std::uint32_t> out(graph.size(), 0);
    for (std::uint32_t s = 0; s < graph.size(); ++s)
      if (std::find(allowed[s].begin(), allowed[s].end(), true) != allowed[s].end()) out[s] = found.of[s] + 1;
    return out;
  }
}

// States from which the least colour that is met for ever can be made even almost surely, inside one component.
inline std::vector<bool> winning(const Decisions& mdp, std::uint32_t colours) {
  std::vector<bool> out(mdp.actions.size(), false);
  for (std::uint32_t least = 0; least <= colours; least += 2) {
    std::vector<std::vector<bool>> allowed;
    for (const auto& actions : mdp.actions) {
      std::vector<bool>& of_state = allowed.emplace_back();
      for (const Action& action : actions)
        of_state.push_back(
            std::all_of(action.begin(), action.end(), [&](const Outcome& o) { return o.colour >= least; }));
    }
    const std::vector<std::uint32_t> component = end_components(mdp, allowed);
    std::vector<bool> meets(mdp.actions.size() + 2, false);
    for (std::uint32_t s = 0; s < mdp.actions.size(); ++s)
      for (std::size_t a = 0; a < mdp.actions[s].size(); ++a) {
        if (!allowed[s][a] || component[s] == 0) continue;
        double stays = 0;
        bool here = false;
        for (const Outcome& o : mdp.actions[s][a]) {
          if (component[o.target] == component[s]) stays += o.probability;
          here = here || o.colour == least;
        }
        if (here && stays > 1 - 1e-9) meets[component[s]] = true;
      }
    for (std::uint32_t s = 0; s < mdp.actions.size(); ++s)
      out[s] = out[s] || (component[s] != 0 && meets[component[s]]);
  }
  return out;
}

inline double greatest_probability(const Decisions& mdp, std::uint32_t initial, std::uint32_t colours) {
  const std::vector<bool> won = winning(mdp, colours);
  std::vector<double> value(mdp.actions.size(), 0);
  for (int sweep = 0; sweep < 20'000; ++sweep) {
    double change = 0;
    for (std::uint32_t s = 0; s < value.size(); ++s) {
      double best = won[s] ? 1 : 0;
      for (const Action& action : mdp.actions[s]) {
        double sum = 0;
        for (const Outcome& o : action) sum += o.probability * value[o.target];
        best = std::max(best, sum);
      }
      change = std::max(change, best - value[s]);
      value[s] = best;
    }
    if (change < 1e-13) break;
  }
  return value[initial];
}

// Letters on states; every action leads to one or two states.
struct World {
  struct Move {
    double probability;
    std::uint32_t target;
  };
  std::vector<ltl::Letter> label;
  std::vector<std::vector<std::vector<Move>>> actions;
};

inline World random_world(ltl::Random& random, std::uint32_t states, const std::vector<ltl::Proposition>& atoms) {
  World out;
  for (std::uint32_t s = 0; s < states; ++s) {
    ltl::Letter& letter = out.label.emplace_back();
    for (ltl::Proposition p : atoms)
      if (random.below(2) == 0) letter.insert(p);
    auto& actions = out.actions.emplace_back();
    for (std::size_t a = 0; a < 1 + random.below(2); ++a) {
      const auto first = static_cast<std::uint32_t>(random.below(states));
      const auto second = static_cast<std::uint32_t>(random.below(states));
      const double p = 0.25 * static_cast<double>(1 + random.below(4));
      auto& moves = actions.emplace_back();
      if (p == 1 || first == second)
        moves.push_back({1, first});
      else
        moves = {{p, first}, {1 - p, second}};
    }
  }
  return out;
}

// The product, letters read on arrival and the first one at the start. `step` gives what an automaton state does on a
// letter, if anything; `jumps` where it may go at no cost.
template <class Step, class Jumps>
double greatest_probability(const World& world, std::uint32_t automaton_initial, std::uint32_t colours,
                            const Step& step, const Jumps& jumps) {
  using Place = std::pair<std::uint32_t, std::uint32_t>;  // world, automaton before its next letter
  std::map<Place, std::uint32_t> number;
  std::vector<Place> places;
  const auto name = [&](Place place) {
    const auto [at, fresh] = number.try_emplace(place, static_cast<std::uint32_t>(places.size()));
    if (fresh) places.push_back(place);
    return at->second;
  };
  // A place (s, q): q has not read the letter of s yet. An action reads it and moves on.
  Decisions mdp;
  name({0, automaton_initial});
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [s, q] = places[i];
    std::vector<Action> actions;
    if (const auto next = step(q, world.label[s])) {
      for (const auto& moves : world.actions[s]) {
        Action& action = actions.emplace_back();
        for (const World::Move& m : moves)
          action.push_back({m.probability, name({m.target, next->first}), next->second});
      }
    }
    for (std::uint32_t target : jumps(q)) actions.push_back({{1, name({s, target}), colours}});
    mdp.actions.push_back(std::move(actions));
  }
  return greatest_probability(mdp, 0, colours);
}

using Next = std::optional<std::pair<std::uint32_t, std::uint32_t>>;  // target, colour

inline std::optional<Branch> branch_on(const TransitionRelation& automaton, const std::vector<ltl::Proposition>& reads,
                                       std::uint32_t q, const ltl::Letter& letter) {
  const auto holds = [&](Mtbdd::Variable v) { return letter.contains(reads[v]); };
  const auto choice = automaton.choices[Mtbdd::payload(automaton.diagram.evaluate(automaton.roots[q], holds))];
  if (choice.empty()) return std::nullopt;
  return choice.front();
}

inline double greatest_probability(const World& world, const Dpa& dpa) {
  const TransitionRelation parity = min_even_parity(dpa.automaton().transitions());
  const auto step = [&](std::uint32_t q, const ltl::Letter& letter) {
    const auto b = branch_on(parity, dpa.automaton().reads(), q, letter);
    return b ? Next({b->target, colour_of(parity, b->marks)}) : Next();
  };
  return greatest_probability(world, parity.initial, parity.acceptance.sets, step,
                              [](std::uint32_t) { return std::vector<std::uint32_t>(); });
}

inline double greatest_probability(const World& world, const LimitDeterministic& ldba,
                                   const std::vector<ltl::Proposition>& reads) {
  const auto step = [&](std::uint32_t q, const ltl::Letter& letter) {
    const auto b = branch_on(ldba.automaton, reads, q, letter);
    return b ? Next({b->target, b->marks.empty() ? 1U : 0U}) : Next();
  };
  return greatest_probability(world, ldba.automaton.initial, 1, step, [&](std::uint32_t q) { return ldba.jumps[q]; });
}

inline double greatest_probability(const World& world, const MdpSafe& ldba) {
  const auto step = [&](std::uint32_t q, const ltl::Letter& letter) {
    const auto next = ldba.next(StateId{q}, letter);
    return next ? Next({next->target.index, next->accepting ? 0U : 1U}) : Next();
  };
  return greatest_probability(world, ldba.initial().index, 1, step, [&](std::uint32_t q) {
    std::vector<std::uint32_t> out;
    for (StateId target : ldba.jumps(StateId{q})) out.push_back(target.index);
    return out;
  });
}

}  // namespace waymark::automata::referee
