#include "tools/check_model.hpp"

#include <iomanip>
#include <iostream>
#include <sstream>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/model_check.hpp"
#include "tools/answer.hpp"
#include "tools/plan_case.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/rounded.hpp"

namespace waymark::tools {
namespace {

std::string steps(const std::vector<std::string>& places, const std::vector<std::string>& actions) {
  std::string out = places.front();
  for (std::size_t i = 0; i < actions.size(); ++i)
    out += (actions[i].empty() || actions[i] == places[i + 1] ? " " : ' ' + actions[i] + ' ') + places[i + 1];
  return out;
}

JsonObject json_of(const std::vector<std::string>& places, const std::vector<std::string>& actions) {
  JsonArray all_places, all_actions;
  for (const std::string& place : places) all_places.add(place);
  for (const std::string& action : actions) all_actions.add(action);
  return JsonObject().add("places", all_places).add("actions", all_actions);
}

std::string exact(double value) {
  std::ostringstream out;
  out << std::setprecision(12) << value;
  return out.str();
}

// The formula is null of an automaton.
void print_json(const Json& formula, const std::string& model, const plan::ModelCheck& found, bool chance,
                const char* certifier) {
  JsonObject json;
  json.add("formula", formula).add("model", model).add("semantics", "infinite").add("holds", found.holds);
  if (chance)
    json.add("probability", JsonObject().add("lower", found.probability.lower).add("upper", found.probability.upper));
  if (found.lasso)
    json.add("prefix", json_of(found.lasso->prefix.places, found.lasso->prefix.actions))
        .add("cycle", json_of(found.lasso->cycle.places, found.lasso->cycle.actions))
        .add("certified", true)
        .add("certified_by", certifier);
  if (chance && !found.holds) {
    JsonArray paths;
    for (const plan::LikelyPath& path : found.paths)
      paths.add(json_of(path.places, path.actions).add("probability", path.probability));
    json.add("paths", paths).add("probability_of_paths", found.probability_of_paths);
  }
  std::cout << json.text() << '\n';
}

void print_paths(const plan::ModelCheck& found) {
  const double least = found.probability.lower, most = found.probability.upper;
  std::cout << "  probability " << exact(found.probability.middle());
  if (least != most) std::cout << "  " << between(least, most);
  std::cout << (found.is_chain ? "" : ", under the strategy that is worst for it") << '\n';
  for (const plan::LikelyPath& path : found.paths)
    std::cout << "  " << exact(path.probability) << "  " << steps(path.places, path.actions) << '\n';
  std::cout << "  after " << (found.paths.size() == 1 ? "this path" : "these " + counted(found.paths.size(), "path"))
            << " it is violated: probability " << exact(found.probability_of_paths) << '\n';
}

void print(const plan::ModelCheck& found, bool chance, const Terminal& terminal) {
  if (found.holds) {
    std::cout << terminal.paint(Paint::Green, "holds") << (chance ? " with probability 1" : " on every run")
              << (chance && !found.is_chain ? ", whatever the strategy" : "") << '\n';
    return;
  }
  std::cout << terminal.paint(Paint::Red, "does not hold") << '\n';
  if (!found.lasso) return print_paths(found);
  std::cout << "  prefix  " << steps(found.lasso->prefix.places, found.lasso->prefix.actions) << '\n'
            << "  cycle   " << steps(found.lasso->cycle.places, found.lasso->cycle.actions) << '\n';
}

bool has_chance(const plan::PlanningCase& model) {
  return std::visit([](const auto& m) { return !m.is_deterministic(); }, model.model);
}

struct Specification {
  Json formula;
  const char* certifier;  // of a lasso that violates it
};

// `check(options)`: what the library found.
template <class Check>
ExitCode told(const plan::PlanningCase& model, const CheckModelOptions& options, const Session& session,
              const Specification& of, const Check& check) {
  const ltl::Watch watch(granted(options.limits), session.stop);
  const std::optional<plan::ModelCheck> found = check({.paths = options.paths, .stop = watch.token()});
  if (!found && session.stop.stop_requested()) throw Interrupted();
  if (!found)
    throw GaveUp(watch.overrun() == ltl::Overrun::None ? "gave up: the product or its automaton met a limit"
                                                       : gave_up(watch.overrun(), options.limits));
  if (options.json)
    print_json(of.formula, model.name, *found, has_chance(model), of.certifier);
  else
    print(*found, has_chance(model), session.out);
  return found->holds ? ExitCode::Done : ExitCode::No;
}

plan::PlanningCase model_of(const CheckModelOptions& options, const Session& session) {
  CaseChoice choice;
  choice.model = options.model;
  choice.constants = options.constants;
  choice.rewards = options.rewards;
  choice.parallel.limits = options.limits;
  return read_model(choice, options.start, session.stop);
}

ExitCode check_one(const Text& text, const plan::PlanningCase& model, const CheckModelOptions& options,
                   const Session& session) {
  ltl::Arena arena(std::visit([](const auto& m) { return m.letters().vocabulary(); }, model.model));
  const ltl::Formula formula = [&] {
    try {
      return ltl::parse(text.text, arena, {.unknown = ltl::Unknown::Reject});
    } catch (const ltl::SyntaxError& error) {
      if (text.source.empty()) throw;
      throw error.in(text.source, text.line);
    }
  }();
  return told(model, options, session, {ltl::print(formula), "definition"}, [&](const plan::ModelCheckOptions& within) {
    return plan::check_model(model, ltl::print(formula), within);
  });
}

}  // namespace

void add_check_model_options(Command command, CheckModelOptions& options) {
  command
      .add_option("--model", options.model, "does every run of this model satisfy the formula? else a counterexample")
      .type_name("FILE");
  command.add_option("--const", options.constants, "of a model in the language of PRISM: N=3,p=0.5").type_name("LIST");
  command.add_option("--rewards", options.rewards, "of such a model: the rewards that are costs of a counterexample")
      .type_name("NAME");
  command
      .add_option("--automaton", options.automaton,
                  "with --model: an automaton in HOA that is to accept every run, in the place of formulas")
      .type_name("FILE");
  command.add_option("--paths", options.paths, "of a counterexample where chance decides, at most")
      .between(1, 100'000)
      .show_default();
  add_work_limits(command, options.limits, "a formula on a model");
}

ExitCode check_on_model(const CheckModelOptions& options, TextReader& formulas, const Session& session) {
  const plan::PlanningCase model = model_of(options, session);
  return answer_each(
      formulas, session.stop, [&](const Text& text) { return check_one(text, model, options, session); }, options.json);
}

ExitCode check_automaton_on_model(const CheckModelOptions& options, const Session& session) {
  const plan::PlanningCase model = model_of(options, session);
  const std::string source = source_name(options.automaton);
  const plan::GivenAutomaton given = plan::read_given_automaton(read_file(options.automaton), source);
  const auto* automaton = std::get_if<automata::Automaton>(&given);
  if (automaton == nullptr)
    throw ltl::FormatError(source, 0, 0, "the automaton is about finite words, runs have no end");
  const ltl::Vocabulary known = std::visit([](const auto& m) { return m.letters().vocabulary(); }, model.model);
  for (const ltl::Proposition p : automaton->reads())
    if (const std::string& name = automaton->vocabulary().name(p); !known.find(name))
      throw ltl::FormatError(source, 0, 0, "the model has no proposition '" + name + "'");
  return told(model, options, session, {Json(), "automaton"},
              [&](const plan::ModelCheckOptions& within) { return plan::check_model(model, given, within); });
}

}  // namespace waymark::tools
