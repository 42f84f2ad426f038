#include "libplan/model/prism/read_prism_explicit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"

namespace waymark::plan {
namespace {

// One file, read line by line and word by word.
class Lines {
 public:
  Lines(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  bool next() {  // the next line that is neither blank nor a comment
    while (end_ < text_.size() || line_ == 0) {
      begin_ = at_ = line_ == 0 ? 0 : end_ + 1;
      if (begin_ >= text_.size()) return false;
      end_ = std::min(text_.find('\n', begin_), text_.size());
      ++line_;
      skip_blanks();
      if (at_ < end_ && text_[at_] != '#') return true;
    }
    return false;
  }
  bool at_end() {
    skip_blanks();
    return at_ == end_;
  }
  std::string_view word() {  // up to a blank
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < end_ && !is_blank(text_[at_])) ++at_;
    if (begin == at_) fail("expected more on this line");
    return text_.substr(begin, at_ - begin);
  }
  std::uint32_t index() {
    skip_blanks();
    std::uint32_t out = 0;
    const auto [rest, error] = std::from_chars(text_.data() + at_, text_.data() + end_, out);
    if (error != std::errc()) fail("expected a whole number from 0 on");
    at_ = static_cast<std::size_t>(rest - text_.data());
    return out;
  }
  std::uint32_t index_below(std::size_t bound, const char* what) {
    skip_blanks();
    const std::size_t begin = at_;
    const std::uint32_t out = index();
    if (out >= bound) {
      at_ = begin;
      fail(std::string("there is no ") + what + ' ' + std::to_string(out));
    }
    return out;
  }
  double number() {
    skip_blanks();
    const std::size_t begin = at_;
    double out = 0;
    const auto [rest, error] = std::from_chars(text_.data() + at_, text_.data() + end_, out);
    at_ = static_cast<std::size_t>(rest - text_.data());
    if (error == std::errc() && std::isfinite(out) && (at_ == end_ || is_blank(text_[at_]))) return out;
    at_ = begin;
    fail("expected a number");
  }
  void expect(char c) {
    skip_blanks();
    if (at_ == end_ || text_[at_] != c) fail(std::string("expected '") + c + '\'');
    ++at_;
  }
  std::string_view until(char c) {
    const std::size_t begin = at_;
    at_ = text_.find(c, at_);
    if (at_ >= end_) {
      at_ = begin;
      fail(std::string("expected '") + c + "' later on this line");
    }
    return text_.substr(begin, at_++ - begin);
  }
  void expect_end() {
    if (!at_end()) fail("expected the end of the line");
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw ltl::FormatError(source_, std::max<std::size_t>(line_, 1),
                           ltl::utf8_length(text_.substr(begin_, at_ - begin_)) + 1, message);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  void skip_blanks() {
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
  }
  std::string_view text_;
  std::string source_;
  std::size_t line_ = 0, begin_ = 0, at_ = 0, end_ = 0;
};

struct Row {
  std::uint32_t source = 0, choice = 0, target = 0;
  double probability = 0;
  std::string_view action;
};

class ExplicitReader {
 public:
  ExplicitReader(const PrismFiles& files, std::string prefix) : files_(files), prefix_(std::move(prefix)) {}

  Mdp read() {
    read_transitions();
    read_labels();
    if (files_.states) read_names();
    if (files_.state_rewards) read_state_rewards();
    if (files_.transition_rewards) read_transition_rewards();
    try {
      return build();
    } catch (const std::invalid_argument& error) {
      throw ltl::FormatError(prefix_ + ".tra", 0, 0, error.what());
    }
  }

 private:
  Lines lines(const std::string& text, const char* extension) const { return {text, prefix_ + extension}; }

  void read_transitions() {
    Lines in = lines(files_.transitions, ".tra");
    if (!in.next()) in.fail("expected the numbers of states, choices and transitions");
    states_ = in.index();
    const std::uint32_t choices = in.index();
    if (in.at_end()) in.fail("two numbers: a Markov chain; what is read is an mdp (states, choices, transitions)");
    const std::uint32_t transitions = in.index();
    in.expect_end();
    if (states_ == 0) in.fail("a model without states");
    while (in.next()) {
      Row& row = rows_.emplace_back();
      row.source = in.index_below(states_, "state");
      row.choice = in.index();
      row.target = in.index_below(states_, "state");
      row.probability = in.number();
      if (!in.at_end()) row.action = in.word();
      in.expect_end();
    }
    if (states_ / 2 > rows_.size() + 1)
      throw ltl::FormatError(prefix_ + ".tra", 1, 1,
                             "the first line promises " + std::to_string(states_) + " states, but " +
                                 std::to_string(rows_.size()) + " transitions reach fewer");
    std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) { return place(a) < place(b); });
    std::size_t found = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) found += starts_choice(i) ? 1 : 0;
    check_promise("transitions", transitions, rows_.size());
    check_promise("choices", choices, found);
  }

  void check_promise(const char* what, std::size_t promised, std::size_t found) const {
    if (promised != found)
      throw ltl::FormatError(
          prefix_ + ".tra", 1, 1,
          "the first line promises " + std::to_string(promised) + ' ' + what + ", there are " + std::to_string(found));
  }

  static std::pair<std::uint32_t, std::uint32_t> place(const Row& row) { return {row.source, row.choice}; }
  bool starts_choice(std::size_t i) const { return i == 0 || place(rows_[i - 1]) != place(rows_[i]); }

  void read_labels() {
    Lines in = lines(files_.labels, ".lab");
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
    Lines in = lines(*files_.states, ".sta");
    if (!in.next()) in.fail("expected the names of the variables, such as (x,y)");
    names_.resize(states_);
    while (in.next()) {
      const std::uint32_t state = in.index_below(states_, "state");
      in.expect(':');
      in.expect('(');
      names_[state] = in.until(')');
      in.expect_end();
    }
  }

  void read_state_rewards() {
    Lines in = lines(*files_.state_rewards, ".srew");
    if (!in.next()) in.fail("expected the numbers of states and rewards");
    if (in.index() != states_) in.fail("a file about another number of states");
    state_rewards_.resize(states_);
    while (in.next()) {
      const std::uint32_t state = in.index_below(states_, "state");
      state_rewards_[state] += in.number();
      in.expect_end();
    }
  }

  void read_transition_rewards() {
    Lines in = lines(*files_.transition_rewards, ".trew");
    if (!in.next()) in.fail("expected the numbers of states, choices and rewards");
    if (in.index() != states_) in.fail("a file about another number of states");
    while (in.next()) {
      const std::uint32_t state = in.index_below(states_, "state"), choice = in.index();
      const std::uint32_t target = in.index_below(states_, "state");
      transition_rewards_[{state, choice, target}] += in.number();
      in.expect_end();
    }
  }

  bool has_rewards() const { return files_.state_rewards || files_.transition_rewards; }
  double state_reward(std::uint32_t s) const { return state_rewards_.empty() ? 0 : state_rewards_[s]; }

  // Of a state the reward of each of its choices; of transitions what is to be expected.
  double cost(std::size_t first_row) const {
    if (!has_rewards()) return 1;
    const Row& first = rows_[first_row];
    std::optional<double> all;  // equal for all targets: no rounding
    bool differ = false;
    double expected = 0;
    for (std::size_t i = first_row; i < rows_.size() && place(rows_[i]) == place(first); ++i) {
      const auto found = transition_rewards_.find({first.source, first.choice, rows_[i].target});
      const double reward = found == transition_rewards_.end() ? 0 : found->second;
      expected += rows_[i].probability * reward;
      differ = differ || (all && *all != reward);
      all = reward;
    }
    return state_reward(first.source) + (differ ? expected : *all);
  }

  Mdp build() {
    MdpBuilder builder(vocabulary_);
    std::vector<LetterId> letters;
    for (const ltl::Letter& label : labels_) letters.push_back(builder.letter(label));
    std::size_t row = 0;
    for (std::uint32_t s = 0; s < states_; ++s) {
      builder.add_state(names_.empty() ? std::string_view{} : std::string_view(names_[s]));
      if (row == rows_.size() || rows_[row].source != s) {
        builder.add_choice("stay", has_rewards() ? state_reward(s) : 1);
        builder.add_outcome(s, letters[s]);
      }
      for (; row < rows_.size() && rows_[row].source == s; ++row) {
        if (starts_choice(row)) builder.add_choice(rows_[row].action, cost(row));
        builder.add_outcome(rows_[row].target, letters[rows_[row].target], rows_[row].probability);
      }
    }
    return std::move(builder).build(*initial_, letters[*initial_]);
  }

  const PrismFiles& files_;
  std::string prefix_;
  std::uint32_t states_ = 0;
  std::vector<Row> rows_;  // by source and choice
  ltl::Vocabulary vocabulary_;
  std::vector<ltl::Letter> labels_;  // by state
  std::optional<std::uint32_t> initial_;
  std::vector<std::string> names_;
  std::vector<double> state_rewards_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, double> transition_rewards_;
};

std::optional<std::string> contents(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  return ltl::read_text(file);
}

}  // namespace

Mdp parse_prism_explicit(const PrismFiles& files, const std::string& prefix) {
  return ExplicitReader(files, prefix).read();
}

Mdp read_prism_explicit(const std::filesystem::path& transitions) {
  const auto beside = [&](const char* extension) {
    return std::filesystem::path(transitions).replace_extension(extension);
  };
  const PrismFiles files{ltl::read_text(transitions), ltl::read_text(beside(".lab")), contents(beside(".sta")),
                         contents(beside(".srew")), contents(beside(".trew"))};
  return parse_prism_explicit(files, beside("").string());
}

}  // namespace waymark::plan
