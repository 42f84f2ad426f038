#include "tools/comparing.hpp"

#include <cmath>
#include <iomanip>

#include "libltl/text/print.hpp"
#include "tools/answer.hpp"

namespace waymark::tools {
namespace {

Json estimate_json(const plan::Estimate& estimate) {
  return JsonObject().add("estimate", estimate.value).add("low", estimate.low).add("high", estimate.high);
}

JsonObject method_json(const MethodRuns& method) {
  const plan::Summary& s = method.summary;
  JsonObject json;
  json.add("method", method.name)
      .add("runs", s.runs)
      .add("success", estimate_json(s.success))
      .add("score", estimate_json(s.score))
      .add("cost_ratio", estimate_json(s.cost_ratio))
      .add("steps_to_90", estimate_json(s.to_90))
      .add("steps_to_optimum", estimate_json(s.to_optimum))
      .add("steps_to_stay", estimate_json(s.to_stay))
      .add("optimal", estimate_json(s.optimal))
      .add("updates", s.updates)
      .add("seconds", s.seconds);
  if (method.curve.empty()) return json;
  JsonArray curve;
  for (const plan::CurvePoint& p : method.curve)
    curve.add(JsonArray().add(p.steps).add(p.score.value).add(p.score.low).add(p.score.high));
  return json.add("curve", curve);
}

JsonObject& add(JsonObject& json, const Protocol& protocol) {
  return json.add("seeds", protocol.seeds)
      .add("steps", protocol.steps)
      .add("interval", protocol.interval)
      .add("horizon", protocol.horizon)
      .add("discount", protocol.discount);
}

// "1080", or "-" for what was never reached.
std::string whole(double value) { return std::isinf(value) ? "-" : fixed(value, 0); }

std::string with_interval(const plan::Estimate& e, std::string (*shown)(double)) {
  return shown(e.value) + " [" + shown(e.low) + ", " + shown(e.high) + "]";
}

void print_table(std::ostream& out, const std::vector<MethodRuns>& methods) {
  const auto cell = [&](const std::string& text, int width) { out << std::setw(width) << text; };
  const auto two = [](double v) { return std::isinf(v) ? std::string("-") : fixed(v, 2); };
  out << std::left << std::setw(17) << "method" << std::right;
  cell("success", 19), cell("cost/best", 19), cell("steps to 90 %", 22), cell("steps to best", 22);
  cell("best in", 9), cell("seconds", 9);
  out << '\n';
  for (const MethodRuns& method : methods) {
    const plan::Summary& s = method.summary;
    out << std::left << std::setw(17) << method.name << std::right;
    cell(with_interval(s.success, two), 19), cell(with_interval(s.cost_ratio, two), 19);
    cell(with_interval(s.to_90, whole), 22), cell(with_interval(s.to_optimum, whole), 22);
    cell(fixed(100 * s.optimal.value, 0) + " %", 9), cell(fixed(s.seconds, 3), 9);
    out << '\n';
  }
}

void print_protocol(std::ostream& out, const Protocol& protocol) {
  out << counted(protocol.seeds, "seed") << ", " << protocol.steps
      << " environment steps each; 95 % intervals in brackets;"
      << " -: not reached\n\n";
}

std::string shown(const plan::PolicyValue& optimum) {
  std::string text = "cost " + shown_cost(optimum.cost);
  if (optimum.probability < 1 - 1e-12) text += " where it succeeds, probability " + fixed(optimum.probability, 6);
  return text;
}

}  // namespace

plan::Training training_of(const plan::Method& method, const Protocol& protocol, std::size_t run,
                           const std::stop_token& stop) {
  plan::Training training{.steps = protocol.steps,
                          .interval = protocol.interval,
                          .horizon = protocol.horizon,
                          .discount = protocol.discount,
                          .seed = run + 1,
                          .stop = stop};
  if (!std::holds_alternative<plan::DqnMethod>(method.how)) return training;
  training.explore = 1;  // a network is not optimistic: it explores at random first, over half of the steps
  training.explore_steps = protocol.steps / 2;
  return training;
}

std::string title_of(const ComparedTask& task, ltl::Style style) {
  return task.formula ? ltl::print(*task.formula, style) : "the automaton of " + task.automaton;
}

std::string shown_cost(double cost) { return cost == std::round(cost) ? fixed(cost, 0) : fixed(cost, 4); }

JsonObject json_of(const ComparedTask& task, const Protocol& protocol) {
  JsonArray starts, methods;
  for (const plan::Pose& pose : task.starts) starts.add(JsonArray().add(pose.x).add(pose.y).add(pose.heading));
  if (!task.start.empty()) starts.add(task.start);
  for (const MethodRuns& method : task.methods) methods.add(method_json(method));
  JsonObject json;
  json.add("formula", task.formula ? Json(ltl::print(*task.formula)) : Json());
  if (!task.automaton.empty()) json.add("automaton", task.automaton);
  json.add("map", task.map);
  if (!task.task.empty()) json.add("task", task.task);
  json.add("starts", starts)
      .add("automaton_states", task.automaton_states)
      .add("product_states", task.product_states)
      .add("status", task.optimum.probability > 0 ? "solved" : "infeasible");
  add(json, protocol);
  JsonObject optimum;
  optimum.add("probability", task.optimum.probability)
      .add("cost", task.optimum.cost)
      .add("value", task.optimum.value)
      .add("sweeps", task.sweeps)
      .add("seconds", task.seconds_of_optimum);
  json.add("value_iteration", optimum);
  json.add("search", task.search
                         ? Json(JsonObject().add("cost", task.search->cost).add("seconds", task.search->seconds))
                         : Json());
  return json.add("methods", methods);
}

void print(std::ostream& out, const Terminal& terminal, const ComparedTask& task, const Protocol& protocol) {
  if (!task.task.empty()) out << "task     " << task.task << '\n';
  out << (task.formula ? "formula  " : "given    ")
      << title_of(task, terminal.unicode ? ltl::Style::Unicode : ltl::Style::Ascii) << "\nproduct  "
      << counted(task.product_states, "state") << ": map " << task.map << " and "
      << counted(task.automaton_states, "state") << " of the automaton\n";
  if (task.optimum.probability == 0) {
    out << "best     none: " << terminal.paint(Paint::Red, "no policy satisfies the task") << "\n\n";
    return;
  }
  out << "best     " << shown(task.optimum) << " by value iteration in " << fixed(1000 * task.seconds_of_optimum, 2)
      << " ms";
  if (task.search)
    out << "; cost " << shown_cost(task.search->cost) << " by search in " << fixed(1000 * task.search->seconds, 2)
        << " ms";
  out << '\n';
  if (task.is_over) out << "         the task is satisfied where it begins: nothing to learn\n";
  print_protocol(out, protocol);
  print_table(out, task.methods);
  out << '\n';
}

JsonObject json_of_suite(const std::vector<MethodRuns>& methods, std::size_t tasks, const Protocol& protocol) {
  JsonArray all;
  for (const MethodRuns& method : methods) all.add(method_json(method));
  JsonObject json;
  json.add("suite", true).add("tasks", tasks);
  return add(json, protocol).add("methods", all);
}

void print_suite(std::ostream& out, const std::vector<MethodRuns>& methods, std::size_t tasks,
                 const Protocol& protocol) {
  out << "suite    the runs of " << counted(tasks, "task") << " together\n";
  print_protocol(out, protocol);
  print_table(out, methods);
}

}  // namespace waymark::tools
