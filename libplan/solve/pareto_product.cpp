#include "libplan/solve/pareto_product.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "libltl/text/parse.hpp"
#include "libplan/product/task_table.hpp"
#include "libplan/solve/task_automaton.hpp"

namespace waymark::plan {
namespace {

constexpr std::uint32_t formula_holds = UINT32_MAX;  // the formula holds

class ParetoBuilder {
 public:
  ParetoBuilder(const Mdp& model, const std::vector<Objective>& objectives, const ltl::Limits& limits)
      : model_(model), objectives_(objectives), limits_(limits) {}

  std::optional<ParetoProduct> build() {
    for (const Objective& objective : objectives_)
      if (!tabulate(objective)) return std::nullopt;
    ltl::Vocabulary vocabulary;
    for (std::size_t i = 0; i < objectives_.size(); ++i) vocabulary.add("goal " + std::to_string(i));
    MdpBuilder builder(vocabulary);
    out_.rewards.resize(objectives_.size());
    Pair begin{model_.initial(), {}};
    for (const auto& table : tables_) begin.memory.push_back(table ? first(*table) : 0);
    number(begin);
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
      if (limits_.stop.stop_requested()) return std::nullopt;
      add(builder, i);
    }
    const LetterId letter = this->letter(builder, pairs_[0]);
    out_.mdp = std::move(builder).build(0, letter);
    return std::move(out_);
  }

 private:
  struct Pair {
    std::uint32_t state;
    std::vector<std::uint32_t> memory;
    bool operator<(const Pair& o) const { return std::tie(state, memory) < std::tie(o.state, o.memory); }
  };

  // A formula that a finite prefix makes true, or its negation.
  bool tabulate(const Objective& objective) {
    tables_.emplace_back();
    out_.complemented.push_back(false);
    if (objective.formula.empty()) return true;
    ltl::Arena arena(model_.letters().vocabulary());
    ltl::Formula f = ltl::parse(objective.formula, arena);
    if (!is_finite_task(f, CaseTask::Logic::Ltl)) {
      f = ltl::negate(f);
      out_.complemented.back() = true;
    }
    if (!is_finite_task(f, CaseTask::Logic::Ltl))
      throw std::invalid_argument("no finite prefix decides the objective " + objective.formula);
    const auto automaton = task_automaton(f, CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability, limits_);
    if (!automaton) return false;
    tables_.back().emplace(std::get<automata::Dfa>(*automaton), model_.letters());
    return true;
  }

  std::uint32_t step(const TaskTable& table, std::uint32_t q, LetterId letter) const {
    if (q == formula_holds || q == TaskTable::trap) return q;
    const std::uint32_t next = table.next(q, letter).target;
    return next != TaskTable::trap && table.is_goal(next) ? formula_holds : next;
  }
  std::uint32_t first(const TaskTable& table) const {
    if (table.initial_states().empty()) return TaskTable::trap;
    const std::uint32_t q = table.initial_states()[0];
    return table.is_goal(q) ? formula_holds : step(table, q, model_.initial_letter());
  }

  std::uint32_t number(const Pair& pair) {
    const auto [at, fresh] = numbers_.try_emplace(pair, static_cast<std::uint32_t>(pairs_.size()));
    if (fresh) pairs_.push_back(pair);
    return at->second;
  }
  LetterId letter(MdpBuilder& builder, const Pair& pair) const {
    ltl::Letter out;
    for (std::uint32_t i = 0; i < pair.memory.size(); ++i)
      if (tables_[i] && pair.memory[i] == formula_holds) out.insert(ltl::Proposition{i});
    return builder.letter(out);
  }

  // A prefix that decides a formula earns 1 once; what the first letter decides is added by the caller.
  void add(MdpBuilder& builder, std::uint32_t number_of_pair) {
    const Pair pair = pairs_[number_of_pair];  // a copy: more join
    builder.add_state();
    out_.first.push_back(static_cast<std::uint32_t>(out_.rewards[0].size()));
    out_.origin.push_back(pair.state);
    std::string memory;
    for (std::size_t i = 0; i < pair.memory.size(); ++i)
      if (tables_[i])
        memory += (memory.empty() ? "" : ",") + (pair.memory[i] == formula_holds     ? std::string("yes")
                                                 : pair.memory[i] == TaskTable::trap ? std::string("no")
                                                                                     : std::to_string(pair.memory[i]));
    out_.memory.push_back(memory);
    for (std::uint32_t k = 0; k < model_.choices(pair.state); ++k) {
      builder.add_choice(model_.action(pair.state, k), 0);
      std::vector<double> earned(objectives_.size(), 0);
      std::map<std::uint32_t, double> outcomes;
      for (const ModelOutcome& o : model_.outcomes(pair.state, k)) {
        Pair next{o.target, pair.memory};
        for (std::size_t i = 0; i < tables_.size(); ++i) {
          if (!tables_[i]) continue;
          next.memory[i] = step(*tables_[i], pair.memory[i], o.letter);
          if (next.memory[i] == formula_holds && pair.memory[i] != formula_holds) earned[i] += o.probability;
        }
        outcomes[number(next)] += o.probability;
      }
      for (const auto& [target, probability] : outcomes)
        builder.add_outcome(target, letter(builder, pairs_[target]), std::min(1.0, probability));
      for (std::size_t i = 0; i < objectives_.size(); ++i) {
        if (objectives_[i].costs != nullptr) earned[i] = objectives_[i].costs->cost(pair.state, k);
        out_.rewards[i].push_back(objectives_[i].greatest != out_.complemented[i] ? earned[i] : -earned[i]);
      }
    }
  }

  const Mdp& model_;
  const std::vector<Objective>& objectives_;
  const ltl::Limits& limits_;
  std::vector<std::optional<TaskTable>> tables_;  // by objective
  std::map<Pair, std::uint32_t> numbers_;
  std::vector<Pair> pairs_;
  ParetoProduct out_;
};

// Keeps what can end almost surely, and finds choices that do. [BK08, Alg. 45]
void keep_what_ends(EndingQuotient& quotient) {
  const auto states = static_cast<std::uint32_t>(quotient.choices.size());
  std::vector<bool> kept(states, true);
  const auto usable = [&](const EndingQuotient::Choice& c) {
    return std::all_of(c.outcomes.begin(), c.outcomes.end(), [&](const auto& o) { return kept[o.first]; });
  };
  for (bool changed = true; changed;) {
    std::vector<bool> ends(states, false);
    quotient.proper.assign(states, UINT32_MAX);
    for (bool more = true; more;) {
      more = false;
      for (std::uint32_t i = 0; i < states; ++i) {
        if (ends[i] || !kept[i]) continue;
        for (std::uint32_t k = 0; k < quotient.choices[i].size() && !ends[i]; ++k) {
          const EndingQuotient::Choice& c = quotient.choices[i][k];
          const bool nearer =
              c.ends || std::any_of(c.outcomes.begin(), c.outcomes.end(), [&](const auto& o) { return ends[o.first]; });
          if (!nearer || !usable(c)) continue;
          ends[i] = more = true;
          quotient.proper[i] = k;
        }
      }
    }
    changed = ends != kept;
    kept = ends;
  }
  for (std::uint32_t i = 0; i < states; ++i) {
    std::vector<EndingQuotient::Choice> still;
    const std::uint32_t proper = quotient.proper[i];
    for (std::uint32_t k = 0; kept[i] && k < quotient.choices[i].size(); ++k) {
      if (!usable(quotient.choices[i][k])) continue;
      if (k == proper) quotient.proper[i] = static_cast<std::uint32_t>(still.size());
      still.push_back(quotient.choices[i][k]);
    }
    quotient.choices[i] = std::move(still);
  }
}

}  // namespace

std::optional<ParetoProduct> pareto_product(const Mdp& model, const std::vector<Objective>& objectives,
                                            const ltl::Limits& limits) {
  return ParetoBuilder(model, objectives, limits).build();
}

bool earns_for_ever(const ParetoProduct& product, const std::vector<Objective>& objectives, std::size_t objective) {
  if (objectives[objective].costs == nullptr || !objectives[objective].greatest) return false;
  const EndComponents components = end_components_of(product.mdp);
  for (std::uint32_t s = 0; s < product.mdp.states(); ++s)
    for (std::uint32_t k = 0; k < product.mdp.choices(s); ++k)
      if (product.rewards[objective][product.first[s] + k] > 0 && !leaves(product.mdp, s, k, components)) return true;
  return false;
}

EndingQuotient ending_quotient(const ParetoProduct& product) {
  EndingQuotient out;
  const auto states = static_cast<std::uint32_t>(product.mdp.states());
  std::vector<bool> free(product.rewards[0].size(), true);
  for (const std::vector<double>& rewards : product.rewards)
    for (std::size_t c = 0; c < rewards.size(); ++c) free[c] = free[c] && rewards[c] == 0;
  out.free =
      end_components_of(product.mdp, [&](std::uint32_t s, std::uint32_t k) { return free[product.first[s] + k]; });
  out.of.assign(states, UINT32_MAX);
  std::vector<std::uint32_t> of_component(out.free.count, UINT32_MAX);
  for (std::uint32_t s = 0; s < states; ++s) {
    const std::uint32_t c = out.free.of[s];
    std::uint32_t at = c == EndComponents::none ? UINT32_MAX : of_component[c];
    if (at == UINT32_MAX) {
      at = static_cast<std::uint32_t>(out.choices.size());
      out.choices.emplace_back();
      if (c != EndComponents::none) {
        of_component[c] = at;
        out.choices[at].push_back({s, 0, true});
      }
    }
    out.of[s] = at;
  }
  for (std::uint32_t s = 0; s < states; ++s)
    for (std::uint32_t k = 0; k < product.mdp.choices(s); ++k) {
      if (free[product.first[s] + k] && !leaves(product.mdp, s, k, out.free)) continue;
      EndingQuotient::Choice& made = out.choices[out.of[s]].emplace_back(EndingQuotient::Choice{s, k});
      for (const ModelOutcome& o : product.mdp.outcomes(s, k))
        made.outcomes.emplace_back(out.of[o.target], o.probability);
    }
  out.start = out.of[0];
  keep_what_ends(out);
  return out;
}

}  // namespace waymark::plan
