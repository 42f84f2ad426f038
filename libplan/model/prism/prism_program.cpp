#include "libplan/model/prism/prism_program.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace waymark::plan {
namespace {

using Id = PrismProgram::Id;
using Type = PrismProgram::Type;
using Names = std::map<std::string, std::string, std::less<>>;

class ProgramReader {
 public:
  ProgramReader(PrismTokens& in, PrismExpressions& expressions, const PrismConstants& constants)
      : in_(in), expressions_(expressions), constants_(constants) {}

  PrismProgram read() {
    while (in_.peek().kind != PrismToken::Kind::End) item();
    for (const Renaming& renaming : renamings_) rename(renaming);
    if (out_.modules.empty()) in_.fail("expected a module");
    bind();
    return std::move(out_);
  }

 private:
  struct Renaming {  // module to = from [a=b, …] endmodule
    std::size_t to;
    PrismToken from;
    Names names;
  };

  // ---- syntax

  // The word may stand anywhere among the items, once. A model of no kind is a decision process.
  bool kind() {
    static constexpr std::string_view others[] = {"ctmc", "stochastic", "pta", "popta", "pomdp", "smg",
                                                  "csg",  "tsg",        "lts", "imdp",  "idtmc"};
    const bool is_mdp = in_.is("mdp") || in_.is("nondeterministic");
    if (!is_mdp && !in_.is("dtmc") && !in_.is("probabilistic")) {
      for (const std::string_view other : others)
        if (in_.is(other)) in_.fail("models of the kind " + std::string(other) + " are not read: mdp and dtmc are");
      return false;
    }
    if (has_kind_) in_.fail("a second kind of model");
    in_.next();
    has_kind_ = true;
    out_.is_mdp = is_mdp;
    return true;
  }

  void item() {
    if (kind()) return;
    if (in_.accept("const")) {
      read_prism_constant(in_, expressions_, constants_, out_.given);
    } else if (in_.accept("formula")) {
      formula();
    } else if (in_.accept("label")) {
      label();
    } else if (in_.accept("global")) {
      variable(PrismProgram::global);
    } else if (in_.is("rewards")) {
      rewards();
    } else if (in_.is("module")) {
      module();
    } else if (in_.is("init") && !out_.start) {
      in_.next();
      out_.start = expressions_.parse(in_);
      in_.expect("endinit");
    } else if (in_.is("system")) {
      in_.fail("system … endsystem is not read: modules run side by side and meet in their actions");
    } else if (in_.is("observables") || in_.is("observable")) {
      in_.fail("observables are not read: strategies see the state");
    } else if (in_.is("player")) {
      in_.fail("players of a game are not read: mdp and dtmc are");
    } else {
      in_.fail("expected a constant, formula, module, label or rewards: what is read is docs/formats/prism.md");
    }
  }

  std::string string(const std::string& what) {
    if (in_.peek().kind != PrismToken::Kind::String) in_.fail("expected " + what);
    return std::string(in_.next().text);
  }

  void formula() {
    const PrismToken name = in_.expect_name("a formula");
    in_.expect("=");
    expressions_.define_formula(name, expressions_.parse(in_));
    in_.expect(";");
  }

  void label() {
    const PrismToken token = in_.peek();
    const std::string name = string("the name of a label in quotes");
    in_.expect("=");
    out_.labels.push_back({name, expressions_.parse(in_)});
    expressions_.define_label(token, out_.labels.back().holds);
    in_.expect(";");
  }

  void module() {
    in_.expect("module");
    const PrismToken name = in_.expect_name("the module");
    for (const PrismProgram::Module& other : out_.modules)
      if (other.name == name.text) in_.fail(name.where, "a second module of this name");
    const std::size_t at = out_.modules.size();
    out_.modules.push_back({std::string(name.text), {}});
    if (in_.accept("=")) return renaming(at);
    while (!in_.accept("endmodule")) {
      if (in_.is("invariant")) in_.fail("an invariant is not read: mdp and dtmc have no clocks");
      if (in_.is("["))
        out_.modules[at].commands.push_back(command());
      else
        variable(at);
    }
  }

  void renaming(std::size_t to) {
    Renaming& made = renamings_.emplace_back(Renaming{to, in_.expect_name("a module"), {}});
    in_.expect("[");
    do {
      const PrismToken from = in_.expect_name("what is renamed");
      in_.expect("=");
      const PrismToken name = in_.expect_name("a new name");
      if (!made.names.emplace(from.text, name.text).second) in_.fail(from.where, "this is renamed twice");
    } while (in_.accept(","));
    in_.expect("]");
    in_.expect("endmodule");
  }

  void variable(std::size_t module) {
    PrismProgram::Variable out;
    const PrismToken name = in_.expect_name("a variable, or a command, or 'endmodule'");
    out.name = name.text;
    out.where = name.where;
    out.module = module;
    in_.expect(":");
    if (in_.accept("bool")) {
      out.type = Type::Bool;
    } else {
      if (in_.is("int")) in_.fail("an unbounded integer is not read: give its range, such as [0..9]");
      if (in_.is("clock")) in_.fail("a clock is not read: mdp and dtmc have none");
      in_.expect("[");
      out.least = expressions_.parse(in_);
      in_.expect("..");
      out.most = expressions_.parse(in_);
      in_.expect("]");
    }
    if (in_.accept("init")) out.initial = expressions_.parse(in_);
    in_.expect(";");
    add(std::move(out), name);
  }

  void add(PrismProgram::Variable variable, const PrismToken& name) {
    expressions_.define_variable(name, static_cast<std::uint32_t>(out_.variables.size()), variable.type);
    out_.variables.push_back(std::move(variable));
  }

  std::string action() {
    in_.expect("[");
    std::string out = in_.is("]") ? "" : std::string(in_.expect_name("an action").text);
    in_.expect("]");
    return out;
  }

  PrismProgram::Command command() {
    PrismProgram::Command out;
    const std::size_t begin = in_.peek().where.begin;
    out.action = action();
    out.guard = expressions_.parse(in_);
    in_.expect("->");
    do {
      out.updates.push_back(update());
    } while (in_.accept("+"));
    out.where = {begin, in_.expect(";").where.end};
    return out;
  }

  bool at_assignments() const {
    return (in_.is("(") && in_.is("'", 2)) || (in_.is("true") && (in_.is(";", 1) || in_.is("+", 1)));
  }

  PrismProgram::Update update() {
    PrismProgram::Update out;
    if (!at_assignments()) {
      if (in_.is("[")) in_.fail("an interval of probabilities is not read: a number is");
      out.probability = expressions_.parse(in_);
      in_.expect(":");
    }
    if (in_.accept("true")) return out;
    do {
      in_.expect("(");
      PrismProgram::Assignment& assignment = out.assignments.emplace_back();
      const PrismToken name = in_.expect_name("a variable");
      assignment.name = name.text;
      assignment.where = name.where;
      in_.expect("'");
      in_.expect("=");
      assignment.value = expressions_.parse(in_);
      in_.expect(")");
    } while (in_.accept("&"));
    return out;
  }

  void rewards() {
    in_.expect("rewards");
    PrismProgram::Rewards out;
    if (in_.peek().kind == PrismToken::Kind::String) out.name = in_.next().text;
    while (!in_.accept("endrewards")) {
      PrismProgram::Reward& item = out.items.emplace_back();
      if (in_.is("[")) item.action = action();
      item.guard = expressions_.parse(in_);
      in_.expect(":");
      item.value = expressions_.parse(in_);
      in_.expect(";");
    }
    out_.rewards.push_back(std::move(out));
  }

  // ---- renaming

  // Formulas are written out: what they say of the old module is to be said of the new one.
  void rename(const Renaming& renaming) {
    const auto from = std::find_if(out_.modules.begin(), out_.modules.end(),
                                   [&](const PrismProgram::Module& m) { return m.name == renaming.from.text; });
    if (from == out_.modules.end()) in_.fail(renaming.from.where, "there is no module of this name");
    const auto old = static_cast<std::size_t>(from - out_.modules.begin());
    if (old >= renaming.to) in_.fail(renaming.from.where, "a module is renamed after it was read");
    const auto named = [&](const std::string& name) {
      const auto to = renaming.names.find(name);
      return to == renaming.names.end() ? name : to->second;
    };
    const auto expression = [&](Id e) { return expressions_.renamed(e, renaming.names); };
    const auto maybe = [&](std::optional<Id>& e) {
      if (e) e = expression(*e);
    };
    const std::vector<PrismProgram::Variable> variables = out_.variables;
    for (PrismProgram::Variable v : variables) {
      if (v.module != old) continue;
      v.name = named(v.name);
      v.module = renaming.to;
      maybe(v.least);
      maybe(v.most);
      maybe(v.initial);
      const PrismToken name{PrismToken::Kind::Name, v.name, renaming.from.where};
      add(v, name);
    }
    std::vector<PrismProgram::Command> commands = from->commands;
    for (PrismProgram::Command& command : commands) {
      command.action = named(command.action);
      command.guard = expression(command.guard);
      for (PrismProgram::Update& update : command.updates) {
        maybe(update.probability);
        for (PrismProgram::Assignment& a : update.assignments) {
          a.name = named(a.name);
          a.value = expression(a.value);
        }
      }
    }
    out_.modules[renaming.to].commands = std::move(commands);
  }

  // ---- types and constants

  void bind() {
    for (PrismProgram::Variable& v : out_.variables) bind(v);
    for (std::size_t m = 0; m < out_.modules.size(); ++m)
      for (PrismProgram::Command& c : out_.modules[m].commands) bind(c, m);
    for (const PrismProgram::Rewards& structure : out_.rewards)
      for (const PrismProgram::Reward& r : structure.items) {
        expressions_.expect_type(r.guard, Type::Bool);
        expressions_.expect_type(r.value, Type::Double);
      }
    for (const PrismProgram::Label& l : out_.labels) expressions_.expect_type(l.holds, Type::Bool);
    if (out_.start) expressions_.expect_type(*out_.start, Type::Bool);
  }

  void bind(PrismProgram::Command& command, std::size_t module) {
    expressions_.expect_type(command.guard, Type::Bool);
    for (PrismProgram::Update& u : command.updates) {
      if (u.probability) expressions_.expect_type(*u.probability, Type::Double);
      for (PrismProgram::Assignment& a : u.assignments) bind(a, module, !command.action.empty());
      for (std::size_t i = 1; i < u.assignments.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (u.assignments[i].variable == u.assignments[j].variable)
            in_.fail(u.assignments[i].where, "this update assigns the variable twice");
    }
  }

  double constant(Id e, Type type) {
    expressions_.expect_type(e, type);
    return expressions_.constant(e);
  }

  void bind(PrismProgram::Variable& v) {
    if (v.least) v.from = v.first = constant(*v.least, Type::Int);
    if (v.most) v.to = constant(*v.most, Type::Int);
    if (v.initial) v.first = constant(*v.initial, v.type);
    if (v.from > v.to) in_.fail(v.where, "the range of this variable is empty");
    if (!(v.to - v.from < 4e9)) in_.fail(v.where, "the range of this variable is too wide");
    if (v.first < v.from || v.first > v.to) in_.fail(v.where, "the initial value is out of range");
  }

  void bind(PrismProgram::Assignment& a, std::size_t module, bool synchronised) {
    const auto found = std::find_if(out_.variables.begin(), out_.variables.end(),
                                    [&](const PrismProgram::Variable& v) { return v.name == a.name; });
    if (found == out_.variables.end()) in_.fail(a.where, "there is no variable of this name");
    if (found->module == PrismProgram::global ? synchronised && out_.modules.size() > 1 : found->module != module)
      in_.fail(a.where, found->module == PrismProgram::global
                            ? "a command with an action assigns a global variable, which others may assign at once"
                            : "this variable is of another module");
    a.variable = static_cast<std::size_t>(found - out_.variables.begin());
    expressions_.expect_type(a.value, found->type);
  }

  PrismTokens& in_;
  PrismExpressions& expressions_;
  const PrismConstants& constants_;
  PrismProgram out_;
  bool has_kind_ = false;
  std::vector<Renaming> renamings_;
};

}  // namespace

bool PrismProgram::Module::has(std::string_view action) const {
  return std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.action == action; });
}

PrismProgram read_prism_program(PrismTokens& in, PrismExpressions& expressions, const PrismConstants& constants) {
  return ProgramReader(in, expressions, constants).read();
}

void read_prism_constant(PrismTokens& in, PrismExpressions& expressions, const PrismConstants& constants,
                         std::vector<std::string>& taken) {
  std::optional<Type> type;
  if (in.accept("double")) type = Type::Double;
  if (in.accept("bool")) type = Type::Bool;
  if (in.accept("int")) type = Type::Int;
  const PrismToken name = in.expect_name("a constant");
  const auto given = constants.find(name.text);
  if (in.accept("=")) {
    if (given != constants.end()) in.fail(name.where, "this constant has a value already");
    expressions.define_formula(name, expressions.parse(in));
    in.expect(";");
    return;
  }
  if (given == constants.end())
    in.fail(name.where, "the constant " + std::string(name.text) + " has no value: give one with --const");
  in.expect(";");
  taken.push_back(given->first);
  const std::optional<Id> literal = prism_literal(expressions, given->second, type);
  if (!literal) in.fail(name.where, "the value " + given->second + " given for the constant is of another type");
  expressions.define_formula(name, *literal);
}

std::optional<Id> prism_literal(PrismExpressions& expressions, const std::string& text, std::optional<Type> type) {
  if (type == Type::Bool)
    return text == "true" || text == "false" ? std::optional(expressions.number(text == "true" ? 1 : 0, Type::Bool))
                                             : std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = text.find_first_of(".eE") == std::string::npos;
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  if (type == Type::Int && !whole) return std::nullopt;
  return expressions.number(value, whole ? Type::Int : Type::Double);
}

void expect_given(const PrismTokens& in, const PrismConstants& constants, const std::vector<std::string>& given) {
  for (const auto& [name, value] : constants)
    if (std::find(given.begin(), given.end(), name) == given.end())
      in.fail("there is no constant " + name + " to take the value " + value);
}

}  // namespace waymark::plan
