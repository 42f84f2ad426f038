#include "tools/plan_roads.hpp"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/model/formats/read_dimacs.hpp"
#include "libplan/roads/road_task.hpp"
#include "tools/answer.hpp"
#include "tools/case_answer.hpp"
#include "tools/plan_case.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {
namespace {

class RoadPlanning {
 public:
  RoadPlanning(const CaseChoice& choice, const std::string& start, const Session& session)
      : choice_(choice), name_(std::filesystem::path(choice.model).stem().string()), session_(session) {
    StopWatch watch;
    graph_.emplace(plan::read_dimacs(choice.model, start));
    read_ = watch.lap();
    if (choice.hierarchy.empty()) {
      plan::ContractionOptions quick;
      quick.quick = true;
      quick.stop = session.stop;
      hierarchy_.emplace(hierarchy_of(*graph_, quick));
    } else {
      auto file = ltl::open_text(choice.hierarchy);
      hierarchy_.emplace(plan::read_hierarchy(file, choice.hierarchy, *graph_));
    }
    prepared_ = watch.lap();
  }

  Reply answer(const plan::CaseTask& task, const TextWatch& watch, const plan::GivenAutomaton* given) const {
    const plan::CaseOptions options{.method = method_of(choice_.method), .route = true, .stop = watch.token()};
    StopWatch whole;
    plan::CaseAnswer answer = plan::answer(*graph_, *hierarchy_, task, options, given);
    if (answer.status == plan::CaseAnswer::Status::Exhausted && session_.stop.stop_requested()) throw Interrupted();
    if (answer.status == plan::CaseAnswer::Status::Exhausted && watch.overrun() != ltl::Overrun::None)
      answer.reason += " (" + amount(watch.overrun(), choice_.parallel.limits) + ')';
    const double seconds = whole.lap();
    if (!choice_.json) return {exit_code(answer.status), in_words(task, answer)};
    JsonObject json = case_json(name_, task, answer);
    json.add("roads",
             JsonObject()
                 .add("nodes", graph_->nodes())
                 .add("arcs", graph_->arcs())
                 .add("core", graph_->nodes() - hierarchy_->core())
                 .add("hierarchy_arcs", hierarchy_->arcs())
                 .add("seconds", JsonObject().add("read", read_).add("hierarchy", prepared_).add("task", seconds)));
    return {exit_code(answer.status), json.text() + '\n'};
  }
  const ltl::Vocabulary& vocabulary() const { return graph_->letters().vocabulary(); }

 private:
  const CaseChoice& choice_;
  std::string name_;
  const Session& session_;
  std::optional<plan::RoadGraph> graph_;
  std::optional<plan::RoadHierarchy> hierarchy_;
  double read_ = 0, prepared_ = 0;  // seconds
};

}  // namespace

bool is_road_file(const CaseChoice& choice) { return std::filesystem::path(choice.model).extension() == ".gr"; }

bool is_on_roads(const CaseChoice& choice) {
  return is_road_file(choice) && choice.hierarchy != "none" && (choice.query == "rmin" || choice.query == "steps") &&
         choice.top == 1 && choice.strategy.empty() && choice.scheduler.empty() && choice.properties.empty() &&
         (choice.constants + choice.rewards).empty() && (choice.method == "best" || choice.method == "search");
}

plan::RoadHierarchy hierarchy_of(const plan::RoadGraph& graph, const plan::ContractionOptions& options) {
  try {
    auto hierarchy = plan::contract(graph, options);
    if (!hierarchy) throw Interrupted();
    return std::move(*hierarchy);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

ExitCode plan_roads(const CaseChoice& choice, const std::string& start, const TextOptions& formulas,
                    const Session& session) {
  const RoadPlanning planning(choice, start, session);
  if (!choice.automaton.empty()) {
    const plan::GivenAutomaton given =
        plan::read_given_automaton(read_file(choice.automaton), source_name(choice.automaton));
    return answer_in_parallel(1, session.stop, choice.parallel, [&](std::size_t, const TextWatch& watch) {
      return planning.answer(task_of({.text = "", .source = ""}, choice), watch, &given);
    });
  }
  TextReader texts(formulas, "formula");
  return answer_in_parallel(
      texts, session.stop, choice.parallel,
      [&](const Text& text, const TextWatch& watch) {
        try {
          ltl::Arena arena(planning.vocabulary());
          ltl::parse(text.text, arena, {.unknown = ltl::Unknown::Reject});
          return planning.answer(task_of(text, choice), watch, nullptr);
        } catch (const ltl::SyntaxError& error) {
          if (text.source.empty()) throw;
          throw error.in(text.source, text.line);
        }
      },
      [&](const Text& text, const std::string& message) {
        return choice.json ? json_error(text.line, message).text() + '\n' : std::string();
      });
}

}  // namespace waymark::tools
