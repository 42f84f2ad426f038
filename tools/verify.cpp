// waymark verify: is what an answer claims true? From the printed answer alone, by code that did not find it: formulas
// by the definition of ⊨, least costs and infeasibility by progression, automata word by word.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/least_by_progression.hpp"
#include "libplan/model/formats/read_model.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "libplan/world/json_reader.hpp"
#include "libplan/world/trajectory.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/shell/work_limits.hpp"
#include "tools/verify_model.hpp"

namespace waymark::tools {
namespace {

struct VerifyOptions {
  TextOptions text;
  MapOptions map{.map = "", .data = {}};  // no map: the answer's
  std::string model, start;               // of the answers of plan --model and --case
  std::size_t words = 2000, pairs = 1'000'000;
  WorkLimits limits;
  bool json = false;
};

// What is claimed by one answer, and whether it holds.
class Verifier {
 public:
  using Value = plan::JsonReader::Value;

  Verifier(const Text& text, const VerifyOptions& options, const plan::PlanningCase* model, std::stop_token stop)
      : text_(text),
        options_(options),
        model_(model),
        stop_(std::move(stop)),
        in_(text.text, text.source, text.line),
        answer_(in_.parse()) {}

  std::vector<Claim> verify() {
    if (!answer_.is_object()) in_.fail("", "expected the JSON object that a subcommand printed");
    if (answer_.contains("query"))
      on_model();
    else if (answer_.contains("hoa"))
      automaton();
    else if (answer_.contains("cycle"))
      lasso();
    else if (answer_.contains("routes"))
      routes();
    else if (answer_.contains("route"))
      route(text_.text, answer_, true);
    else if (answer_.contains("starts"))
      infeasible();
    if (claims_.empty())
      in_.fail("",
               "expected an answer of plan, run or translate with a route, a lasso, an automaton (--format json), or "
               "the starts from which there is no route");
    return std::move(claims_);
  }

 private:
  void on_model() {
    if (model_ == nullptr) throw UsageError("an answer on a model: give the file to --model");
    claims_ = claims_on_model(text_, *model_, {.states = options_.pairs, .stop = stop_});
  }

  void claim(std::optional<bool> holds, std::string text) { claims_.push_back({std::move(text), holds}); }

  std::string member(const char* key) const { return in_.string(in_.member(answer_, "", key), key); }

  plan::Map map() const {
    MapOptions options = options_.map;
    if (options.map.empty()) options.map = member("map");
    return read_map(options);
  }

  ltl::Formula formula(ltl::Arena& arena, ltl::Unknown unknown) const {
    return ltl::parse(member("formula"), arena, {.unknown = unknown});
  }

  // `document`: the text of an object with that route, for the reader of walks. `least`: none shall cost less.
  void route(const std::string& document, const Value& object, bool least) {
    const plan::Map on = map();
    ltl::Arena arena(on.vocabulary());
    const ltl::Formula f = formula(arena, ltl::Unknown::Reject);
    const std::optional<plan::Walk> walk = walk_of(document, on);
    if (!walk) return;
    claim(ltl::holds(plan::word_of(walk->trajectory, on), f), "the route satisfies " + ltl::print(f));
    const std::size_t actions = walk->trajectory.actions.size();
    cost(object, "cost", static_cast<double>(actions));
    if (!least) return;
    const plan::PoseId start = walk->trajectory.poses.front();
    const auto found = plan::least_by_progression(f, on, {&start, 1}, {.states = options_.pairs, .stop = stop_});
    claim(found ? std::optional(!found->actions || *found->actions >= actions) : std::nullopt,
          "no route from " + plan::show(on.pose(start)) + " costs less");
  }

  // Steps that the map does not have are a claim that does not hold, not a file that cannot be read.
  std::optional<plan::Walk> walk_of(const std::string& document, const plan::Map& on) {
    try {
      plan::Walk walk = plan::parse_walk(document, on, text_.source);
      claim(true, "every step is one on map " + on.name());
      return walk;
    } catch (const ltl::FormatError& error) {
      const std::string what = error.what();
      claim(false, "every step is one on map " + on.name() + " (" + what.substr(0, what.find('\n')) + ")");
      return std::nullopt;
    }
  }

  void cost(const Value& object, const char* key, double counted) {
    if (!object.contains(key)) return;
    const double said = in_.number(object[key], key);
    claim(said == counted, std::string(key) + " is " + Json(said).text());
  }

  void routes() {
    std::vector<double> costs;
    in_.each(answer_, "", "routes", [&](const Value& one, const std::string& path) {
      route(one.dump(), one, costs.empty());
      costs.push_back(in_.number(in_.member(one, path, "cost"), path));
    });
    if (costs.size() > 1)
      claim(std::is_sorted(costs.begin(), costs.end()), "the routes are in the order of their costs");
  }

  void lasso() {
    const plan::Map on = map();
    ltl::Arena arena(on.vocabulary());
    const ltl::Formula f = formula(arena, ltl::Unknown::Reject);
    Value only = Value::object();
    for (const char* key : {"prefix", "cycle"}) only[key] = in_.member(answer_, "", key);
    const std::optional<plan::Walk> walk = walk_of(only.dump(), on);
    if (!walk) return;
    claim(ltl::holds(plan::lasso_of(*walk, on), f), "the walk without end satisfies " + ltl::print(f));
    cost(answer_, "prefix_cost", static_cast<double>(walk->trajectory.actions.size() - walk->repeated));
    cost(answer_, "cycle_cost", static_cast<double>(walk->repeated));
  }

  void infeasible() {
    const plan::Map on = map();
    ltl::Arena arena(on.vocabulary());
    const ltl::Formula f = formula(arena, ltl::Unknown::Reject);
    std::vector<plan::PoseId> starts;
    in_.each(answer_, "", "starts", [&](const Value& one, const std::string& path) {
      if (!one.is_array() || one.size() != 3) in_.fail(path, "expected a pose [x,y,heading]");
      const auto pose = on.find({in_.integer(one[0], path), in_.integer(one[1], path), in_.integer(one[2], path)});
      if (!pose) in_.fail(path, "there is no such place on map " + on.name());
      starts.push_back(*pose);
    });
    const auto least = plan::least_by_progression(f, on, starts, {.states = options_.pairs, .stop = stop_});
    claim(least ? std::optional(!least->actions) : std::nullopt,
          "no route from these starts satisfies " + ltl::print(f));
  }

  void automaton() {
    const plan::GivenAutomaton given = plan::read_given_automaton(member("hoa"), text_.source);
    const bool finite = std::holds_alternative<automata::Dfa>(given);
    const ltl::Vocabulary& names =
        std::visit([](const auto& a) -> const ltl::Vocabulary& { return a.vocabulary(); }, given);
    ltl::Arena arena(names);
    const ltl::Formula f = formula(arena, ltl::Unknown::Add);
    const auto wrong = [&](const std::vector<ltl::Letter>& letters, std::size_t loop) -> std::optional<std::string> {
      if (const auto* dfa = std::get_if<automata::Dfa>(&given)) {
        const ltl::Trace word(letters);
        if (automata::accepts(*dfa, word) == ltl::holds(word, f)) return std::nullopt;
        return ltl::show(word, arena.vocabulary());
      }
      const auto cut = letters.begin() + static_cast<std::ptrdiff_t>(loop);
      const ltl::Lasso word({letters.begin(), cut}, {cut, letters.end()});
      if (automata::accepts(std::get<automata::Automaton>(given), word) == ltl::holds(word, f)) return std::nullopt;
      return ltl::show(word, arena.vocabulary());
    };
    const auto found = first_wrong_word(arena.vocabulary().size(), finite, wrong);
    claim(found                    ? std::optional(false)
          : stop_.stop_requested() ? std::nullopt
                                   : std::optional(true),
          "the automaton agrees with " + ltl::print(f) +
              (found ? " (not on " + *found + ")" : " on " + std::to_string(options_.words) + " words"));
  }

  // The shortest words over all letters as far as half the words go, then random ones.
  template <class Wrong>
  std::optional<std::string> first_wrong_word(std::size_t propositions, bool finite, const Wrong& wrong) const {
    std::size_t tried = 0;
    for (std::size_t length = 1; propositions <= 8; ++length) {
      const std::size_t letters = std::size_t{1} << propositions, loops = finite ? 1 : length;
      double words = static_cast<double>(loops);
      for (std::size_t i = 0; i < length; ++i) words *= static_cast<double>(letters);
      if (static_cast<double>(tried) + words > static_cast<double>(options_.words) / 2) break;
      std::vector<std::size_t> digits(length, 0);
      for (bool more = true; more; more = next(digits, letters))
        for (std::size_t loop = 0; loop < loops; ++loop, ++tried)
          if (auto found = wrong(word_of(digits, propositions), loop)) return found;
    }
    ltl::Random random(1);
    for (; tried < options_.words; ++tried) {
      if (stop_.stop_requested()) return std::nullopt;
      const std::size_t loop = random.below(5), length = loop + 1 + random.below(5);
      std::vector<ltl::Letter> letters;
      for (std::size_t i = 0; i < length; ++i)
        letters.push_back(
            ltl::random_letter(random, {.atoms = propositions, .density = random.below(2) == 0 ? 0.5 : 0.2}));
      if (auto found = wrong(letters, loop)) return found;
    }
    return std::nullopt;
  }

  static bool next(std::vector<std::size_t>& digits, std::size_t base) {
    for (std::size_t& digit : digits) {
      if (++digit < base) return true;
      digit = 0;
    }
    return false;
  }

  static std::vector<ltl::Letter> word_of(const std::vector<std::size_t>& digits, std::size_t propositions) {
    std::vector<ltl::Letter> out(digits.size());
    for (std::size_t i = 0; i < digits.size(); ++i)
      for (std::uint32_t p = 0; p < propositions; ++p)
        if ((digits[i] >> p & 1U) != 0) out[i].insert(ltl::Proposition{p});
    return out;
  }

  const Text& text_;
  const VerifyOptions& options_;
  const plan::PlanningCase* model_;  // null: none was given
  std::stop_token stop_;
  plan::JsonReader in_;
  Value answer_;
  std::vector<Claim> claims_;
};

ExitCode verdict_of(const std::vector<Claim>& claims) {
  ExitCode code = ExitCode::Done;
  for (const Claim& claim : claims) {
    if (claim.holds == false) return ExitCode::No;
    if (!claim.holds) code = ExitCode::GaveUp;
  }
  return code;
}

const char* verdict_in_words(ExitCode verdict) {
  if (verdict == ExitCode::Done) return "verified";
  return verdict == ExitCode::No ? "refuted" : "undecided";
}

ExitCode verify_one(const Text& text, const VerifyOptions& options, const plan::PlanningCase* model,
                    const Session& session) {
  const ltl::Watch watch(granted(options.limits), session.stop);
  const std::vector<Claim> claims = Verifier(text, options, model, watch.token()).verify();
  if (session.stop.stop_requested()) throw Interrupted();
  const ExitCode verdict = verdict_of(claims);
  if (options.json) {
    JsonArray list;
    for (const Claim& claim : claims)
      list.add(JsonObject().add("claim", claim.text).add("holds", claim.holds ? Json(*claim.holds) : Json()));
    std::cout << JsonObject().add("verdict", verdict_in_words(verdict)).add("claims", list).text() << '\n';
    return verdict;
  }
  std::cout << session.out.paint(verdict == ExitCode::Done ? Paint::Green : Paint::Red, verdict_in_words(verdict))
            << '\n';
  for (const Claim& claim : claims)
    std::cout << "  " << (claim.holds ? (*claim.holds ? "true   " : "false  ") : "?      ") << claim.text << '\n';
  return verdict;
}

}  // namespace

Runner setup_verify(Command command) {
  const auto options = std::make_shared<VerifyOptions>();
  command.add_option("answers", options->text.file, "JSON lines of plan, run or translate; - is standard input")
      .type_name("FILE");
  command.add_option("--map", options->map.map, "the map of the answer (else by the name that the answer gives)")
      .type_name("MAP");
  command.add_option("--model", options->model, "the model of answers of plan --model and plan --case")
      .type_name("FILE");
  command.add_option("--start", options->start, "the landmark of a street graph where they start")
      .type_name("LANDMARK");
  add_data_option(command, options->map.data);
  command.add_option("--words", options->words, "on which an automaton is compared with its formula")
      .between(1, 100'000'000)
      .show_default();
  command.add_option("--pairs", options->pairs, "of pose and formula, before a least cost is left undecided")
      .between(1, 100'000'000)
      .show_default();
  add_work_limits(command, options->limits, "an answer");
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) {
    TextOptions from = options->text;
    if (from.file.empty()) from.file = "-";
    TextReader texts(from, "answer");
    std::optional<plan::PlanningCase> model;
    if (!options->model.empty())
      model =
          plan::read_model(options->model, options->start, {.states = plan::most_model_states, .stop = session.stop});
    return answer_each(
        texts, session.stop,
        [&](const Text& text) { return verify_one(text, *options, model ? &*model : nullptr, session); },
        options->json);
  };
}

}  // namespace waymark::tools
