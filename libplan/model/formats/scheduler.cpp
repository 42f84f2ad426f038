#include "libplan/model/formats/scheduler.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

std::optional<std::uint32_t> whole_number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

// Lines STATE=CHOICE, in older versions STATE:CHOICE. A state is a number or, as "(0,1)", its name; a choice is the
// name of an action, else a number.
class PrismScheduler {
 public:
  PrismScheduler(std::string_view source, const Mdp& model) : source_(source), model_(model) {
    for (std::uint32_t s = 0; s < model.states(); ++s) numbers_.emplace(model.name(s), s);
  }

  Scheduler read(std::string_view text) {
    Scheduler out;
    out.choices.resize(model_.states());
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = trimmed(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      ++line_;
      if (!line.empty() && line.front() != '#') add(line, out);
    }
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw ltl::FormatError(source_, line_, 0, message); }

  void add(std::string_view line, Scheduler& out) const {
    if (line.find('{', 1) != std::string_view::npos)
      fail("this scheduler has memory: compose the product, and schedule that");
    const std::size_t between = line.find_last_of("=:");
    if (between == std::string_view::npos) fail("expected STATE=ACTION");
    const std::string_view choice = trimmed(line.substr(between + 1));
    const std::uint32_t s = state(trimmed(line.substr(0, between)));
    if (choice == "?") return;  // PRISM does not know
    if (!out.choices[s].empty()) fail("a second choice for state " + std::to_string(s));
    out.choices[s].push_back({choice_of(s, choice), 1});
  }
  std::uint32_t state(std::string_view text) const {
    if (const auto found = numbers_.find(std::string(text)); found != numbers_.end() && !whole_number(text))
      return found->second;
    const auto number = whole_number(text);
    if (!number || *number >= model_.states()) fail("the model has no state '" + std::string(text) + "'");
    return *number;
  }
  std::uint32_t choice_of(std::uint32_t s, std::string_view text) const {
    for (std::uint32_t k = 0; k < model_.choices(s); ++k)
      if (model_.action(s, k) == text) return k;
    const auto number = whole_number(text);
    if (!number || *number >= model_.choices(s))
      fail("state " + std::to_string(s) + " has no choice '" + std::string(text) + "'");
    return *number;
  }

  std::string_view source_;
  const Mdp& model_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::size_t line_ = 0;
};

// [{"s": state, "c": [{"index": choice, "prob": p}, …]}, …], where choices are numbered through the whole model.
class StormScheduler {
 public:
  StormScheduler(std::string_view text, std::string_view source, const Mdp& model) : in_(text, source), model_(model) {
    for (std::uint32_t s = 0; s < model.states(); ++s) first_.push_back(first_.back() + model.choices(s));
  }

  Scheduler read() const {
    const JsonReader::Value document = in_.parse();
    Scheduler out;
    out.choices.resize(model_.states());
    for (std::size_t i = 0; i < document.size(); ++i) add(document[i], "[" + std::to_string(i) + "]", out);
    return out;
  }

 private:
  void add(const JsonReader::Value& entry, const std::string& path, Scheduler& out) const {
    const JsonReader::Value &state = in_.member(entry, path, "s"), &choices = in_.member(entry, path, "c");
    if (entry.contains("m")) in_.fail(path + ".m", "this scheduler has memory: compose the product, and schedule that");
    if (state.is_object()) in_.fail(path + ".s", "expected the number of a state (Storm's without --buildstateval)");
    const int s = in_.integer(state, path + ".s");
    if (s < 0 || static_cast<std::size_t>(s) >= model_.states()) in_.fail(path + ".s", "the model has no such state");
    if (choices.is_string()) return;  // "undefined"
    auto& chosen = out.choices[static_cast<std::size_t>(s)];
    if (!chosen.empty()) in_.fail(path + ".s", "a second choice for this state");
    double sum = 0;
    in_.each(entry, path, "c", [&](const JsonReader::Value& choice, const std::string& here) {
      const std::string at = here + ".index";
      const auto index = static_cast<std::int64_t>(in_.integer(in_.member(choice, here, "index"), at));
      const auto first = static_cast<std::int64_t>(first_[static_cast<std::size_t>(s)]);
      if (index < first || index >= static_cast<std::int64_t>(first_[static_cast<std::size_t>(s) + 1]))
        in_.fail(at, "this is no choice of state " + std::to_string(s));
      const auto k = static_cast<std::uint32_t>(index - first);
      if (std::any_of(chosen.begin(), chosen.end(), [&](const Scheduler::Choice& c) { return c.choice == k; }))
        in_.fail(at, "this choice stands here already");
      const double p = probability(in_.member(choice, here, "prob"), here + ".prob");
      if (p > 0) chosen.push_back({k, p});
      sum += p;
    });
    if (!(std::abs(sum - 1) <= 1e-9)) in_.fail(path + ".c", "the probabilities do not add up to 1");
  }
  double probability(const JsonReader::Value& value, const std::string& path) const {
    if (value.is_string()) {  // a fraction, of exact models
      const std::string text = value.get<std::string>();
      const std::size_t bar = text.find('/');
      const auto numerator = whole_number(std::string_view(text).substr(0, bar)),
                 denominator = bar == std::string::npos ? 1U : whole_number(std::string_view(text).substr(bar + 1));
      if (numerator && denominator && *denominator > 0 && *numerator <= *denominator)
        return static_cast<double>(*numerator) / *denominator;
      in_.fail(path, "expected a probability");
    }
    const double p = in_.number(value, path);
    if (!(p >= 0 && p <= 1)) in_.fail(path, "expected a probability");
    return p;
  }

  const JsonReader in_;
  const Mdp& model_;
  std::vector<std::size_t> first_{0};  // the number of a state's first choice
};

std::string prism_choice(const Mdp& model, std::uint32_t s, std::uint32_t chosen) {
  const std::string_view name = model.action(s, chosen);
  bool plain = !name.empty() && !whole_number(name);
  for (std::uint32_t k = 0; k < model.choices(s); ++k) plain = plain && (k == chosen || model.action(s, k) != name);
  return plain ? std::string(name) : std::to_string(chosen);
}

}  // namespace

Scheduler parse_scheduler(std::string_view text, std::string_view source, const Mdp& model) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] == '[') return StormScheduler(text, source, model).read();
  return PrismScheduler(source, model).read(text);
}

std::string write_scheduler(const Scheduler& scheduler, SchedulerFormat format, const Mdp& model) {
  std::string prism;
  nlohmann::ordered_json storm = nlohmann::ordered_json::array();
  std::size_t first = 0;
  for (std::uint32_t s = 0; s < model.states(); ++s) {
    const auto& chosen = scheduler.choices[s];
    if (!chosen.empty() && format == SchedulerFormat::Prism) {
      if (chosen.size() > 1) throw std::invalid_argument("PRISM's schedulers do not draw");
      prism += std::to_string(s) + '=' + prism_choice(model, s, chosen.front().choice) + '\n';
    } else if (!chosen.empty()) {
      nlohmann::ordered_json choices = nlohmann::ordered_json::array();
      for (const Scheduler::Choice& c : chosen)
        choices.push_back({{"labels", {std::string(model.action(s, c.choice))}},
                           {"index", first + c.choice},
                           {"prob", c.probability}});
      storm.push_back({{"s", s}, {"c", choices}});
    }
    first += model.choices(s);
  }
  return format == SchedulerFormat::Prism ? prism : storm.dump(1) + '\n';
}

Mdp induced(const Mdp& model, const Scheduler& scheduler) {
  MdpBuilder builder{model.letters().vocabulary()};
  for (const ltl::Letter& letter : model.letters().all()) builder.letter(letter);  // with the same numbers
  for (std::uint32_t s = 0; s < model.states(); ++s) {
    builder.add_state(model.name(s));
    std::vector<Scheduler::Choice> chosen = scheduler.choices[s];
    if (chosen.empty() && model.choices(s) == 1) chosen.push_back({0, 1});
    if (chosen.empty()) continue;
    double cost = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> outcomes;  // by target and letter
    for (const Scheduler::Choice& c : chosen) {
      cost += c.probability * model.cost(s, c.choice);
      for (const ModelOutcome& o : model.outcomes(s, c.choice))
        outcomes[{o.target, o.letter.index}] += c.probability * o.probability;
    }
    builder.add_choice(chosen.size() == 1 ? model.action(s, chosen.front().choice) : "drawn", cost);
    for (const auto& [to, p] : outcomes) builder.add_outcome(to.first, LetterId{to.second}, std::min(p, 1.0));
  }
  return std::move(builder).build(model.initial(), model.initial_letter());
}

}  // namespace waymark::plan
