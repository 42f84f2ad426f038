#include "tools/case_answer.hpp"

#include <sys/resource.h>

#include <iomanip>
#include <sstream>
#include <string_view>

#include "tools/shell/rounded.hpp"

namespace waymark::tools {
namespace {

using plan::CaseAnswer;
using Status = CaseAnswer::Status;

std::string_view name(Status status) {
  switch (status) {
    case Status::Solved: return "solved";
    case Status::Infeasible: return "infeasible";
    case Status::Exhausted: return "exhausted";
  }
  return {};
}

double peak_mib() {  // of the process so far
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

JsonObject route_json(const plan::NamedRoute& route) {
  JsonArray places, actions;
  for (const std::string& place : route.places) places.add(place);
  for (const std::string& action : route.actions) actions.add(action);
  return JsonObject().add("places", places).add("actions", actions).add("cost", route.cost);
}

std::string query_in_words(plan::CaseTask::Query query) {
  using Query = plan::CaseTask::Query;
  switch (query) {
    case Query::MaxProbability: return "greatest probability";
    case Query::MinProbability: return "least probability";
    case Query::MinCost: return "least expected cost";
    case Query::MaxCost: return "greatest expected cost";
    case Query::MinSteps: return "least cost";
    case Query::MinCycle: return "least cycle";
    case Query::LeastLasso: return "least lasso";
    case Query::Discounted: return "greatest discounted reward";
  }
  return {};
}

// Tasks of a case and lines of a file head the rows of a table; a formula that was typed has no name and is answered in
// words.
std::string heading(const plan::CaseTask& task) {
  std::ostringstream out;
  if (task.id.empty())
    out << query_in_words(task.query) << "  ";
  else
    out << std::left << std::setw(24) << task.id << ' ' << std::setw(6) << plan::name(task.query) << ' ';
  return out.str();
}

}  // namespace

ExitCode exit_code(Status status) {
  switch (status) {
    case Status::Solved: return ExitCode::Done;
    case Status::Infeasible: return ExitCode::No;
    case Status::Exhausted: return ExitCode::GaveUp;
  }
  return ExitCode::OurBug;
}

JsonObject case_json(const std::string& model, const plan::CaseTask& task, const CaseAnswer& answer) {
  const bool valued = answer.status != Status::Exhausted;
  const auto number = [&](double value) { return valued ? Json(value) : Json(); };
  JsonObject out;
  out.add("case", model).add("task", task.id.empty() ? "formula" : task.id).add("query", plan::name(task.query));
  using Logic = plan::CaseTask::Logic;
  if (!task.formula.empty()) out.add("formula", task.formula);
  if (!task.formula.empty() && (task.logic == Logic::Ltl || task.logic == Logic::Ltlf))
    out.add("semantics", task.logic == Logic::Ltl ? "infinite" : "finite");
  out.add("value", number(answer.value.middle()))
      .add("lower", number(answer.value.lower))
      .add("upper", number(answer.value.upper))
      .add("method", plan::name(answer.method))
      .add("automaton_states", answer.automaton_states)
      .add("product_states", answer.product_states)
      .add("product_edges", answer.product_edges)
      .add("seconds", JsonObject()
                          .add("automaton", answer.seconds.automaton)
                          .add("product", answer.seconds.product)
                          .add("solve", answer.seconds.solve))
      .add("peak_mib", peak_mib())
      .add("status", name(answer.status));
  if (answer.lasso)
    out.add("prefix", route_json(answer.lasso->prefix))
        .add("cycle", route_json(answer.lasso->cycle))
        .add("rounds", answer.lasso->rounds)
        .add("order", plan::name(answer.lasso->order));
  if (!answer.routes.empty()) {
    JsonArray routes;
    for (const plan::NamedRoute& route : answer.routes) routes.add(route_json(route));
    out.add("asked", answer.asked).add("routes", routes);
  }
  if (!answer.reason.empty()) out.add("reason", answer.reason);
  if (!answer.dropped.empty()) {
    JsonArray dropped;
    for (const std::string& formula : answer.dropped) dropped.add(formula);
    out.add("dropped", dropped);
  }
  return out;
}

std::string in_words(const plan::CaseTask& task, const CaseAnswer& answer) {
  std::ostringstream out;
  out << heading(task);
  if (answer.status == Status::Exhausted)
    out << "gave up: " << answer.reason;
  else
    out << std::setprecision(12) << answer.value.middle();
  if (answer.status == Status::Solved && answer.value.lower != answer.value.upper)
    out << "  " << between(answer.value.lower, answer.value.upper);
  if (answer.status == Status::Infeasible) out << "  infeasible: " << answer.reason;
  if (answer.status == Status::Solved && !answer.reason.empty()) out << "  " << answer.reason;
  for (std::size_t i = 0; i < answer.dropped.size(); ++i)
    out << (i == 0 ? "; possible without " : " and ") << answer.dropped[i];
  out << '\n';
  const auto walk = [&](const std::string& label, const plan::NamedRoute& route) {
    out << "  " << label << ", cost " << route.cost << ": " << route.places.front();
    for (std::size_t i = 0; i < route.actions.size(); ++i) {
      if (route.actions[i] != route.places[i + 1]) out << ' ' << route.actions[i];  // roads: "to where" is enough
      out << ' ' << route.places[i + 1];
    }
    out << '\n';
  };
  for (std::size_t i = 0; i < answer.routes.size(); ++i)
    walk(answer.routes.size() == 1 ? "route" : "route " + std::to_string(i + 1), answer.routes[i]);
  if (!answer.lasso) return out.str();
  walk("prefix", answer.lasso->prefix);
  walk(answer.lasso->rounds == 1 ? "cycle" : "cycle of " + std::to_string(answer.lasso->rounds) + " rounds",
       answer.lasso->cycle);
  return out.str();
}

Reply told(const std::string& model, const plan::CaseTask& task, const CaseAnswer& answer, bool json) {
  return {exit_code(answer.status), json ? case_json(model, task, answer).text() + '\n' : in_words(task, answer)};
}

}  // namespace waymark::tools
