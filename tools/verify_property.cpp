#include "tools/verify_property.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libltl/text/parse.hpp"
#include "libplan/model/formats/prism_properties.hpp"
#include "libplan/model/formats/result_comment.hpp"
#include "libplan/world/json_reader.hpp"
#include "tools/plan_properties.hpp"
#include "tools/shell/json.hpp"
#include "tools/verify_value.hpp"

namespace waymark::tools {
namespace {

using Value = Claims::Value;
using plan::PrismProperty;

class OfProperty {
 public:
  OfProperty(Claims& claims, const plan::JsonReader& in, const PrismProperty& property, const ltl::Limits& limits)
      : claims_(claims), in_(in), property_(property), limits_(limits) {}

  void examine() {
    const std::string status = claims_.text("status");
    const bool known =
        status == "solved" || status == "infeasible" || status == "exhausted" || status == "not answered";
    if (!known) in_.fail("status", "expected \"solved\", \"infeasible\", \"exhausted\" or \"not answered\"");
    if (const Value& result = claims_.member("result"); !result.is_null()) result_ = in_.string(result, "result");
    if (status == "not answered") return not_answered();
    claims_.add(property_.fault.empty(), "the property can be answered");
    claims_.expect_text("query", plan::name(property_.task.query));
    const std::string& formula = property_.task.formula;
    const Value& said = claims_.member("formula");
    claims_.add(formula.empty() ? said.is_null() : said == formula, "formula is " + said.dump());
    value_ = claims_.number("value"), lower_ = claims_.number("lower"), upper_ = claims_.number("upper");
    const bool valued = value_ && lower_ && upper_;
    if (const Value& end = claims_.member("range_end"); !end.is_null())
      claims_.add(std::nullopt, "the range ends with " + end.dump()), end_ = in_.number(end, "range_end");
    if (valued && status == "solved") {
      bounds();
      value();
      agrees();
    } else {
      const bool nothing = !value_ && !lower_ && !upper_;
      claims_.add(nothing && (status != "solved" || is_curve()) && (status != "infeasible" || is_multi()),
                  "status \"" + status + "\" goes with the value");
      if (!result_) agrees();
      if (status == "infeasible") claims_.add(std::nullopt, "no strategy meets the bounds");
    }
    verdict(valued);
  }

 private:
  bool is_multi() const { return property_.ask == PrismProperty::Ask::Multi; }
  bool is_curve() const {
    return is_multi() && property_.nested.size() == 2 && property_.nested[0].comparison.empty() &&
           property_.nested[1].comparison.empty();
  }

  void not_answered() {
    claims_.add(property_.fault.empty() ? std::nullopt : std::optional(true), "the property has no answer");
    if (!property_.fault.empty()) claims_.expect_text("reason", property_.fault);
  }

  void bounds() {
    claims_.add(*lower_ <= *value_ && *value_ <= *upper_, "the value lies between its bounds");
    claims_.add(std::isinf(*lower_) ? *value_ == *lower_ : is_close(*value_, *lower_ + (*upper_ - *lower_) / 2),
                "the value is in their middle");
  }

  // The one question that progression judges: of a formula, without operators inside of it.
  void value() {
    const std::string_view query = plan::name(property_.task.query);
    const bool plain = property_.ask == PrismProperty::Ask::Task && !property_.steps && !property_.budget &&
                       property_.nested.empty() && property_.model && !property_.task.formula.empty();
    std::optional<Judged> judged;
    if (plain && !value_in_words(query).empty() && query != "steps") {
      ltl::Arena arena(std::visit([](const auto& m) { return m.letters().vocabulary(); }, property_.model->model));
      const ltl::Formula f = ltl::parse(property_.task.formula, arena, {.unknown = ltl::Unknown::Add});
      const bool finite = property_.task.logic == plan::CaseTask::Logic::Ltlf;
      const auto semantics = finite ? ltl::Semantics::Finite : ltl::Semantics::Infinite;
      judged = judge(*property_.model, f, semantics, query, limits_);
    }
    if (judged)
      return compare(claims_, std::string(value_in_words(query)), *lower_, *upper_,
                     bracket_of(*judged, query, limits_.stop));
    claims_.add(std::nullopt, "the value lies between " + Json(*lower_).text() + " and " + Json(*upper_).text());
  }

  // What the bounds tell of the comparison; a truth without one was not examined.
  void verdict(bool valued) {
    const Value& said = claims_.member("verdict");
    if (!said.is_null() && !said.is_boolean()) in_.fail("verdict", "expected true, false or null");
    const std::string what = "verdict is " + said.dump();
    const std::string& sign = property_.comparison;
    if (!property_.is_truth()) return claims_.add(said.is_null(), what);
    if (sign.empty() || !valued) return claims_.add(std::nullopt, what);
    const auto holds = [&](double v) {
      if (sign == ">=") return v >= property_.bound;
      if (sign == ">") return v > property_.bound;
      return sign == "<=" ? v <= property_.bound : v < property_.bound;
    };
    const bool undecided = holds(*lower_) != holds(*upper_);
    claims_.add(undecided ? said.is_null() : said == holds(*lower_), what + ", as the bounds are");
  }

  void agrees() {
    const Value& said = claims_.member("agrees");
    if (!result_) return claims_.add(said.is_null(), "there is no result to agree with");
    const Value& verdict = claims_.member("verdict");
    const auto found =
        plan::agrees(*result_, *value_, verdict.is_boolean() ? std::optional(verdict == true) : std::nullopt, end_);
    claims_.add(found ? said == *found : said.is_null(), "agrees is " + said.dump() + " of RESULT " + *result_);
  }

  Claims& claims_;
  const plan::JsonReader& in_;
  const PrismProperty& property_;
  const ltl::Limits& limits_;
  std::optional<std::string> result_;
  std::optional<double> value_, lower_, upper_, end_;
};

}  // namespace

void examine_property(Claims& claims, const plan::JsonReader& in, const CaseChoice& of, const ltl::Limits& limits) {
  const std::string text = claims.text("property");
  const bool in_file = !of.properties.empty();
  const std::vector<PrismProperty> all =
      in_file ? read_properties(of, limits) : properties_in(of, {text, "property"}, limits);
  const auto found = std::find_if(all.begin(), all.end(), [&](const PrismProperty& p) { return p.text == text; });
  if (found == all.end()) in.fail("property", (in_file ? of.properties : of.model) + " has no such property");
  OfProperty(claims, in, *found, limits).examine();
}

}  // namespace waymark::tools
