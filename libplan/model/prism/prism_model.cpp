#include "libplan/model/prism/prism_model.hpp"

#include <algorithm>
#include <cmath>

#include "libplan/model/prism/prism_states.hpp"

namespace waymark::plan {
namespace {

using Command = PrismProgram::Command;

// The commands of all modules that take a step together, with the place of each in its module.
using Step = std::vector<const Command*>;

class Explorer {
 public:
  Explorer(const PrismProgram& program, PrismExpressions& expressions, const PrismTokens& tokens, const PrismView& view,
           const ltl::Limits& limits)
      : program_(program),
        expressions_(expressions),
        tokens_(tokens),
        view_(view),
        limits_(limits),
        states_(program.variables) {
    for (std::size_t m = 0; m < program.modules.size(); ++m)
      for (const Command& command : program.modules[m].commands) lead(m, command);
  }

  Mdp explore() {
    for (const PrismProgram::Label& l : view_.labels) vocabulary_.add(l.name);
    states_.add(start());
    MdpBuilder builder(vocabulary_);
    PrismValues values;
    for (std::uint32_t s = 0; s < states_.size(); ++s) {
      if (limits_.stop.stop_requested()) throw ReadingStopped{};
      if (states_.size() > limits_.states) tokens_.fail(program_.variables[0].where, "more states than the limit");
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
  struct Lead {  // a command, and the other modules that must take part
    std::size_t module;
    const Command* command;
    std::vector<std::size_t> others;
  };

  // An action of several modules is led by the first that has it.
  void lead(std::size_t module, const Command& command) {
    Lead& made = leads_.emplace_back(Lead{module, &command, {}});
    if (command.action.empty()) return;
    for (std::size_t m = 0; m < program_.modules.size(); ++m) {
      if (m == module || !program_.modules[m].has(command.action)) continue;
      if (m < module) {
        leads_.pop_back();
        return;
      }
      made.others.push_back(m);
    }
  }

  // The values with which a run begins: the only ones that satisfy init … endinit, or the first of each variable.
  PrismValues start() {
    PrismValues values;
    for (const PrismProgram::Variable& v : program_.variables) values.push_back(program_.start ? v.from : v.first);
    if (!program_.start) return values;
    const ltl::Span where = expressions_.where(*program_.start);
    std::optional<PrismValues> found;
    for (std::size_t tried = 0;; ++tried) {
      if (tried == most_tried) tokens_.fail(where, "more than a million values to try for the start");
      if (tried % 1024 == 0 && limits_.stop.stop_requested()) throw ReadingStopped{};
      expressions_.next_state();
      if (expressions_.value(*program_.start, values) != 0) {
        if (found) tokens_.fail(where, "several initial states: models with one are read");
        found = values;
      }
      std::size_t v = 0;
      while (v < values.size() && values[v] == program_.variables[v].to) {
        values[v] = program_.variables[v].from;
        ++v;
      }
      if (v == values.size()) break;
      ++values[v];
    }
    if (!found) tokens_.fail(where, "no state satisfies this");
    return *found;
  }

  static std::string show(const PrismValues& values) {
    std::string out;
    for (double value : values) out += (out.empty() ? "" : ",") + std::to_string(static_cast<std::int64_t>(value));
    return out;
  }

  LetterId letter(MdpBuilder& builder, std::uint32_t s) {
    PrismValues values;
    while (letters_.size() <= s) {
      states_.read(static_cast<std::uint32_t>(letters_.size()), values);
      expressions_.next_state();
      ltl::Letter out;
      const PrismTokens& before = expressions_.speak_of(view_.labelled_by != nullptr ? *view_.labelled_by : tokens_);
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
      tokens_.fail(where, "a reward that is negative or infinite in state " + show(values));
    return out;
  }

  void assign(const PrismProgram::Update& update, const PrismValues& values, PrismValues& out) {
    for (const PrismProgram::Assignment& a : update.assignments) {
      const PrismProgram::Variable& v = program_.variables[a.variable];
      const double value = expressions_.value(a.value, values);
      if (!(value >= v.from && value <= v.to))
        tokens_.fail(expressions_.where(a.value), "the variable leaves its range in state " + show(values));
      out[a.variable] = value;
    }
  }

  // The chances of the updates of a command.
  std::vector<double> chances(const Command& command, const PrismValues& values) {
    std::vector<double> out;
    double sum = 0;
    for (const PrismProgram::Update& u : command.updates) {
      const double probability = u.probability ? expressions_.value(*u.probability, values) : 1;
      if (!(probability >= 0 && probability <= 1))
        tokens_.fail(expressions_.where(*u.probability), "a probability outside of [0, 1] in state " + show(values));
      sum += probability;
      out.push_back(probability);
    }
    if (!(std::abs(sum - 1) <= 1e-9))
      tokens_.fail(command.where, "the probabilities do not add up to 1 in state " + show(values));
    return out;
  }

  // `begin` a choice first; outcomes with one target are one.
  void begin() { ++choice_; }
  void add(std::vector<Outcome>& out, std::uint32_t target, double probability) {
    if (placed_.size() <= target) placed_.resize(std::max<std::size_t>(states_.size(), 2 * placed_.size()));
    Placed& placed = placed_[target];
    if (placed.choice != choice_) {
      placed = {choice_, out.size()};
      out.push_back({target, probability});
    } else {
      Outcome& same = out[placed.at];
      same.probability = std::min(1.0, same.probability + probability);
    }
  }

  // All combinations of one update of each command; all expressions are over the values before.
  void outcomes(const Step& step, const PrismValues& values, std::vector<Outcome>& out) {
    std::vector<std::vector<double>> each;
    for (const Command* command : step) each.push_back(chances(*command, values));
    std::vector<std::size_t> at(step.size(), 0);
    begin();
    for (std::size_t tried = 0;; ++tried) {
      watch(tried, step[0]->where);
      double probability = 1;
      for (std::size_t i = 0; i < step.size(); ++i) probability *= each[i][at[i]];
      if (probability > 0) {
        PrismValues next = values;
        for (std::size_t i = 0; i < step.size(); ++i) assign(step[i]->updates[at[i]], values, next);
        add(out, states_.add(next), probability);
      }
      std::size_t i = step.size();
      while (i > 0 && ++at[i - 1] == each[i - 1].size()) at[--i] = 0;
      if (i == 0) return;
    }
  }

  // Modules that meet in one action multiply.
  void watch(std::size_t tried, ltl::Span where) const {
    if (tried == most_combined) tokens_.fail(where, "modules meet here in more than 100,000 ways");
    if (tried % 1024 == 1023 && limits_.stop.stop_requested()) throw ReadingStopped{};
  }

  // Every way to combine the command with enabled ones of the other modules.
  template <class Visit>
  void for_each_step(const Lead& lead, const PrismValues& values, const Visit& visit) {
    std::vector<Step> enabled{{lead.command}};
    for (const std::size_t m : lead.others) {
      Step& other = enabled.emplace_back();
      for (const Command& c : program_.modules[m].commands)
        if (c.action == lead.command->action && expressions_.value(c.guard, values) != 0) other.push_back(&c);
      if (other.empty()) return;
    }
    std::vector<std::size_t> at(enabled.size(), 0);
    for (std::size_t tried = 0;; ++tried) {
      watch(tried, lead.command->where);
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
    for (const Lead& lead : leads_) {
      if (expressions_.value(lead.command->guard, values) == 0) continue;
      for_each_step(lead, values, [&](const Step& step) {
        const std::string& action = lead.command->action;
        out.push_back({action, cost(action, values, lead.command->where), {}});
        outcomes(step, values, out.back().outcomes);
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
    if (found.empty()) found.push_back({"stay", cost("stay", values, program_.variables[0].where), {{s, 1}}});
    for (const Choice& choice : found) {
      builder.add_choice(choice.action, choice.cost);
      for (const Outcome& o : choice.outcomes) builder.add_outcome(o.target, letter(builder, o.target), o.probability);
    }
  }

  struct Placed {
    std::uint64_t choice = 0;
    std::size_t at = 0;
  };
  static constexpr std::size_t most_tried = 1'000'000, most_combined = 100'000;

  const PrismProgram& program_;
  PrismExpressions& expressions_;
  const PrismTokens& tokens_;
  const PrismView& view_;
  const ltl::Limits& limits_;
  std::vector<Lead> leads_;
  ltl::Vocabulary vocabulary_;
  PrismStates states_;
  std::uint64_t choice_ = 0;       // the one whose outcomes are collected
  std::vector<Placed> placed_;     // by target: where it stands among them
  std::vector<LetterId> letters_;  // by state, for those whose values were looked at
};

}  // namespace

Mdp explore(const PrismProgram& program, PrismExpressions& expressions, const PrismTokens& tokens,
            const PrismView& view, const ltl::Limits& limits) {
  return Explorer(program, expressions, tokens, view, limits).explore();
}

}  // namespace waymark::plan
