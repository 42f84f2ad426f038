#include "libplan/model/formats/prism_properties.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"
#include "libplan/model/formats/path_formula.hpp"
#include "libplan/model/formats/result_comment.hpp"
#include "libplan/model/formats/unanswered.hpp"
#include "libplan/model/prism/default_labels.hpp"

namespace waymark::plan {
namespace {

using Id = PrismExpressions::Id;
using Op = PrismExpressions::Op;
using Type = PrismExpressions::Type;

class PropertiesReader {
 public:
  PropertiesReader(const PrismSource& model, const PrismSource& properties, const PrismConstants& constants,
                   const ltl::Limits& limits)
      : text_(properties.text),
        name_(model.source),
        model_(model.text, model.source),
        in_(properties.text, properties.source),
        expressions_(model_),
        constants_(constants),
        limits_(limits),
        program_(read_prism_program(model_, expressions_, constants)),
        labels_(program_.labels) {}

  std::vector<PrismProperty> read() {
    define_labels_of_every_model(program_, expressions_);
    for (const PrismProgram::Label& l : program_.labels) names_.erase(l.name);
    expressions_.speak_of(in_);
    expressions_.read_queries([this] { return query_inside(); });
    while (in_.peek().kind != PrismToken::Kind::End) item();
    expect_given(in_, constants_, program_.given);
    expressions_.speak_of(model_);
    for (PrismProperty& p : out_)
      if (p.fault.empty()) give_model(p);
    return std::move(out_);
  }

 private:
  void item() {
    if (in_.accept(";")) return;
    if (in_.accept("const")) return read_prism_constant(in_, expressions_, constants_, program_.given);
    if (in_.accept("label")) {
      const PrismToken name = in_.next();
      if (name.kind != PrismToken::Kind::String) in_.fail(name.where, "expected the name of a label in quotes");
      in_.expect("=");
      names_.erase(std::string(name.text));
      expressions_.define_label(name, expressions_.parse(in_));
      in_.expect(";");
      return;
    }
    property();
  }

  bool at_operator() const {
    for (const char* word : {"P", "Pmin", "Pmax", "R", "Rmin", "Rmax", "S"})
      if (in_.is(word)) return true;
    return (in_.is("filter") || in_.is("multi")) && in_.is("(", 1);
  }

  void property() {
    const std::size_t begin = in_.peek().where.begin;
    PrismProperty out;
    out.result = result_before(std::string_view(text_).substr(from_, begin - from_), constants_);
    in_property_ = true;
    try {
      if (in_.peek().kind == PrismToken::Kind::String && in_.is(":", 1)) in_.next(), in_.next();
      const std::optional<std::string> said = out.result;
      out = state_formula();
      out.result = said;
    } catch (const ltl::SyntaxError& error) {
      out.fault = error.message();
    } catch (const std::invalid_argument& error) {
      out.fault = error.what();
    }
    in_property_ = false;
    std::size_t end = last_;
    if (!out.fault.empty()) {  // the rest of it is skipped
      const auto line = [&](std::size_t at) { return text_.substr(0, at).rfind('\n'); };
      std::size_t previous = begin;
      while (in_.peek().kind != PrismToken::Kind::End && !in_.is(";") &&
             !(at_operator() && in_.peek().where.begin != begin && line(in_.peek().where.begin) != line(previous))) {
        previous = end = in_.next().where.end;
      }
    }
    if (!out.fault.empty()) inside_.clear(), old_filter_.reset();
    out.text = text_.substr(begin, std::max(end, begin) - begin);
    from_ = std::max(end, begin);
    out_.push_back(std::move(out));
  }

  // An operator alone, or a Boolean combination of operators and conditions.
  PrismProperty state_formula() {
    const std::vector<PrismProperty> outside = std::exchange(inside_, {});
    const Id e = expressions_.parse(in_);
    last_ = expressions_.where(e).end;
    PrismProperty out;
    if (expressions_.op(e) == Op::Query && inside_.size() == 1) {
      out = std::move(inside_[0]);
    } else {
      if (!std::all_of(inside_.begin(), inside_.end(), [](const PrismProperty& p) { return p.is_truth(); }))
        throw std::invalid_argument("arithmetic over operators");
      expressions_.expect_type(e, Type::Bool);
      out.ask = PrismProperty::Ask::States;
      out.task.formula = formula(e);
      out.nested = std::move(inside_);
    }
    inside_ = outside;
    last_ = expressions_.where(e).end;
    return out;
  }

  std::string formula(Id e) {
    return path_formula(
        expressions_, e, [this](Id condition) { return name_of(condition); }, labels_);
  }

  // An operator among the parts of an expression: it joins `inside_`.
  std::optional<Id> query_inside() {
    if (in_property_) refuse_unanswered(in_, names_);
    if (!in_property_ || !at_operator()) return std::nullopt;
    const std::size_t begin = in_.peek().where.begin;
    std::vector<PrismProperty> outside = std::exchange(inside_, {});
    PrismProperty out;
    in_.is("filter") ? filter(out) : in_.is("multi") ? multi(out) : question(out);
    const ltl::Span where{begin, last_};
    out.text = std::string(text_.substr(begin, last_ - begin));
    if (out.ask != PrismProperty::Ask::Filter && out.ask != PrismProperty::Ask::Multi) out.nested = std::move(inside_);
    if (old_filter_) {
      PrismProperty of = *std::exchange(old_filter_, std::nullopt);
      if (of.summary != "state" && out.is_truth()) throw std::invalid_argument("a filter {min} of truth values");
      of.text = out.text;
      of.nested.insert(of.nested.begin(), std::move(out));
      out = std::move(of);
    }
    const bool truth = !out.comparison.empty() || out.is_truth();
    inside_ = std::move(outside);
    inside_.push_back(std::move(out));
    return expressions_.query(truth ? Type::Bool : Type::Double, where);
  }

  // multi(objective, …): P over a path formula and R over C, asked for or bounded: some strategy is to meet the bound.
  void multi(PrismProperty& out) {
    out.ask = PrismProperty::Ask::Multi;
    in_.next(), in_.next();
    do {
      if (!at_operator() || in_.is("filter") || in_.is("multi")) in_.fail("expected P or R");
      PrismProperty& objective = out.nested.emplace_back();
      const std::size_t begin = in_.peek().where.begin;
      question(objective);
      if (old_filter_) throw std::invalid_argument("a filter inside of an objective");
      objective.text = std::string(text_.substr(begin, last_ - begin));
      if (objective.budget) throw std::invalid_argument("an objective with a budget");
      if (!inside_.empty()) throw std::invalid_argument("an operator inside of an objective");
      if (objective.comparison.size() == 1) throw std::invalid_argument("a strict bound of an objective");
      const bool total = objective.about_rewards && objective.ask == PrismProperty::Ask::Total;
      if (!total && (objective.about_rewards || objective.ask != PrismProperty::Ask::Task))
        throw std::invalid_argument("objectives are probabilities and total rewards (C)");
      using Query = CaseTask::Query;
      Query& query = objective.task.query;
      const bool most = query == Query::MaxProbability || query == Query::MaxCost;
      const bool greatest = objective.comparison.empty() ? most : objective.comparison[0] == '>';
      if (greatest) query = total ? Query::MaxCost : Query::MaxProbability;
      if (!greatest) query = total ? Query::MinCost : Query::MinProbability;
    } while (in_.accept(","));
    last_ = in_.expect(")").where.end;
    if (out.nested.size() > 2) throw std::invalid_argument("more than two objectives");
  }

  // filter(summary, what, states)
  void filter(PrismProperty& out) {
    static constexpr std::pair<std::string_view, std::string_view> summaries[] = {
        {"min", "min"},     {"max", "max"},     {"sum", "sum"},       {"+", "sum"},      {"avg", "avg"},
        {"average", "avg"}, {"count", "count"}, {"forall", "forall"}, {"&", "forall"},   {"exists", "exists"},
        {"|", "exists"},    {"state", "state"}, {"first", "first"},   {"range", "range"}};
    out.ask = PrismProperty::Ask::Filter;
    in_.next(), in_.next();
    const PrismToken word = in_.next();
    for (const auto& [name, summary] : summaries)
      if (name == word.text) out.summary = summary;
    if (out.summary.empty()) throw std::invalid_argument("a filter that asks for " + std::string(word.text));
    in_.expect(",");
    out.nested.push_back(state_formula());
    PrismProperty all;
    all.ask = PrismProperty::Ask::States;
    all.task.formula = "true";
    out.nested.push_back(in_.accept(",") ? state_formula() : all);
    if (!out.nested[1].is_truth()) throw std::invalid_argument("the states of a filter are a condition");
    last_ = in_.expect(")").where.end;
    const bool of_truths = out.summary == "count" || out.summary == "forall" || out.summary == "exists";
    const bool any = out.summary == "state" || out.summary == "first";
    if (!any && of_truths != out.nested[0].is_truth())
      throw std::invalid_argument("the filter " + out.summary + " of " + (of_truths ? "numbers" : "truth values"));
  }

  void question(PrismProperty& out) {
    const std::string_view word = in_.next().text;
    const bool steady = word == "S", probability = word[0] == 'P' || steady;
    std::string_view optimum = word.substr(1);
    out.about_rewards = !probability;
    if (!probability && in_.accept("{")) {
      out.rewards = structure(in_.next());
      in_.expect("}");
    }
    if (optimum.empty() && (in_.is("min") || in_.is("max"))) optimum = in_.next().text;
    if (!in_.accept("=")) {
      for (const std::string_view comparison : {">=", "<=", ">", "<"})
        if (out.comparison.empty() && in_.accept(comparison)) out.comparison = comparison;
      if (out.comparison.empty()) in_.fail("expected =? or a comparison");
      const Id bound = expressions_.parse(in_);
      expressions_.expect_type(bound, Type::Double);
      out.bound = expressions_.constant(bound);
    } else {
      in_.expect("?");
    }
    in_.expect("[");
    if (steady || (!probability && in_.is("S"))) {
      if (program_.is_mdp) throw std::invalid_argument("the long run of a decision process");
      out.ask = PrismProperty::Ask::Steady;
      if (!steady) in_.next();
    }
    if (!probability && in_.is("F") && at_discount()) {
      discounted_target(out);
    } else if (probability || (out.ask == PrismProperty::Ask::Task && !steps(out))) {
      const Id path = steady ? expressions_.parse(in_) : expressions_.parse_path(in_);
      expressions_.expect_type(path, Type::Bool);
      out.task.formula = spends(path, out) ? budgeted(path) : formula(path);
    }
    if (in_.is("{")) old_filter();
    last_ = in_.expect("]").where.end;
    out.task.query = query(probability, optimum, out.comparison);
    if (!probability && out.rewards.empty() && !program_.rewards.empty()) out.rewards = program_.rewards[0].name;
    if (!probability && !known(out.rewards)) throw std::invalid_argument("there are no rewards of this name");
  }

  // P=? [ φ {states} ], with {min} or {max} or both behind it: filter(state, …), filter(min, …), …
  void old_filter() {
    in_.expect("{");
    PrismProperty of;
    of.ask = PrismProperty::Ask::Filter;
    of.summary = "state";
    of.nested.push_back(state_formula());
    in_.expect("}");
    while (in_.accept("{")) {
      const bool most = in_.is("max");
      if (!most && !in_.is("min")) in_.fail("expected min or max");
      in_.next();
      of.summary = of.summary == "state" ? (most ? "max" : "min") : "range";
      in_.expect("}");
    }
    if (!of.nested[0].is_truth()) throw std::invalid_argument("the states of a filter are a condition");
    old_filter_ = std::move(of);
  }

  // F{"r"}<=B φ and φ U{"r"}<=B ψ, alone.
  bool spends(Id path, PrismProperty& out) {
    const Op op = expressions_.op(path);
    const auto* window = op == Op::Eventually || op == Op::Until ? expressions_.window(path) : nullptr;
    if (window == nullptr || !window->rewards || window->least || !window->most || out.about_rewards) return false;
    const PrismExpressions::Window bounds = *window;
    expressions_.expect_type(*bounds.most, Type::Int);
    const double most = expressions_.constant(*bounds.most) - (bounds.below_most ? 1 : 0);
    if (!(most >= 0 && most <= 1e9)) throw std::invalid_argument("a bound on rewards outside of [0, 10^9]");
    if (!known(*bounds.rewards)) throw std::invalid_argument("there are no rewards of this name");
    out.budget = static_cast<std::uint64_t>(most);
    out.rewards = *bounds.rewards;
    return true;
  }
  std::string budgeted(Id path) {
    const std::vector<Id> parts = expressions_.operands(path);
    const std::string goal = "((" + formula(parts.back()) + ") & \"" + within_budget + "\")";
    return parts.size() == 1 ? "F " + goal : '(' + formula(parts[0]) + ") U " + goal;
  }

  std::string structure(const PrismToken& token) const {  // by its name, or its number from 1
    if (token.kind != PrismToken::Kind::Number) return std::string(token.text);
    for (std::size_t i = 0; i < program_.rewards.size(); ++i)
      if (std::to_string(i + 1) == token.text) return program_.rewards[i].name;
    throw std::invalid_argument("there are no rewards of this number");
  }

  std::string name_of(Id condition) const {
    const ltl::Span where = expressions_.where(condition);
    std::string name(text_.substr(where.begin, where.end - where.begin));
    if (expressions_.op(condition) == Op::Name) name += "=true";  // a label may have this name
    return name;
  }

  bool at_discount() { return in_.is("{", 1) && in_.is("discount", 2); }
  void discount(PrismProperty& out) {  // {discount=γ}
    for (int i = 0; i < 3; ++i) in_.next();
    const Id factor = expressions_.parse(in_);
    expressions_.expect_type(factor, Type::Double);
    out.discount = expressions_.constant(factor);
    if (!(out.discount >= 0 && out.discount <= 1)) throw std::invalid_argument("a discount outside of [0, 1]");
    in_.expect("}");
  }

  // F{discount=γ} condition
  void discounted_target(PrismProperty& out) {
    in_.next(), discount(out);
    const Id target = expressions_.parse_path(in_);
    expressions_.expect_type(target, Type::Bool);
    if (expressions_.is_temporal(target)) throw std::invalid_argument("discounted rewards until a path formula holds");
    out.ask = out.discount == 1 ? PrismProperty::Ask::Task : PrismProperty::Ask::Discounted;
    out.task.formula = out.discount == 1 ? "F (" + formula(target) + ')' : formula(target);
  }

  // C, C<=k and I=k, of which C may be discounted.
  bool steps(PrismProperty& out) {
    if (!in_.is("C") && !in_.is("I")) return false;
    const bool discounted = in_.is("C") && at_discount();
    out.instantaneous = in_.next().text == "I";
    if (discounted) discount(out);
    if (!out.instantaneous && !in_.is("<=")) {
      out.ask = out.discount == 1 ? PrismProperty::Ask::Total : PrismProperty::Ask::Discounted;
      if (out.ask == PrismProperty::Ask::Discounted) out.task.formula = "false";
      return true;
    }
    in_.expect(out.instantaneous ? "=" : "<=");
    const Id bound = expressions_.parse(in_);
    expressions_.expect_type(bound, Type::Int);
    const double found = expressions_.constant(bound);
    if (!(found >= 0 && found <= 1e9)) throw std::invalid_argument("a bound on steps outside of [0, 10^9]");
    out.steps = static_cast<std::uint64_t>(found);
    return true;
  }

  // What a comparison is about: the worst strategy.
  CaseTask::Query query(bool probability, std::string_view optimum, std::string_view comparison) const {
    if (!optimum.empty() && !comparison.empty()) throw std::invalid_argument("an optimum that is compared");
    if (program_.is_mdp && optimum.empty() && comparison.empty())
      throw std::invalid_argument("of a decision process min or max is asked");
    const bool greatest = optimum == "max" || (optimum.empty() && comparison.starts_with('<'));
    if (probability)
      return greatest || !program_.is_mdp ? CaseTask::Query::MaxProbability : CaseTask::Query::MinProbability;
    return greatest && program_.is_mdp ? CaseTask::Query::MaxCost : CaseTask::Query::MinCost;
  }

  bool known(const std::string& structure) const {
    return std::any_of(program_.rewards.begin(), program_.rewards.end(),
                       [&](const PrismProgram::Rewards& r) { return r.name == structure; });
  }

  void give_model(PrismProperty& p) {
    p.model = model(p.rewards, p.instantaneous);
    for (PrismProperty& inside : p.nested) give_model(inside);
  }

  std::shared_ptr<const PlanningCase> model(const std::string& structure, bool state_rewards_only) {
    std::shared_ptr<const PlanningCase>& made = models_[{structure, state_rewards_only}];
    if (made) return made;
    PrismView view{labels_, {}, state_rewards_only, &in_};
    for (std::size_t i = 0; i < program_.rewards.size() && !structure.empty(); ++i)
      if (program_.rewards[i].name == structure && !view.rewards) view.rewards = i;
    if (structure.empty() && !program_.rewards.empty() && program_.rewards[0].name.empty()) view.rewards = 0;
    made = std::make_shared<const PlanningCase>(
        PlanningCase{std::string(name_), explore(program_, expressions_, model_, view, limits_), {}});
    return made;
  }

  std::string_view text_, name_;
  PrismTokens model_, in_;
  PrismExpressions expressions_;
  const PrismConstants& constants_;
  const ltl::Limits& limits_;
  PrismProgram program_;
  std::vector<PrismProgram::Label> labels_;  // that properties speak of
  std::vector<PrismProperty> inside_;        // of what is read now, in the order of the text
  std::vector<PrismProperty> out_;
  std::map<std::pair<std::string, bool>, std::shared_ptr<const PlanningCase>> models_;  // by structure
  PropertyNames names_ = property_names(in_);
  std::optional<PrismProperty> old_filter_;  // of the operator that is read
  bool in_property_ = false;
  std::size_t from_ = 0, last_ = 0;  // where the last property ended
};

}  // namespace

std::vector<PrismProperty> parse_prism_properties(const PrismSource& model, const PrismSource& properties,
                                                  const PrismConstants& constants, const ltl::Limits& limits) {
  ltl::refuse_foreign(properties.text, properties.source, "properties in the language of PRISM");
  return PropertiesReader(model, properties, constants, limits).read();
}

}  // namespace waymark::plan
