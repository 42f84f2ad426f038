#include "libplan/model/prism/read_prism.hpp"

#include <cmath>
#include <optional>
#include <unordered_map>

#include "libplan/model/prism/prism_expression.hpp"

namespace waymark::plan {
namespace {

using Id = PrismExpressions::Id;
using Type = PrismExpressions::Type;

struct Variable {
  PrismToken name;
  Type type = Type::Int;
  std::optional<Id> least, most, initial;
  double from = 0, to = 1, first = 0;
};
struct Assignment {
  PrismToken name;
  std::size_t variable = 0;
  Id value = 0;
};
struct Update {
  std::optional<Id> probability;  // none: 1
  std::vector<Assignment> assignments;
};
struct Command {
  std::string action;
  Id guard = 0;
  std::vector<Update> updates;
  ltl::Span where;
};
struct Reward {
  std::optional<std::string> action;  // none: of states
  Id guard = 0, value = 0;
};
struct Label {
  std::string name;
  Id holds = 0;
};

class ModelReader {
 public:
  ModelReader(std::string_view text, std::string_view source, const ltl::Limits& limits)
      : in_(text, source), expressions_(in_), limits_(limits) {}

  Mdp read() {
    if (!in_.accept("mdp")) in_.fail("expected 'mdp': models of this kind only are read");
    while (in_.peek().kind != PrismToken::Kind::End) item();
    if (variables_.empty()) in_.fail("expected a module with variables");
    bind();
    return explore();
  }

 private:
  // ---- syntax

  void item() {
    if (in_.accept("const")) {
      in_.accept("int") || in_.accept("double") || in_.accept("bool");
      definition("a constant");
    } else if (in_.accept("formula")) {
      definition("a formula");
    } else if (in_.accept("label")) {
      const std::string name = string("the name of a label in quotes");
      in_.expect("=");
      labels_.push_back({name, expressions_.parse(in_)});
      in_.expect(";");
    } else if (in_.is("rewards")) {
      rewards();
    } else if (in_.is("module")) {
      module();
    } else {
      in_.fail("expected a constant, formula, module, label or rewards: what is read is docs/formats/prism.md");
    }
  }

  std::string string(const std::string& what) {
    if (in_.peek().kind != PrismToken::Kind::String) in_.fail("expected " + what);
    return std::string(in_.next().text);
  }

  void definition(std::string_view what) {
    const PrismToken name = in_.expect_name(what);
    in_.expect("=");
    expressions_.define_formula(name, expressions_.parse(in_));
    in_.expect(";");
  }

  void module() {
    if (!variables_.empty()) in_.fail("a second module: models of one module are read");
    in_.expect("module");
    in_.expect_name("the module");
    while (!in_.accept("endmodule")) {
      if (in_.is("["))
        command();
      else
        variable();
    }
  }

  void variable() {
    Variable out;
    out.name = in_.expect_name("a variable, or a command, or 'endmodule'");
    in_.expect(":");
    if (in_.accept("bool")) {
      out.type = Type::Bool;
    } else {
      in_.expect("[");
      out.least = expressions_.parse(in_);
      in_.expect("..");
      out.most = expressions_.parse(in_);
      in_.expect("]");
    }
    if (in_.accept("init")) out.initial = expressions_.parse(in_);
    in_.expect(";");
    expressions_.define_variable(out.name, static_cast<std::uint32_t>(variables_.size()), out.type);
    variables_.push_back(out);
  }

  std::string action() {
    in_.expect("[");
    std::string out = in_.is("]") ? "" : std::string(in_.expect_name("an action").text);
    in_.expect("]");
    return out;
  }

  void command() {
    Command out;
    const std::size_t begin = in_.peek().where.begin;
    out.action = action();
    out.guard = expressions_.parse(in_);
    in_.expect("->");
    do {
      out.updates.push_back(update());
    } while (in_.accept("+"));
    out.where = {begin, in_.expect(";").where.end};
    commands_.push_back(std::move(out));
  }

  bool at_assignments() const {
    return (in_.is("(") && in_.is("'", 2)) || (in_.is("true") && (in_.is(";", 1) || in_.is("+", 1)));
  }

  Update update() {
    Update out;
    if (!at_assignments()) {
      out.probability = expressions_.parse(in_);
      in_.expect(":");
    }
    if (in_.accept("true")) return out;
    do {
      in_.expect("(");
      Assignment& assignment = out.assignments.emplace_back();
      assignment.name = in_.expect_name("a variable");
      in_.expect("'");
      in_.expect("=");
      assignment.value = expressions_.parse(in_);
      in_.expect(")");
    } while (in_.accept("&"));
    return out;
  }

  // The structure that is kept: "cost" or "steps" before others, the first of equals.
  void rewards() {
    in_.expect("rewards");
    const std::string name = in_.peek().kind == PrismToken::Kind::String ? std::string(in_.next().text) : "";
    std::vector<Reward> items;
    while (!in_.accept("endrewards")) {
      Reward& item = items.emplace_back();
      if (in_.is("[")) item.action = action();
      item.guard = expressions_.parse(in_);
      in_.expect(":");
      item.value = expressions_.parse(in_);
      in_.expect(";");
    }
    const int rank = name == "cost" || name == "steps" ? 2 : 1;
    if (rank <= rewards_rank_) return;
    rewards_rank_ = rank;
    rewards_ = std::move(items);
  }

  // ---- types and constants

  void bind() {
    for (Variable& v : variables_) bind(v);
    for (Command& c : commands_) {
      expressions_.expect_type(c.guard, Type::Bool);
      for (Update& u : c.updates) {
        if (u.probability) expressions_.expect_type(*u.probability, Type::Double);
        for (Assignment& a : u.assignments) bind(a);
        for (std::size_t i = 1; i < u.assignments.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            if (u.assignments[i].variable == u.assignments[j].variable)
              in_.fail(u.assignments[i].name.where, "this update assigns the variable twice");
      }
    }
    for (const Reward& r : rewards_) {
      expressions_.expect_type(r.guard, Type::Bool);
      expressions_.expect_type(r.value, Type::Double);
    }
    for (const Label& l : labels_) expressions_.expect_type(l.holds, Type::Bool);
  }

  double constant(Id e, Type type) {
    expressions_.expect_type(e, type);
    return expressions_.constant(e);
  }

  void bind(Variable& v) {
    if (v.least) v.from = v.first = constant(*v.least, Type::Int);
    if (v.most) v.to = constant(*v.most, Type::Int);
    if (v.initial) v.first = constant(*v.initial, v.type);
    if (v.from > v.to) in_.fail(v.name.where, "the range of this variable is empty");
    if (v.first < v.from || v.first > v.to) in_.fail(v.name.where, "the initial value is out of range");
    keys_ *= v.to - v.from + 1;
    if (!(keys_ < 9e15)) in_.fail(v.name.where, "the variables have too many values together");
  }

  void bind(Assignment& a) {
    const auto found = std::find_if(variables_.begin(), variables_.end(),
                                    [&](const Variable& v) { return v.name.text == a.name.text; });
    if (found == variables_.end()) in_.fail(a.name.where, "there is no variable of this name");
    a.variable = static_cast<std::size_t>(found - variables_.begin());
    expressions_.expect_type(a.value, found->type);
  }

  // ---- states

  std::uint64_t key(const PrismValues& values) const {
    std::uint64_t out = 0;
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      const auto size = static_cast<std::uint64_t>(variables_[v].to - variables_[v].from) + 1;
      out = out * size + static_cast<std::uint64_t>(values[v] - variables_[v].from);
    }
    return out;
  }

  static std::string show(const PrismValues& values) {
    std::string out;
    for (double value : values) out += (out.empty() ? "" : ",") + std::to_string(static_cast<std::int64_t>(value));
    return out;
  }

  std::uint32_t state(const PrismValues& values) {
    const auto [at, fresh] = numbers_.try_emplace(key(values), static_cast<std::uint32_t>(states_.size()));
    if (fresh) states_.push_back(values);
    return at->second;
  }

  ltl::Letter label(const PrismValues& values) {
    ltl::Letter out;
    for (std::uint32_t i = 0; i < labels_.size(); ++i)
      if (expressions_.value(labels_[i].holds, values) != 0) out.insert(vocabulary_.add(labels_[i].name));
    return out;
  }

  double cost(const std::string& action, const PrismValues& values) {
    if (rewards_rank_ == 0) return 1;
    double out = 0;
    for (const Reward& r : rewards_)
      if ((!r.action || *r.action == action) && expressions_.value(r.guard, values) != 0)
        out += expressions_.value(r.value, values);
    return out;
  }

  struct Outcome {
    std::uint32_t target;
    double probability;
  };

  PrismValues updated(const Update& update, const PrismValues& values) {
    PrismValues out = values;
    for (const Assignment& a : update.assignments) {
      const Variable& v = variables_[a.variable];
      const double value = expressions_.value(a.value, values);
      if (!(value >= v.from && value <= v.to))
        in_.fail(expressions_.where(a.value), "the variable leaves its range in state " + show(values));
      out[a.variable] = value;
    }
    return out;
  }

  std::vector<Outcome> outcomes(const Command& command, const PrismValues& values) {
    std::vector<Outcome> out;
    double sum = 0;
    for (const Update& u : command.updates) {
      const double probability = u.probability ? expressions_.value(*u.probability, values) : 1;
      if (!(probability >= 0 && probability <= 1))
        in_.fail(expressions_.where(*u.probability), "a probability outside of [0, 1] in state " + show(values));
      sum += probability;
      if (probability == 0) continue;
      const std::uint32_t target = state(updated(u, values));
      const auto same = std::find_if(out.begin(), out.end(), [&](const Outcome& o) { return o.target == target; });
      if (same == out.end())
        out.push_back({target, probability});
      else
        same->probability = std::min(1.0, same->probability + probability);
    }
    if (!(std::abs(sum - 1) <= 1e-9))
      in_.fail(command.where, "the probabilities do not add up to 1 in state " + show(values));
    return out;
  }

  Mdp explore() {
    for (const Label& l : labels_) vocabulary_.add(l.name);
    PrismValues first;
    for (const Variable& v : variables_) first.push_back(v.first);
    state(first);
    MdpBuilder builder(vocabulary_);
    std::vector<LetterId> letters;  // by state, for those whose values were looked at
    const auto letter = [&](std::uint32_t s) {
      while (letters.size() <= s) {
        expressions_.next_state();
        letters.push_back(builder.letter(label(states_[letters.size()])));
      }
      return letters[s];
    };
    for (std::uint32_t s = 0; s < states_.size(); ++s) {
      if (limits_.stop.stop_requested()) throw ReadingStopped{};
      if (states_.size() > limits_.states) in_.fail(variables_[0].name.where, "more states than the limit");
      const PrismValues values = states_[s];
      builder.add_state(show(values));
      add_choices(builder, s, values, letter);
    }
    const LetterId initial = letter(0);
    return std::move(builder).build(0, initial);
  }

  template <class LetterOf>
  void add_choices(MdpBuilder& builder, std::uint32_t s, const PrismValues& values, const LetterOf& letter) {
    bool any = false;
    const auto start_choice = [&](const std::string& action, ltl::Span where) {
      const double price = cost(action, values);
      if (!(price >= 0) || std::isinf(price))
        in_.fail(where, "a reward that is negative or infinite in state " + show(values));
      builder.add_choice(action, price);
    };
    for (const Command& command : commands_) {
      expressions_.next_state();
      if (expressions_.value(command.guard, values) == 0) continue;
      any = true;
      start_choice(command.action, command.where);
      for (const Outcome& o : outcomes(command, values)) builder.add_outcome(o.target, letter(o.target), o.probability);
    }
    if (any) return;
    expressions_.next_state();
    start_choice("stay", variables_[0].name.where);
    builder.add_outcome(s, letter(s));
  }

  PrismTokens in_;
  PrismExpressions expressions_;
  const ltl::Limits& limits_;
  std::vector<Variable> variables_;
  std::vector<Command> commands_;
  std::vector<Reward> rewards_;
  int rewards_rank_ = 0;
  std::vector<Label> labels_;
  double keys_ = 1;
  ltl::Vocabulary vocabulary_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<PrismValues> states_;
};

}  // namespace

Mdp parse_prism(std::string_view text, std::string_view source, const ltl::Limits& limits) {
  return ModelReader(text, source, limits).read();
}

}  // namespace waymark::plan
