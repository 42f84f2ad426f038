#include "tools/walk_referee.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <variant>
#include <vector>

#include "libautomata/graph/scc.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libplan/product/buchi_product.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tools/claims.hpp"

namespace waymark::tools {
namespace {

using automata::Automaton;
using automata::Budget;
using automata::Marks;
using plan::MarkedEdge;
using plan::MarkedGraph;

MarkedGraph graph_of(const plan::PlanningCase& model, const Automaton& automaton, Budget& budget) {
  return std::visit([&](const auto& m) { return plan::compose(m, automaton, budget).graph; }, model.model);
}

// Every outcome a choice.
template <class Model>
plan::PlanningCase without_chance(const Model& model) {
  plan::MdpBuilder built(model.letters().vocabulary());
  const auto same = [&](plan::LetterId letter) { return built.letter(model.letters()[letter]); };
  for (std::uint32_t s = 0; s < model.states(); ++s) {
    built.add_state();
    for (std::uint32_t k = 0; k < model.choices(s); ++k)
      model.for_each_outcome(s, k, [&](std::uint32_t to, plan::LetterId letter, double) {
        built.add_choice("");
        built.add_outcome(to, same(letter));
      });
    if (model.choices(s) > 0) continue;
    built.add_choice("");
    built.add_outcome(s, same(model.initial_letter()));
  }
  return {"", std::move(built).build(model.initial(), same(model.initial_letter())), {}};
}

struct Targets {  // by vertex
  std::vector<std::vector<std::uint32_t>> next;
  std::size_t size() const { return next.size(); }
  const std::vector<std::uint32_t>& successors(std::uint32_t v) const { return next[v]; }
};

// Edges inside of components that have every mark.
class Fair {
 public:
  explicit Fair(const MarkedGraph& graph) {
    Targets targets{std::vector<std::vector<std::uint32_t>>(graph.vertices())};
    for (const MarkedEdge& e : graph.edges) targets.next[e.from].push_back(e.to);
    of_ = automata::components(targets).of;
    std::vector<Marks> marks(graph.vertices());
    std::vector<bool> has_edge(graph.vertices(), false);
    for (const MarkedEdge& e : graph.edges)
      if (of_[e.from] == of_[e.to]) marks[of_[e.from]] = marks[of_[e.from]] | e.marks, has_edge[of_[e.from]] = true;
    for (std::uint32_t c = 0; c < graph.vertices(); ++c) fair_.push_back(has_edge[c] && marks[c].includes(graph.all()));
  }
  bool any() const { return std::find(fair_.begin(), fair_.end(), true) != fair_.end(); }
  bool operator()(const MarkedEdge& e) const { return of_[e.from] == of_[e.to] && fair_[of_[e.from]]; }
  bool at(std::uint32_t v) const { return fair_[of_[v]]; }

 private:
  std::vector<std::uint32_t> of_;
  std::vector<bool> fair_;  // by component
};

using CostAt = std::pair<double, std::uint32_t>;
using Queue = std::priority_queue<CostAt, std::vector<CostAt>, std::greater<>>;

class Ranks {
 public:
  Ranks(const MarkedGraph& graph, Budget& budget) : graph_(graph), fair_(graph), budget_(budget) { distances(); }

  bool is_least(plan::LassoOrder order, const LassoRank& rank) {
    if (order == plan::LassoOrder::Mean) return is_least_mean(rank);
    const LassoRank best = least(order == plan::LassoOrder::Prefix);
    return is_close(best.first, rank.first) && is_close(best.then, rank.then);
  }

 private:
  LassoRank least(bool by_prefix) {
    LassoRank best{INFINITY, INFINITY};
    std::vector<CostAt> from;
    for (std::uint32_t v = 0; v < graph_.vertices(); ++v)
      if (fair_.at(v)) from.emplace_back(distance_[v], v);
    std::sort(from.begin(), from.end());
    for (const auto& [before, v] : from) {
      if (by_prefix && before > best.first) break;
      const double cycle = through(v);
      const LassoRank found = by_prefix ? LassoRank{before, cycle} : LassoRank{cycle, before};
      if (std::isfinite(cycle) && std::pair(found.first, found.then) < std::pair(best.first, best.then)) best = found;
    }
    return best;
  }

  void distances() {
    distance_.assign(graph_.vertices(), INFINITY);
    Queue open;
    for (const std::uint32_t v : graph_.starts) open.emplace(distance_[v] = 0, v);
    while (!open.empty()) {
      const auto [cost, v] = open.top();
      open.pop();
      if (cost > distance_[v]) continue;
      for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e)
        if (const MarkedEdge& edge = graph_.edges[e]; cost + edge.cost < distance_[edge.to])
          open.emplace(distance_[edge.to] = cost + edge.cost, edge.to);
    }
  }

  std::uint32_t layered(std::uint32_t v, Marks met) const {
    return (v << graph_.sets) | static_cast<std::uint32_t>((met & graph_.all()).bits());
  }
  Marks met_at(std::uint32_t node) const { return Marks::from_bits(node & graph_.all().bits()); }

  // The least cost of a closed walk from v that has every mark.
  double through(std::uint32_t v) {
    std::map<std::uint32_t, double> cost;
    Queue open;
    const auto relax_from = [&](std::uint32_t at, Marks met, double here) {
      for (std::uint32_t e = graph_.first[at]; e < graph_.first[at + 1]; ++e) {
        const MarkedEdge& edge = graph_.edges[e];
        if (!fair_(edge)) continue;
        const std::uint32_t to = layered(edge.to, met | edge.marks);
        const auto [known, fresh] = cost.emplace(to, INFINITY);
        if (here + edge.cost < known->second) open.emplace(known->second = here + edge.cost, to);
      }
    };
    relax_from(v, Marks(), 0);
    while (!open.empty()) {
      const auto [here, node] = open.top();
      open.pop();
      if (node == layered(v, graph_.all())) return here;
      if (here > cost[node]) continue;
      budget_.step();
      relax_from(node >> graph_.sets, met_at(node), here);
    }
    return INFINITY;
  }

  // ---- costs a round: one ends with the edge that has the last mark

  struct Step {
    std::uint32_t from, to;
    double cost;
    bool ends_round;
  };

  // A ratio next below the least leaves no negative cycle [DBR67].
  bool is_least_mean(const LassoRank& rank) {
    for (std::uint32_t v = 0; v < graph_.vertices(); ++v)
      for (std::uint32_t bits = 0; fair_.at(v) && bits < std::uint32_t{1} << graph_.sets; ++bits) add_steps(v, bits);
    return !has_negative_cycle(rank.first * (1 - 1e-10)) && is_close(rank.then, nearest_on_cycle_of(rank.first));
  }

  void add_steps(std::uint32_t v, std::uint32_t bits) {
    for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e) {
      const MarkedEdge& edge = graph_.edges[e];
      if (!fair_(edge)) continue;
      const Marks met = Marks::from_bits(bits) | edge.marks;
      const bool ends = met.includes(graph_.all());
      steps_.push_back({layered(v, Marks::from_bits(bits)), layered(edge.to, ends ? Marks() : met), edge.cost, ends});
    }
  }

  bool has_negative_cycle(double ratio) {
    const std::size_t nodes = std::size_t{graph_.vertices()} << graph_.sets;
    potential_.assign(nodes, 0);
    for (std::size_t round = 0; round <= nodes; ++round) {
      bool changed = false;
      budget_.step(steps_.size());
      for (const Step& s : steps_) {
        const double there = potential_[s.from] + s.cost - (s.ends_round ? ratio : 0);
        if (there < potential_[s.to] - 1e-13 * std::max(1.0, ratio)) potential_[s.to] = there, changed = true;
      }
      if (!changed) return false;
    }
    return true;
  }

  // The cycles of the least ratio are those of steps that are tight under its potentials.
  double nearest_on_cycle_of(double ratio) const {
    Targets tight{std::vector<std::vector<std::uint32_t>>(potential_.size())};
    const auto is_tight = [&](const Step& s) {
      return potential_[s.from] + s.cost - (s.ends_round ? ratio : 0) <= potential_[s.to] + 1e-6 * std::max(1.0, ratio);
    };
    for (const Step& s : steps_)
      if (is_tight(s)) tight.next[s.from].push_back(s.to);
    const automata::Components parts = automata::components(tight);
    std::vector<bool> wanted(potential_.size(), false);
    for (const Step& s : steps_)
      if (is_tight(s) && s.ends_round && parts.of[s.from] == parts.of[s.to]) wanted[parts.of[s.from]] = true;
    double nearest = INFINITY;
    for (std::uint32_t node = 0; node < potential_.size(); ++node)
      if (wanted[parts.of[node]]) nearest = std::min(nearest, distance_[node >> graph_.sets]);
    return nearest;
  }

  const MarkedGraph& graph_;
  Fair fair_;
  Budget& budget_;
  std::vector<double> distance_, potential_;
  std::vector<Step> steps_;
};

constexpr std::uint32_t most_marks = 8;

Budget budget_of(const ltl::Limits& limits) { return {100 * limits.states, limits.states, limits.stop}; }

// The most rounds to each (state, marks met in the open round), a letter after the other.
using Rounds = std::map<std::pair<std::uint32_t, Marks>, std::uint64_t>;
Rounds after(const Rounds& before, const Automaton& automaton, const ltl::Letter& letter) {
  const Marks all = Marks::first(automaton.acceptance().sets);
  Rounds out;
  for (const auto& [at, rounds] : before)
    for (const automata::Branch& b : automaton.next(automata::StateId{at.first}, letter)) {
      const Marks met = at.second | b.marks;
      const bool ends = met.includes(all);
      std::uint64_t& there = out[{b.target, ends ? Marks() : met}];
      there = std::max(there, rounds + (ends ? 1 : 0));
    }
  return out;
}

}  // namespace

std::optional<bool> has_walk(const plan::PlanningCase& model, ltl::Formula formula, const ltl::Limits& limits) {
  if (ltl::has_past(formula)) return std::nullopt;
  Budget budget = budget_of(limits);
  try {
    const std::vector<ltl::Proposition> reads = ltl::propositions(formula);
    const Automaton automaton(formula.arena().vocabulary(), reads,
                              automata::tableau(ltl::nnf(formula), reads, budget).automaton);
    const bool chance = std::visit([](const auto& m) { return !m.is_deterministic(); }, model.model);
    if (!chance) return Fair(graph_of(model, automaton, budget)).any();
    const plan::PlanningCase free = std::visit([](const auto& m) { return without_chance(m); }, model.model);
    return Fair(graph_of(free, automaton, budget)).any();
  } catch (const Budget::Exceeded&) {
    return std::nullopt;
  }
}

std::optional<bool> comes_first(const plan::PlanningCase& model, ltl::Formula formula, plan::LassoOrder order,
                                const LassoRank& rank, const ltl::Limits& limits) {
  const auto automaton = plan::lasso_automaton(formula, limits);
  if (!automaton || automaton->acceptance().sets > most_marks) return std::nullopt;
  Budget budget = budget_of(limits);
  try {
    const MarkedGraph graph = graph_of(model, *automaton, budget);
    return Ranks(graph, budget).is_least(order, rank);
  } catch (const Budget::Exceeded&) {
    return std::nullopt;
  }
}

std::optional<std::set<std::uint64_t>> rounds_on(const ltl::Lasso& word, ltl::Formula formula,
                                                 const ltl::Limits& limits) {
  const auto automaton = plan::lasso_automaton(formula, limits);
  if (!automaton || automaton->acceptance().sets > most_marks) return std::nullopt;
  const std::uint64_t all = Marks::first(automaton->acceptance().sets).bits();
  Rounds reached{{{automaton->initial().index, Marks()}, 0}};
  for (std::size_t i = 0; i < word.loop_start(); ++i) reached = after(reached, *automaton, word[i]);
  std::set<std::uint64_t> out;
  for (const auto& [at, rounds] : reached)
    for (std::uint64_t bits = 0; bits <= all; ++bits) {
      const Marks met = Marks::from_bits(bits);
      Rounds cycle{{{at.first, met}, 0}};
      for (std::size_t i = word.loop_start(); i < word.size(); ++i) cycle = after(cycle, *automaton, word[i]);
      for (const auto& [end, count] : cycle)
        if (end.first == at.first && (end.second == met || bits == 0)) out.insert(count);
    }
  return out;
}

}  // namespace waymark::tools
