#include "libplan/model/prism/read_prism_explicit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <istream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/model/prism/explicit_lines.hpp"
#include "libplan/model/prism/explicit_rows.hpp"

namespace waymark::plan {
namespace {

struct PrismStreams {  // those that may be missing are nullptr then
  std::istream *transitions, *labels, *states, *state_rewards, *transition_rewards;
};

class ExplicitReader {
 public:
  ExplicitReader(const PrismStreams& files, std::string prefix) : files_(files), prefix_(std::move(prefix)) {}

  Mdp read() {
    read_transitions();
    read_labels();
    if (files_.states != nullptr) read_names();
    if (files_.state_rewards != nullptr) read_state_rewards();
    if (files_.transition_rewards != nullptr) read_transition_rewards();
    try {
      return build();
    } catch (const std::invalid_argument& error) {
      throw ltl::FormatError(prefix_ + ".tra", 0, 0, error.what());
    }
  }

 private:
  ExplicitLines lines(std::istream* in, const char* extension) const { return {*in, prefix_ + extension}; }

  void read_transitions() {
    ExplicitLines in = lines(files_.transitions, ".tra");
    if (!in.next()) in.fail("expected the numbers of states, choices and transitions");
    states_ = in.index();
    const std::uint32_t choices = in.index();
    if (in.at_end()) in.fail("two numbers: a Markov chain; what is read is an mdp (states, choices, transitions)");
    const std::uint32_t transitions = in.index();
    in.expect_end();
    if (states_ == 0) in.fail("a model without states");
    while (in.next()) {
      if (rows_.size() == transitions)
        in.fail("the first line promises " + std::to_string(transitions) + " transitions");
      ExplicitRow row;
      row.source = in.index_below(states_, "state");
      row.choice = in.index();
      row.target = in.index_below(states_, "state");
      row.probability = in.number();
      if (!in.at_end()) row.action = action(in.word());
      in.expect_end();
      rows_.add(row);
    }
    if (states_ / 2 > rows_.size() + 1)
      throw ltl::FormatError(prefix_ + ".tra", 1, 1,
                             "the first line promises " + std::to_string(states_) + " states, but " +
                                 std::to_string(rows_.size()) + " transitions reach fewer");
    check_promise("transitions", transitions, rows_.size());
    rows_.sort();
    check_promise("choices", choices, rows_.choices().size());
  }

  void check_promise(const char* what, std::size_t promised, std::size_t found) const {
    if (promised != found)
      throw ltl::FormatError(
          prefix_ + ".tra", 1, 1,
          "the first line promises " + std::to_string(promised) + ' ' + what + ", there are " + std::to_string(found));
  }

  std::uint32_t action(std::string_view name) {  // 0: none
    const auto found = action_numbers_.find(name);
    if (found != action_numbers_.end()) return found->second;
    actions_.emplace_back(name);
    return action_numbers_.emplace(name, static_cast<std::uint32_t>(actions_.size() - 1)).first->second;
  }

  void read_labels() {
    ExplicitLines in = lines(files_.labels, ".lab");
    if (!in.next()) in.fail(R"(expected the labels, such as 0="init" 1="a")");
    std::map<std::uint32_t, std::optional<ltl::Proposition>> labels;  // nullopt: init and deadlock
    std::optional<std::uint32_t> init;
    while (!in.at_end()) {
      const std::uint32_t number = in.index();
      in.expect('=');
      in.expect('"');
      const std::string_view name = in.until('"');
      if (name.empty()) in.fail("a label without a name");
      if (name == "init") init = number;
      const bool own = name == "init" || name == "deadlock";
      if (!labels.emplace(number, own ? std::nullopt : std::optional(vocabulary_.add(name))).second)
        in.fail("two labels have this number");
    }
    if (!init) in.fail("there is no label \"init\"");
    labels_.resize(states_);
    while (in.next()) {
      const std::uint32_t state = in.index_below(states_, "state");
      in.expect(':');
      while (!in.at_end()) {
        const std::uint32_t number = in.index();
        const auto label = labels.find(number);
        if (label == labels.end()) in.fail("there is no label " + std::to_string(number));
        if (label->second) labels_[state].insert(*label->second);
        if (number != *init) continue;
        if (initial_ && *initial_ != state) in.fail("a second initial state");
        initial_ = state;
      }
    }
    if (!initial_) in.fail("no state has the label \"init\"");
  }

  void read_names() {
    ExplicitLines in = lines(files_.states, ".sta");
    if (!in.next()) in.fail("expected the names of the variables, such as (x,y)");
    names_.resize(states_);
    std::set<std::uint32_t> named;
    while (in.next()) {
      const std::uint32_t state = in.index_below(states_, "state");
      in.expect(':');
      in.expect('(');
      names_[state] = in.until(')');
      in.expect_end();
      named.insert(state);
    }
    expect_together(in, named.size(), states_, "states");
  }

  // A file of another model, such as an older one that was left there, has other sizes.
  void expect_together(const ExplicitLines& in, std::size_t found, std::size_t expected, const char* what) const {
    if (found == expected) return;
    in.fail("this file and " + prefix_ + ".tra do not belong together: " + std::to_string(found) + ' ' + what +
            " here, and " + std::to_string(expected) + " there");
  }

  void read_state_rewards() {
    ExplicitLines in = lines(files_.state_rewards, ".srew");
    if (!in.next()) in.fail("expected the numbers of states and rewards");
    expect_together(in, in.index(), states_, "states");
    const std::uint32_t promised = in.index();
    in.expect_end();
    state_rewards_.resize(states_);
    std::size_t found = 0;
    for (; in.next(); ++found) {
      const std::uint32_t state = in.index_below(states_, "state");
      state_rewards_[state] += in.number();
      in.expect_end();
    }
    expect_rewards(in, promised, found);
  }

  static void expect_rewards(const ExplicitLines& in, std::size_t promised, std::size_t found) {
    if (promised != found)
      in.fail("the first line promises " + std::to_string(promised) + " rewards, there are " + std::to_string(found));
  }

  void read_transition_rewards() {
    ExplicitLines in = lines(files_.transition_rewards, ".trew");
    if (!in.next()) in.fail("expected the numbers of states, choices and rewards");
    expect_together(in, in.index(), states_, "states");
    expect_together(in, in.index(), rows_.choices().size(), "choices");
    const std::uint32_t promised = in.index();
    in.expect_end();
    std::size_t found = 0;
    for (; in.next(); ++found) {
      const std::uint32_t state = in.index_below(states_, "state"), choice = in.index();
      const std::uint32_t target = in.index_below(states_, "state");
      const double reward = in.number();
      if (!has_transition(state, choice, target))
        in.fail("a reward of a transition that " + prefix_ + ".tra does not have");
      transition_rewards_[{state, choice, target}] += reward;
      in.expect_end();
    }
    expect_rewards(in, promised, found);
  }

  bool has_transition(std::uint32_t state, std::uint32_t choice, std::uint32_t target) const {
    const auto& all = rows_.choices();
    const auto at = std::lower_bound(all.begin(), all.end(), std::pair(state, choice),
                                     [](const auto& c, const auto& to) { return std::pair(c.source, c.number) < to; });
    if (at == all.end() || at->source != state || at->number != choice) return false;
    const auto outcomes = rows_.outcomes(static_cast<std::size_t>(at - all.begin()));
    return std::any_of(outcomes.begin(), outcomes.end(), [&](const ModelOutcome& o) { return o.target == target; });
  }

  bool has_rewards() const { return files_.state_rewards != nullptr || files_.transition_rewards != nullptr; }
  double state_reward(std::uint32_t s) const { return state_rewards_.empty() ? 0 : state_rewards_[s]; }

  // Of a state the reward of each of its choices; of transitions what is to be expected.
  double cost(std::size_t c) const {
    if (!has_rewards()) return 1;
    const ExplicitRows::Choice& choice = rows_.choices()[c];
    std::optional<double> all;  // equal for all targets: no rounding
    bool differ = false;
    double expected = 0;
    for (const ModelOutcome& o : rows_.outcomes(c)) {
      const auto found = transition_rewards_.find({choice.source, choice.number, o.target});
      const double reward = found == transition_rewards_.end() ? 0 : found->second;
      expected += o.probability * reward;
      differ = differ || (all && *all != reward);
      all = reward;
    }
    return state_reward(choice.source) + (differ ? expected : *all);
  }

  // Costs first: the outcomes are handed over, not copied.
  Mdp build() {
    std::vector<double> costs;
    for (std::size_t c = 0; has_rewards() && c < rows_.choices().size(); ++c) costs.push_back(cost(c));
    MdpBuilder builder(vocabulary_);
    std::vector<LetterId> letters;
    letters.reserve(states_);
    for (const ltl::Letter& label : labels_) letters.push_back(builder.letter(label));
    for (ModelOutcome& o : rows_.outcomes()) o.letter = letters[o.target];
    const std::size_t rows = rows_.size();
    const std::vector<ExplicitRows::Choice>& choices = rows_.choices();
    builder.take_outcomes(with_stays(letters));
    std::size_t c = 0;
    for (std::uint32_t s = 0; s < states_; ++s) {
      builder.add_state(names_.empty() ? std::string_view{} : std::string_view(names_[s]));
      if (c == choices.size() || choices[c].source != s)
        builder.add_taken_choice("stay", has_rewards() ? state_reward(s) : 1, 1);
      for (; c < choices.size() && choices[c].source == s; ++c) {
        const std::size_t end = c + 1 < choices.size() ? choices[c + 1].first_row : rows;
        builder.add_taken_choice(actions_[choices[c].action], costs.empty() ? 1 : costs[c], end - choices[c].first_row);
      }
    }
    return std::move(builder).build(*initial_, letters[*initial_]);
  }

  // The outcomes of all choices, with one for each state that has none: they are copied only where there is such.
  std::vector<ModelOutcome> with_stays(const std::vector<LetterId>& letters) {
    const std::vector<ExplicitRows::Choice>& choices = rows_.choices();
    std::size_t with_choices = 0;
    for (std::size_t c = 0; c < choices.size(); ++c)
      with_choices += c == 0 || choices[c - 1].source != choices[c].source ? 1 : 0;
    if (with_choices == states_) return std::move(rows_.outcomes());
    std::vector<ModelOutcome> out;
    out.reserve(rows_.size() + states_ - with_choices);
    std::size_t c = 0;
    for (std::uint32_t s = 0; s < states_; ++s) {
      if (c == choices.size() || choices[c].source != s) out.push_back({s, letters[s], 1});
      for (; c < choices.size() && choices[c].source == s; ++c)
        out.insert(out.end(), rows_.outcomes(c).begin(), rows_.outcomes(c).end());
    }
    return out;
  }

  const PrismStreams& files_;
  std::string prefix_;
  std::uint32_t states_ = 0;
  ExplicitRows rows_;
  std::vector<std::string> actions_{""};
  std::map<std::string, std::uint32_t, std::less<>> action_numbers_;  // in actions_
  ltl::Vocabulary vocabulary_;
  std::vector<ltl::Letter> labels_;  // by state
  std::optional<std::uint32_t> initial_;
  std::vector<std::string> names_;
  std::vector<double> state_rewards_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, double> transition_rewards_;
};

std::unique_ptr<std::istream> opened(const std::filesystem::path& file) {
  return std::make_unique<std::ifstream>(ltl::open_text(file));
}

}  // namespace

Mdp parse_prism_explicit(const PrismFiles& files, const std::string& prefix) {
  std::istringstream transitions(files.transitions), labels(files.labels);
  std::istringstream states(files.states.value_or("")), state_rewards(files.state_rewards.value_or("")),
      transition_rewards(files.transition_rewards.value_or(""));
  const PrismStreams streams{&transitions, &labels, files.states ? &states : nullptr,
                             files.state_rewards ? &state_rewards : nullptr,
                             files.transition_rewards ? &transition_rewards : nullptr};
  return ExplicitReader(streams, prefix).read();
}

Mdp read_prism_explicit(const std::filesystem::path& transitions) {
  const auto beside = [&](const char* extension) {
    return std::filesystem::path(transitions).replace_extension(extension);
  };
  const auto maybe = [&](const char* extension) {
    const std::filesystem::path file = beside(extension);
    return std::filesystem::exists(file) ? opened(file) : nullptr;
  };
  const auto rows = opened(transitions), labels = opened(beside(".lab"));
  const auto names = maybe(".sta"), on_states = maybe(".srew"), on_transitions = maybe(".trew");
  const PrismStreams streams{rows.get(), labels.get(), names.get(), on_states.get(), on_transitions.get()};
  return ExplicitReader(streams, beside("").string()).read();
}

}  // namespace waymark::plan
