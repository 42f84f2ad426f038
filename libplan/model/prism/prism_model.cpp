#include "libplan/model/prism/prism_model.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "libplan/model/prism/prism_states.hpp"

namespace waymark::plan {
namespace {

using Command = PrismProgram::Command;

// The commands of all modules that take a step together, with the place of each in its module.
using Step = std::vector<const Command*>;

class Explorer {
 public:
  Explorer(const PrismProgram& program, PrismExpressions& expressions, const ModelText& text, const PrismView& view,
           const ltl::Limits& limits)
      : program_(program),
        expressions_(expressions),
        text_(text),
        view_(view),
        limits_(limits),
        states_(program.variables) {
    for (std::size_t m = 0; m < program.modules.size(); ++m) place(m);
    for (const PrismProgram::Module& module : program.modules)
      for (const Command& command : module.commands)
        for (const PrismProgram::Update& update : command.updates)
          for (const PrismProgram::Assignment& a : update.assignments) rounds_.insert(a.round);
    if (view.rewards && !view.state_rewards_only) step_reward_ = program.rewards[*view.rewards].step;
  }

  Mdp explore() {
    for (const PrismProgram::Label& l : view_.labels) vocabulary_.add(l.name);
    states_.add(start());
    MdpBuilder builder(vocabulary_);
    PrismValues values;
    for (std::uint32_t s = 0; s < states_.size(); ++s) {
      if (limits_.stop.stop_requested()) throw ReadingStopped{};
      if (states_.size() > limits_.states) text_.fail(first_place(), "more states than the limit");
      states_.read(s, values);
      builder.add_state(show(values));
      add_choices(builder, s, values);
    }
    const LetterId initial = letter(builder, 0);
    return std::move(builder).build(0, initial);
  }

 private:
  struct Outcome {
    std::uint32_t target;
    double probability;
  };
  struct Choice {
    std::string action;
    double cost = 0;
    std::vector<Outcome> outcomes;
  };
  struct Lead {  // the other modules that must take part, each with its action
    const std::string* action;
    std::vector<std::pair<std::size_t, std::string>> others;
  };
  struct Placed {  // a command, and the steps that it leads
    const Command* command;
    std::vector<Lead> leads;
  };

  void place(std::size_t m) {
    const PrismProgram::Module& module = program_.modules[m];
    auto& by_location = commands_.emplace_back();
    const bool one = !module.location;
    by_location.resize(one ? 1 : static_cast<std::size_t>(program_.variables[*module.location].to) + 1);
    for (const Command& command : module.commands)
      by_location[one ? 0 : command.location].push_back(
          {&command, program_.synchronisations ? leads(*program_.synchronisations, m, command) : leads(m, command)});
  }
  const std::vector<Placed>& commands(std::size_t m, const PrismValues& values) const {
    const std::optional<std::uint32_t>& variable = program_.modules[m].location;
    return commands_[m][variable ? static_cast<std::size_t>(values[*variable]) : 0];
  }

  // An action of several modules is led by the first that has it.
  std::vector<Lead> leads(std::size_t module, const Command& command) const {
    Lead made{&command.action, {}};
    if (command.action.empty()) return {made};
    for (std::size_t m = 0; m < program_.modules.size(); ++m) {
      if (m == module || !program_.modules[m].has(command.action)) continue;
      if (m < module) return {};
      made.others.emplace_back(m, command.action);
    }
    return {made};
  }
  static std::vector<Lead> leads(const std::vector<PrismProgram::Synchronisation>& all, std::size_t module,
                                 const Command& command) {
    if (command.action.empty()) return {{&command.action, {}}};
    std::vector<Lead> out;
    for (const PrismProgram::Synchronisation& one : all)
      if (one.each[0] == std::pair{module, command.action})
        out.push_back({&one.result, {one.each.begin() + 1, one.each.end()}});
    return out;
  }

  // The values with which a run begins: the only ones that satisfy init … endinit, or the first of each variable.
  PrismValues start() {
    PrismValues values;
    for (const PrismProgram::Variable& v : program_.variables)
      values.push_back(program_.start && !v.fixed ? v.from : v.first);
    if (!program_.start) return values;
    const ltl::Span where = expressions_.where(*program_.start);
    std::optional<PrismValues> found;
    for (std::size_t tried = 0;; ++tried) {
      if (tried == most_tried) text_.fail(where, "more than a million values to try for the start");
      if (tried % 1024 == 0 && limits_.stop.stop_requested()) throw ReadingStopped{};
      expressions_.next_state();
      if (expressions_.value(*program_.start, values) != 0) {
        if (found) text_.fail(where, "several initial states: models with one are read");
        found = values;
      }
      std::size_t v = 0;
      while (v < values.size() && (program_.variables[v].fixed || values[v] == program_.variables[v].to)) {
        if (!program_.variables[v].fixed) values[v] = program_.variables[v].from;
        ++v;
      }
      if (v == values.size()) break;
      ++values[v];
    }
    if (!found) text_.fail(where, "no state satisfies this");
    return *found;
  }

  // Of the first variable; a program without variables has one state.
  ltl::Span first_place() const { return program_.variables.empty() ? ltl::Span{} : program_.variables[0].where; }

  std::string show(const PrismValues& values) const {
    if (program_.variables.empty()) return "()";
    std::string out;
    for (std::size_t v = 0; v < program_.variables.size(); ++v)
      out += (v == 0 ? "" : ",") + std::to_string(static_cast<std::int64_t>(values[v]));
    return out;
  }

  LetterId letter(MdpBuilder& builder, std::uint32_t s) {
    PrismValues values;
    while (letters_.size() <= s) {
      states_.read(static_cast<std::uint32_t>(letters_.size()), values);
      expressions_.next_state();
      ltl::Letter out;
      const ModelText& before = expressions_.speak_of(view_.labelled_by != nullptr ? *view_.labelled_by : text_);
      for (std::uint32_t i = 0; i < view_.labels.size(); ++i)
        if (expressions_.value(view_.labels[i].holds, values) != 0) out.insert(vocabulary_.add(view_.labels[i].name));
      expressions_.speak_of(before);
      letters_.push_back(builder.letter(out));
    }
    return letters_[s];
  }

  double cost(const std::string& action, const PrismValues& values, ltl::Span where) {
    if (!view_.rewards) return 1;
    double out = 0;
    for (const PrismProgram::Reward& r : program_.rewards[*view_.rewards].items)
      if ((!r.action || (*r.action == action && !view_.state_rewards_only)) && expressions_.value(r.guard, values) != 0)
        out += expressions_.value(r.value, values);
    if (!(out >= 0) || std::isinf(out))
      text_.fail(where, "a reward that is negative or infinite in state " + show(values));
    return out;
  }

  // The assignments of one round of an update, over the values before it.
  void assign(const PrismProgram::Update& update, std::uint32_t round, const PrismValues& values, PrismValues& out) {
    for (const PrismProgram::Assignment& a : update.assignments) {
      if (a.round != round) continue;
      const double value = expressions_.value(a.value, values);
      if (a.variable < program_.variables.size()) {
        const PrismProgram::Variable& v = program_.variables[a.variable];
        if (!(value >= v.from && value <= v.to))
          text_.fail(expressions_.where(a.value), "the variable leaves its range in state " + show(values));
      }
      if (program_.synchronisations) {
        if (assigned_.size() < out.size()) assigned_.resize(out.size());
        if (assigned_[a.variable] == now_) text_.fail(a.where, "two automata assign this variable at once");
        assigned_[a.variable] = now_;
      }
      out[a.variable] = value;
    }
  }

  // Round after round, each at once for all commands of the step: `next` begins as the values before.
  void assign(const Step& step, const std::vector<std::size_t>& at, PrismValues& next) {
    next.insert(next.end(), program_.transient.begin(), program_.transient.end());
    for (const std::uint32_t round : rounds_) {
      before_ = next;
      ++now_;
      if (rounds_.size() > 1) expressions_.next_state();
      for (std::size_t i = 0; i < step.size(); ++i) assign(step[i]->updates[at[i]], round, before_, next);
    }
    if (rounds_.size() > 1) expressions_.next_state();
  }

  double step_reward(const Step& step, const PrismValues& next) {
    if (!step_reward_) return 0;
    expressions_.next_state();
    const double out = expressions_.value(*step_reward_, next);
    expressions_.next_state();
    if (!(out >= 0) || std::isinf(out))
      text_.fail(step[0]->where, "a reward that is negative or infinite on a step into state " + show(next));
    return out;
  }

  // The chances of the updates of a command.
  std::vector<double> chances(const Command& command, const PrismValues& values) {
    std::vector<double> out;
    double sum = 0;
    for (const PrismProgram::Update& u : command.updates) {
      const double probability = u.probability ? expressions_.value(*u.probability, values) : 1;
      if (!(probability >= 0 && probability <= 1))
        text_.fail(expressions_.where(*u.probability), "a probability outside of [0, 1] in state " + show(values));
      sum += probability;
      out.push_back(probability);
    }
    if (!(std::abs(sum - 1) <= 1e-9))
      text_.fail(command.where, "the probabilities do not add up to 1 in state " + show(values));
    return out;
  }

  // `begin` a choice first; outcomes with one target are one.
  void begin() { ++choice_; }
  void add(std::vector<Outcome>& out, std::uint32_t target, double probability) {
    if (collected_.size() <= target) collected_.resize(std::max<std::size_t>(states_.size(), 2 * collected_.size()));
    Collected& collected = collected_[target];
    if (collected.choice != choice_) {
      collected = {choice_, out.size()};
      out.push_back({target, probability});
    } else {
      Outcome& same = out[collected.at];
      same.probability = std::min(1.0, same.probability + probability);
    }
  }

  // All combinations of one update of each command. Returns the expected reward of the step.
  double outcomes(const Step& step, const PrismValues& values, std::vector<Outcome>& out) {
    std::vector<std::vector<double>> each;
    for (const Command* command : step) each.push_back(chances(*command, values));
    std::vector<std::size_t> at(step.size(), 0);
    begin();
    double reward = 0;
    for (std::size_t tried = 0;; ++tried) {
      watch(tried, step[0]->where);
      double probability = 1;
      for (std::size_t i = 0; i < step.size(); ++i) probability *= each[i][at[i]];
      if (probability > 0) {
        PrismValues next = values;
        assign(step, at, next);
        reward += probability * step_reward(step, next);
        add(out, states_.add(next), probability);
      }
      std::size_t i = step.size();
      while (i > 0 && ++at[i - 1] == each[i - 1].size()) at[--i] = 0;
      if (i == 0) return reward;
    }
  }

  // Modules that meet in one action multiply.
  void watch(std::size_t tried, ltl::Span where) const {
    if (tried == most_combined) text_.fail(where, "modules meet here in more than 100,000 ways");
    if (tried % 1024 == 1023 && limits_.stop.stop_requested()) throw ReadingStopped{};
  }

  // Every way to combine the command with enabled ones of the other modules.
  template <class Visit>
  void for_each_step(const Command& command, const Lead& lead, const PrismValues& values, const Visit& visit) {
    std::vector<Step> enabled{{&command}};
    for (const auto& [module, action] : lead.others) {
      Step& other = enabled.emplace_back();
      for (const Placed& c : commands(module, values))
        if (c.command->action == action && expressions_.value(c.command->guard, values) != 0)
          other.push_back(c.command);
      if (other.empty()) return;
    }
    std::vector<std::size_t> at(enabled.size(), 0);
    for (std::size_t tried = 0;; ++tried) {
      watch(tried, command.where);
      Step step;
      for (std::size_t i = 0; i < enabled.size(); ++i) step.push_back(enabled[i][at[i]]);
      visit(step);
      std::size_t i = enabled.size();
      while (i > 0 && ++at[i - 1] == enabled[i - 1].size()) at[--i] = 0;
      if (i == 0) return;
    }
  }

  std::vector<Choice> choices(const PrismValues& values) {
    std::vector<Choice> out;
    expressions_.next_state();
    for (std::size_t m = 0; m < program_.modules.size(); ++m)
      for (const Placed& c : commands(m, values)) {
        if (c.leads.empty() || expressions_.value(c.command->guard, values) == 0) continue;
        for (const Lead& lead : c.leads)
          for_each_step(*c.command, lead, values, [&](const Step& step) {
            out.push_back({*lead.action, cost(*lead.action, values, c.command->where), {}});
            out.back().cost += outcomes(step, values, out.back().outcomes);
          });
      }
    return out;
  }

  // The only choice of a Markov chain: each of its commands with the same chance.
  void draw(std::vector<Choice>& choices) {
    if (choices.size() < 2) return;
    const auto chance = 1 / static_cast<double>(choices.size());
    Choice all;
    begin();
    for (const Choice& c : choices) {
      all.cost += chance * c.cost;
      for (const Outcome& o : c.outcomes) add(all.outcomes, o.target, chance * o.probability);
    }
    choices.assign(1, all);
  }

  void add_choices(MdpBuilder& builder, std::uint32_t s, const PrismValues& values) {
    std::vector<Choice> found = choices(values);
    if (!program_.is_mdp) draw(found);
    if (found.empty()) found.push_back({"stay", cost("stay", values, first_place()), {{s, 1}}});
    for (const Choice& choice : found) {
      builder.add_choice(choice.action, choice.cost);
      for (const Outcome& o : choice.outcomes) builder.add_outcome(o.target, letter(builder, o.target), o.probability);
    }
  }

  struct Collected {
    std::uint64_t choice = 0;
    std::size_t at = 0;
  };
  static constexpr std::size_t most_tried = 1'000'000, most_combined = 100'000;

  const PrismProgram& program_;
  PrismExpressions& expressions_;
  const ModelText& text_;
  const PrismView& view_;
  const ltl::Limits& limits_;
  std::vector<std::vector<std::vector<Placed>>> commands_;  // by module and its location
  ltl::Vocabulary vocabulary_;
  PrismStates states_;
  std::set<std::uint32_t> rounds_;  // of all assignments
  std::optional<PrismProgram::Id> step_reward_;
  PrismValues before_;                   // a round
  std::uint64_t now_ = 0;                // the round that is made
  std::vector<std::uint64_t> assigned_;  // by variable: the last round that assigned it, where automata may share it
  std::uint64_t choice_ = 0;             // the one whose outcomes are collected
  std::vector<Collected> collected_;     // by target: where it stands among them
  std::vector<LetterId> letters_;        // by state, for those whose values were looked at
};

}  // namespace

Mdp explore(const PrismProgram& program, PrismExpressions& expressions, const ModelText& text, const PrismView& view,
            const ltl::Limits& limits) {
  return Explorer(program, expressions, text, view, limits).explore();
}

}  // namespace waymark::plan
