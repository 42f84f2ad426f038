#include "libplan/model/jani/jani_program.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "libplan/model/jani/jani_declarations.hpp"

namespace waymark::plan {
namespace {

using Id = PrismExpressions::Id;
using Type = PrismExpressions::Type;
using Moment = JaniExpressions::Moment;
using Place = JaniText::Id;

struct Element {  // of the composition: an automaton, with variables of its own
  Place automaton = 0;
  JaniNames own = {};
  std::map<std::string, std::uint32_t, std::less<>> locations = {};
  std::optional<std::uint32_t> variable = {};  // that holds the location; none where there is one location
};

class Reader {
 public:
  Reader(const JaniText& text, PrismExpressions& expressions, JaniExpressions& names, const PrismConstants& constants)
      : text_(text),
        expressions_(expressions),
        names_(names),
        constants_(constants),
        declarations_(text, expressions, names, out_) {}

  PrismProgram read() {
    header();
    declarations_.constants(0, constants_);
    declarations_.functions(0, names_.document());
    declarations_.variables(0, names_.document(), transient_);
    const std::size_t of_document = transient_.size();
    elements();
    number_transient_variables();
    give_values_in_states();
    for (std::size_t m = 0; m < elements_.size(); ++m) edges(m);
    synchronisations();
    start();
    for (std::size_t i = 0; i < of_document; ++i) {
      const JaniName& name = *transient_[i].meaning;
      if (name.type == Type::Bool)
        out_.labels.push_back({transient_[i].name, *name.in_state});
      else
        out_.rewards.push_back({transient_[i].name,
                                {{{}, names_.literal(1, Type::Bool), *name.in_state}},
                                expressions_.variable(*name.variable, name.type, {})});
    }
    return std::move(out_);
  }

 private:
  void header() {
    text_.expect_keys(0, {"jani-version", "name", "metadata", "type", "features", "actions", "constants", "variables",
                          "functions", "restrict-initial", "properties", "automata", "system"});
    const Place version = text_.member(0, "jani-version");
    if (text_.number(version) != 1) text_.fail(version, "expected version 1 of JANI");
    const Place type = text_.member(0, "type");
    out_.is_mdp = text_.text(type) == "mdp";
    if (!out_.is_mdp && text_.text(type) != "dtmc")
      text_.fail(type, "expected 'mdp' or 'dtmc': models of these kinds are read");
    for (const Place action : text_.list(0, "actions")) {
      text_.expect_keys(action, {"name"});
      actions_.insert(text_.text(text_.member(action, "name")));
    }
  }

  const std::string& action(Place at) const {
    if (!actions_.contains(text_.text(at))) text_.fail(at, "there is no action '" + text_.text(at) + "'");
    return text_.text(at);
  }

  // ---- automata and their variables

  void elements() {
    std::map<std::string, Place, std::less<>> automata;
    for (const Place automaton : text_.elements(text_.member(0, "automata"))) {
      text_.expect_keys(
          automaton, {"name", "variables", "functions", "restrict-initial", "locations", "initial-locations", "edges"});
      const Place name = text_.member(automaton, "name");
      if (!automata.emplace(text_.text(name), automaton).second) text_.fail(name, "a second automaton of this name");
    }
    const Place system = text_.member(0, "system");
    text_.expect_keys(system, {"elements", "syncs"});
    const std::vector<Place> all = text_.elements(text_.member(system, "elements"));
    if (all.empty()) text_.fail(system, "expected an automaton");
    elements_.reserve(all.size());  // names are pointed at
    for (const Place at : all) {
      text_.expect_keys(at, {"automaton", "input-enable"});
      const Place name = text_.member(at, "automaton");
      const auto found = automata.find(text_.text(name));
      if (found == automata.end()) text_.fail(name, "there is no automaton of this name");
      const std::vector<Place> open = text_.list(at, "input-enable");
      if (!open.empty()) text_.fail(open[0], "input-enabled actions are not read");
      element(elements_.emplace_back(Element{found->second}));
    }
    if (out_.variables.empty()) location_variable(elements_[0], 0);
  }

  void element(Element& element) {
    const Place automaton = element.automaton;
    out_.modules.push_back({text_.text(text_.member(automaton, "name")), {}});
    declarations_.functions(automaton, element.own);
    declarations_.variables(automaton, element.own, transient_);
    for (const Place location : text_.elements(text_.member(automaton, "locations"))) {
      text_.expect_keys(location, {"name", "transient-values"});
      const Place name = text_.member(location, "name");
      const auto number = static_cast<std::uint32_t>(element.locations.size());
      if (!element.locations.emplace(text_.text(name), number).second)
        text_.fail(name, "a second location of this name");
    }
    if (element.locations.size() != 1) location_variable(element, out_.modules.size() - 1);
  }

  // The location of a run is where one of the initial locations is.
  void location_variable(Element& element, std::size_t number) {
    const Place list = text_.member(element.automaton, "initial-locations");
    const std::vector<Place> first = text_.elements(list);
    if (first.empty()) text_.fail(list, "expected an initial location");
    PrismProgram::Variable out;
    out.name = out_.modules[number].name;
    out.where = JaniText::where(list);
    out.to = static_cast<double>(element.locations.size() - 1);
    out.fixed = first.size() == 1;
    out.first = location(element, first[0]);
    element.variable = out_.modules[number].location = static_cast<std::uint32_t>(out_.variables.size());
    out_.variables.push_back(std::move(out));
  }

  std::uint32_t location(const Element& element, Place name) const {
    const auto found = element.locations.find(text_.text(name));
    if (found == element.locations.end()) text_.fail(name, "there is no location of this name");
    return found->second;
  }

  // The condition that the automaton is there; none where it cannot be elsewhere.
  std::optional<Id> is_at(const Element& element, Place name) {
    const std::uint32_t there = location(element, name);
    if (!element.variable) return std::nullopt;
    const Id here = expressions_.variable(*element.variable, Type::Int, JaniText::where(name));
    return names_.made(PrismOp::Equal, {here, names_.literal(there, Type::Int)}, name);
  }

  // ---- transient variables

  void number_transient_variables() {
    for (std::size_t i = 0; i < transient_.size(); ++i) {
      transient_[i].meaning->variable = static_cast<std::uint32_t>(out_.variables.size() + i);
      out_.transient.push_back(transient_[i].initial);
    }
  }

  // What the locations say of them; else the values with which steps begin.
  void give_values_in_states() {
    struct Given {
      const Element* by = nullptr;
      std::vector<Id> values;  // by location
    };
    std::map<JaniName*, Given> given;
    for (Element& element : elements_)
      for (const Place place : text_.elements(text_.member(element.automaton, "locations")))
        for (const Place value : text_.list(place, "transient-values")) {
          text_.expect_keys(value, {"ref", "value"});
          const Place ref = text_.member(value, "ref");
          JaniName* const name = target(element, ref);
          if (!name->transient) text_.fail(ref, "this variable is not transient");
          Given& all = given[name];
          if (all.by != nullptr && all.by != &element)
            text_.fail(ref, "two automata give this transient variable its values");
          all.by = &element;
          all.values.resize(element.locations.size(), none);
          Id& there = all.values[location(element, text_.member(place, "name"))];
          if (there != none) text_.fail(ref, "the location gives it two values");
          there = names_.read(text_.member(value, "value"), name->type, &element.own, Moment::State);
        }
    for (const JaniDeclarations::Transient& t : transient_) {
      const Id initial = names_.literal(t.initial, t.meaning->type);
      const auto at = given.find(t.meaning);
      if (at == given.end()) {
        t.meaning->in_state = initial;
        continue;
      }
      auto& [by, values] = at->second;
      std::replace(values.begin(), values.end(), none, initial);
      if (by->variable)
        values.insert(values.begin(), expressions_.variable(*by->variable, Type::Int, expressions_.where(values[0])));
      t.meaning->in_state = by->variable ? names_.made(PrismOp::Pick, values, by->automaton) : values[0];
      expressions_.expect_type(*t.meaning->in_state, t.meaning->type);
    }
  }

  JaniName* target(Element& element, Place ref) {
    if (text_.kind(ref) != JaniText::Kind::Text) text_.fail(ref, "expected the name of a variable");
    for (JaniNames* names : {&element.own, &names_.document()}) {
      const auto at = names->names.find(text_.text(ref));
      if (at == names->names.end()) continue;
      if (!at->second.variable) text_.fail(ref, "a constant is assigned");
      return &at->second;
    }
    text_.fail(ref, "there is no variable of this name");
  }

  // ---- edges

  Id expression(Place owner, std::string_view key, Type type, const JaniNames* own) {
    const Place in = text_.member(owner, key);
    text_.expect_keys(in, {"exp"});
    return names_.read(text_.member(in, "exp"), type, own, Moment::State);
  }

  void edges(std::size_t m) {
    Element& element = elements_[m];
    for (const Place edge : text_.list(element.automaton, "edges")) {
      text_.expect_keys(edge, {"location", "action", "guard", "destinations"});
      PrismProgram::Command command;
      command.where = JaniText::where(edge);
      if (const auto named = text_.find(edge, "action")) command.action = action(*named);
      command.location = location(element, text_.member(edge, "location"));
      command.guard = text_.find(edge, "guard") ? expression(edge, "guard", Type::Bool, &element.own)
                                                : names_.literal(1, Type::Bool);
      for (const Place destination : text_.elements(text_.member(edge, "destinations")))
        command.updates.push_back(update(element, destination, command.location));
      if (command.updates.empty()) text_.fail(edge, "an edge that leads nowhere");
      out_.modules[m].commands.push_back(std::move(command));
    }
  }

  PrismProgram::Update update(Element& element, Place destination, std::uint32_t from) {
    text_.expect_keys(destination, {"location", "probability", "assignments"});
    PrismProgram::Update out;
    if (text_.find(destination, "probability"))
      out.probability = expression(destination, "probability", Type::Double, &element.own);
    const Place to = text_.member(destination, "location");
    const std::uint32_t there = location(element, to);
    if (element.variable && there != from)
      out.assignments.push_back({{}, JaniText::where(to), *element.variable, names_.literal(there, Type::Int), 0});
    std::set<std::pair<const JaniName*, std::uint32_t>> met;
    for (const Place assignment : text_.list(destination, "assignments")) {
      text_.expect_keys(assignment, {"ref", "value", "index"});
      const Place ref = text_.member(assignment, "ref");
      const JaniName* const name = target(element, ref);
      const std::uint32_t round = this->round(assignment);
      if (!met.emplace(name, round).second) text_.fail(ref, "the variable is assigned twice at once");
      const Id value = names_.read(text_.member(assignment, "value"), name->type, &element.own, Moment::Step);
      out.assignments.push_back({text_.text(ref), JaniText::where(ref), *name->variable, value, round});
    }
    return out;
  }

  std::uint32_t round(Place assignment) const {
    const auto index = text_.find(assignment, "index");
    if (!index) return 0;
    const double number = text_.number(*index);
    if (!text_.is_whole(*index) || !(number >= 0 && number <= 1e6))
      text_.fail(*index, "expected a whole number from 0 to 1,000,000");
    return static_cast<std::uint32_t>(number);
  }

  // ---- composition

  void synchronisations() {
    const Place system = text_.member(0, "system");
    auto& all = out_.synchronisations.emplace();
    if (!text_.find(system, "syncs")) {
      if (elements_.size() == 1) {
        for (const std::string& name : actions_) all.push_back({name, {{0, name}}});
        return;
      }
      for (const PrismProgram::Module& module : out_.modules)
        for (const PrismProgram::Command& command : module.commands)
          if (!command.action.empty())
            text_.fail(system, "the key \"syncs\" is missing: edges of several automata have actions");
    }
    for (const Place sync : text_.list(system, "syncs")) {
      text_.expect_keys(sync, {"synchronise", "result"});
      PrismProgram::Synchronisation& made = all.emplace_back();
      if (const auto result = text_.find(sync, "result"); result && text_.kind(*result) != JaniText::Kind::Null)
        made.result = action(*result);
      const std::vector<Place> each = text_.elements(text_.member(sync, "synchronise"));
      if (each.size() != elements_.size()) text_.fail(sync, "expected an action, or null, for each element");
      for (std::size_t m = 0; m < each.size(); ++m)
        if (text_.kind(each[m]) != JaniText::Kind::Null) made.each.emplace_back(m, action(each[m]));
      if (made.each.empty()) text_.fail(sync, "no automaton takes part");
    }
  }

  // ---- the start

  void start() {
    std::vector<Id> conditions;
    const auto restrict = [&](Place owner, const JaniNames* own) {
      if (text_.find(owner, "restrict-initial"))
        conditions.push_back(expression(owner, "restrict-initial", Type::Bool, own));
    };
    restrict(0, nullptr);
    for (const Element& element : elements_) {
      restrict(element.automaton, &element.own);
      const std::vector<Place> first = text_.elements(text_.member(element.automaton, "initial-locations"));
      std::optional<Id> any;
      for (const Place location : first)
        if (const auto there = is_at(element, location))
          any = any ? names_.made(PrismOp::Or, {*any, *there}, location) : *there;
      if (first.size() > 1 && any) conditions.push_back(*any);
    }
    const bool free = std::any_of(out_.variables.begin(), out_.variables.end(),
                                  [](const PrismProgram::Variable& v) { return !v.fixed; });
    if (!conditions.empty()) {
      Id all = conditions[0];
      for (std::size_t i = 1; i < conditions.size(); ++i)
        all = names_.made(PrismOp::And, {all, conditions[i]}, static_cast<Place>(expressions_.where(all).begin));
      expressions_.expect_type(all, Type::Bool);
      out_.start = all;
    } else if (free) {
      out_.start = names_.literal(1, Type::Bool);
    }
  }

  static constexpr Id none = UINT32_MAX;

  const JaniText& text_;
  PrismExpressions& expressions_;
  JaniExpressions& names_;
  const PrismConstants& constants_;
  PrismProgram out_;
  JaniDeclarations declarations_;
  std::set<std::string, std::less<>> actions_;
  std::vector<JaniDeclarations::Transient> transient_;  // those of the document first
  std::vector<Element> elements_;
};

}  // namespace

PrismProgram read_jani_program(const JaniText& text, PrismExpressions& expressions, JaniExpressions& names,
                               const PrismConstants& constants) {
  return Reader(text, expressions, names, constants).read();
}

void expect_given(const JaniText& text, const PrismConstants& constants, const std::vector<std::string>& given) {
  for (const auto& [name, value] : constants)
    if (std::find(given.begin(), given.end(), name) == given.end())
      text.fail(JaniText::Id{0}, "there is no constant " + name + " to take the value " + value);
}

}  // namespace waymark::plan
