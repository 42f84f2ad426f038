// Properties of PRISM [KNP11]: what is asked of a model, and what its comments say the answer is.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/model/prism/read_prism.hpp"

namespace waymark::plan {

struct PrismProperty {             // one question
  enum class Ask : std::uint8_t {  // what is asked
    Task,                          // `task`, or rewards of `steps`
    Total,                         // the rewards of a run without end; its query is MinCost or MaxCost
    Discounted,                    // the same, a reward after t steps times discount^t, until `task.formula` holds
    Steady,                        // in the long run: the share of `task.formula`, or the mean reward
    States,                        // whether the initial state satisfies `task.formula`, which has no temporal operator
    Multi,                         // nested: objectives that one strategy is to meet; their queries say which way
    Filter                         // `summary` of what nested[0] asks over the states of nested[1]
  };
  Ask ask = Ask::Task;  // of this question
  std::string text;     // as the file has it
  std::string fault;    // why it is not answered, though others may be; else empty
  CaseTask task;        // about `model`; where there are steps, its query is MinCost or MaxCost alone
  std::optional<std::uint64_t> steps = {};         // C<=k, I=k: rewards of a run up to k, or after k steps
  bool instantaneous = false;                      // I
  double discount = 1;                             // C{discount=γ}, C{discount=γ}<=k, F{discount=γ} condition
  std::string comparison;                          // >=, >, <=, <; empty where a value is asked for
  double bound = 0;                                // that the value is compared with
  std::optional<std::string> result;               // of the comment "RESULT: …" before it, for these constants
  std::shared_ptr<const PlanningCase> model = {};  // with these rewards as costs; shared by properties
  std::optional<std::uint64_t> budget = {};  // F{"r"}<=B: of the costs until the formula holds, which has within_budget
  bool about_rewards = false;                // R, and not P or S
  std::string rewards = {};                  // the name of their structure
  std::string summary = {};                  // min, max, sum, avg, count, forall, exists, state, first, range
  std::vector<PrismProperty> nested = {};    // operators inside of it, whose texts are propositions of its formula
  bool is_truth() const;                     // is the answer true or false?
};

// The proposition of the moments until which no more than the budget was spent.
inline constexpr const char* within_budget = "within the budget";

struct PrismSource {              // a text and where it is from
  std::string_view text, source;  // of errors
};

// The file's P, R and S operators over path formulas of LTL with bounds on steps, whose conditions on states are
// written as in the model and may have operators inside; Boolean combinations of such; filters. Anything else is a
// property with a fault. All models have the same states in the same order. Throws as parse_prism.
std::vector<PrismProperty> parse_prism_properties(const PrismSource& model, const PrismSource& properties,
                                                  const PrismConstants& constants = {},
                                                  const ltl::Limits& limits = {.states = most_model_states});

}  // namespace waymark::plan
