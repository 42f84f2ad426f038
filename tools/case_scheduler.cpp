#include "tools/case_scheduler.hpp"

#include <utility>
#include <variant>

#include "libplan/model/formats/scheduler.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"

namespace waymark::tools {

void require_scheduler_of(const plan::PlanningCase& planning_case, const std::string& format) {
  if (format != "waymark" && !std::holds_alternative<plan::Mdp>(planning_case.model))
    throw UsageError("--strategy-format " + format + " is for a model whose states have numbers, not for a grid");
}

std::string scheduler_text(const plan::PlanningCase& planning_case, const plan::CaseAnswer& answer,
                           const std::string& format) {
  require_scheduler_of(planning_case, format);
  const auto& model = std::get<plan::Mdp>(planning_case.model);
  plan::Scheduler scheduler;
  scheduler.choices.resize(model.states());
  for (const plan::Decision& decision : answer.strategy->decisions) {
    auto& chosen = scheduler.choices[decision.state];
    if (decision.jump != plan::Decision::no_jump || (!chosen.empty() && chosen.front().choice != decision.choice))
      throw UsageError("the best strategy needs memory at " + decision.place +
                       ": compose the product (--format explicit) and plan on it, with a scheduler of its states");
    if (chosen.empty()) chosen.push_back({decision.choice, 1});
  }
  return plan::write_scheduler(scheduler,
                               format == "prism" ? plan::SchedulerFormat::Prism : plan::SchedulerFormat::Storm, model);
}

plan::PlanningCase scheduled(plan::PlanningCase planning_case, const std::string& file) {
  if (file.empty()) return planning_case;
  const auto* const model = std::get_if<plan::Mdp>(&planning_case.model);
  if (model == nullptr) throw UsageError("--scheduler is for a model whose states have numbers, not for a grid");
  return {
      planning_case.name, plan::induced(*model, plan::parse_scheduler(read_file(file), source_name(file), *model)), {}};
}

}  // namespace waymark::tools
