#include "libplan/solve/state_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

namespace waymark::plan {
namespace {

struct Plain {  // the model as end_components asks for it
  struct State {
    std::uint32_t index;
  };
  using Compact = State;
  static constexpr std::uint32_t trap = UINT32_MAX;
  const Mdp& mdp;
  std::uint32_t states() const { return static_cast<std::uint32_t>(mdp.states()); }
  static State state(std::uint32_t i) { return {i}; }
  static State state(State s) { return s; }
  static State compact(State s) { return s; }
  std::uint32_t choices(State s) const { return mdp.choices(s.index); }
  template <class Visit>
  void for_each_outcome(State s, std::uint32_t k, Visit&& visit) const {
    for (const ModelOutcome& o : mdp.outcomes(s.index, k)) visit(o.target, o.probability, false);
  }
  template <class Visit>
  void for_each_state(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    for (std::uint32_t i = first; i < last; ++i) visit(State{i});
  }
  template <class Visit>
  void for_each_predecessor(State s, Visit&& visit) const {
    mdp.for_each_predecessor(s.index, [&](std::uint32_t source) { visit(State{source}); });
  }
};

std::uint32_t states_of(const Mdp& mdp) { return static_cast<std::uint32_t>(mdp.states()); }

}  // namespace

std::vector<LetterId> letters_of_states(const Mdp& mdp) {
  std::vector<LetterId> out(mdp.states(), mdp.initial_letter());
  for (std::uint32_t s = 0; s < states_of(mdp); ++s)
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k)
      for (const ModelOutcome& o : mdp.outcomes(s, k)) out[o.target] = o.letter;
  out[mdp.initial()] = mdp.initial_letter();
  return out;
}

Mdp beginning_at(const Mdp& mdp, std::uint32_t start, const std::vector<LetterId>& letters,
                 const std::vector<StateTruth>& more) {
  ltl::Vocabulary vocabulary = mdp.letters().vocabulary();
  std::vector<ltl::Proposition> added;
  for (const auto& [name, holds] : more) added.push_back(vocabulary.add(name));
  MdpBuilder builder(vocabulary);
  const auto letter = [&](std::uint32_t s) {
    ltl::Letter out = mdp.letters()[letters[s]];
    for (std::size_t i = 0; i < more.size(); ++i)
      if (more[i].second[s]) out.insert(added[i]);
    return builder.letter(out);
  };
  std::vector<std::uint32_t> number(mdp.states(), UINT32_MAX), order{start};
  number[start] = 0;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const std::uint32_t s = order[i];
    builder.add_state(mdp.name(s));
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      builder.add_choice(mdp.action(s, k), mdp.cost(s, k));
      for (const ModelOutcome& o : mdp.outcomes(s, k)) {
        if (number[o.target] == UINT32_MAX) {
          number[o.target] = static_cast<std::uint32_t>(order.size());
          order.push_back(o.target);
        }
        builder.add_outcome(number[o.target], letter(o.target), o.probability);
      }
    }
  }
  const LetterId first = letter(start);
  return std::move(builder).build(0, first);
}

std::optional<Mdp> spending(const Mdp& mdp, std::uint64_t budget, const std::string& within,
                            const ltl::Limits& limits) {
  const std::vector<LetterId> letters = letters_of_states(mdp);
  ltl::Vocabulary vocabulary = mdp.letters().vocabulary();
  const ltl::Proposition marker = vocabulary.add(within);
  MdpBuilder builder(vocabulary);
  std::vector<LetterId> marked;  // by state
  for (const LetterId letter : letters) {
    ltl::Letter out = mdp.letters()[letter];
    out.insert(marker);
    marked.push_back(builder.letter(out));
  }
  const LetterId none = builder.letter({});
  struct Place {
    std::uint32_t state;
    std::uint64_t spent;
  };
  constexpr std::uint64_t over = UINT64_MAX;
  std::vector<Place> places;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  const auto number = [&](std::uint32_t state, std::uint64_t spent) {
    const std::uint64_t key = spent == over ? over : spent * mdp.states() + state;
    const auto [at, fresh] = numbers.try_emplace(key, static_cast<std::uint32_t>(places.size()));
    if (fresh) places.push_back({state, spent});
    return at->second;
  };
  number(mdp.initial(), 0);
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (places.size() > limits.states || (i % 1024 == 0 && limits.stop.stop_requested())) return std::nullopt;
    const Place place = places[i];
    builder.add_state();
    if (place.spent == over) {
      builder.add_choice("stay", 0);
      builder.add_outcome(i, none);
      continue;
    }
    for (std::uint32_t k = 0; k < mdp.choices(place.state); ++k) {
      const double cost = mdp.cost(place.state, k);
      if (std::floor(cost) != cost) throw std::invalid_argument("a bound on rewards that are no whole numbers");
      const bool enough = cost <= static_cast<double>(budget - place.spent);
      builder.add_choice(mdp.action(place.state, k), 0);
      if (!enough) {
        builder.add_outcome(number(0, over), none);
        continue;
      }
      const std::uint64_t spent = place.spent + static_cast<std::uint64_t>(cost);
      for (const ModelOutcome& o : mdp.outcomes(place.state, k))
        builder.add_outcome(number(o.target, spent), marked[o.target], o.probability);
    }
  }
  const LetterId first = marked[mdp.initial()];
  return std::move(builder).build(0, first);
}

EndComponents end_components_of(const Mdp& mdp, const std::function<bool(std::uint32_t, std::uint32_t)>& usable) {
  const Plain plain{mdp};
  return end_components(plain, StateSet(mdp.states(), true),
                        [&](Plain::State s, std::uint32_t k) { return !usable || usable(s.index, k); });
}

bool leaves(const Mdp& mdp, std::uint32_t s, std::uint32_t k, const EndComponents& components) {
  return !stays(Plain{mdp}, Plain::State{s}, k, components);
}

Mdp ending_in_components(const Mdp& mdp, const EndComponents& components) {
  std::vector<std::uint32_t> number(mdp.states(), UINT32_MAX);
  std::vector<std::vector<std::uint32_t>> members;  // by new state; the component of the initial state first
  std::vector<std::uint32_t> of_component(components.count, UINT32_MAX);
  const auto place = [&](std::uint32_t s) {
    const std::uint32_t c = components.of[s];
    std::uint32_t at = c == EndComponents::none ? UINT32_MAX : of_component[c];
    if (at == UINT32_MAX) {
      at = static_cast<std::uint32_t>(members.size());
      members.emplace_back();
      if (c != EndComponents::none) of_component[c] = at;
    }
    members[at].push_back(s);
    number[s] = at;
  };
  place(mdp.initial());
  for (std::uint32_t s = 0; s < states_of(mdp); ++s)
    if (s != mdp.initial()) place(s);
  MdpBuilder builder(ltl::Vocabulary({"end"}));
  const LetterId none = builder.letter({}), end = builder.letter({ltl::Proposition{0}});
  const auto last = static_cast<std::uint32_t>(members.size());
  for (std::uint32_t i = 0; i < last; ++i) {
    builder.add_state();
    for (const std::uint32_t s : members[i])
      for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
        if (!leaves(mdp, s, k, components)) continue;
        builder.add_choice(mdp.action(s, k), mdp.cost(s, k));
        for (const ModelOutcome& o : mdp.outcomes(s, k)) builder.add_outcome(number[o.target], none, o.probability);
      }
    if (components.of[members[i][0]] == EndComponents::none) continue;
    builder.add_choice("end", 0);
    builder.add_outcome(last, end);
  }
  builder.add_state();
  builder.add_choice("end", 0);
  builder.add_outcome(last, end);
  return std::move(builder).build(0, none);
}

std::vector<bool> free_for_ever(const Mdp& mdp) {
  std::vector<bool> free(mdp.states(), true);
  const auto can_stay = [&](std::uint32_t s) {
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      const auto outcomes = mdp.outcomes(s, k);
      if (mdp.cost(s, k) == 0 &&
          std::all_of(outcomes.begin(), outcomes.end(), [&](const ModelOutcome& o) { return free[o.target]; }))
        return true;
    }
    return false;
  };
  std::vector<std::uint32_t> open;
  for (std::uint32_t s = 0; s < states_of(mdp); ++s) open.push_back(s);
  while (!open.empty()) {
    const std::uint32_t s = open.back();
    open.pop_back();
    if (!free[s] || can_stay(s)) continue;
    free[s] = false;
    mdp.for_each_predecessor(s, [&](std::uint32_t t) { open.push_back(t); });
  }
  return free;
}

}  // namespace waymark::plan
