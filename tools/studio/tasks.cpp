#include "tools/studio/tasks.hpp"

#include "libltl/text/print.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/hallways/hallway_things.hpp"
#include "libparser/grounding/understand.hpp"
#include "libparser/mention/mention.hpp"
#include "tools/alternatives.hpp"
#include "tools/attention.hpp"
#include "tools/heard.hpp"
#include "tools/picture.hpp"
#include "tools/plan_walk.hpp"
#include "tools/shell/options.hpp"
#include "tools/understood.hpp"

namespace waymark::studio {
namespace {

using tools::Json;
using tools::JsonArray;
using tools::JsonObject;

constexpr std::size_t shown_readings = 5;

std::vector<plan::PoseId> starts_of(const Request& request, const plan::Map& map) {
  return tools::start_poses(request.text_or("start", ""), map);
}

// The readings as a page shows them: in mathematical notation and in English.
JsonArray shown(const std::vector<parser::Reading>& readings, ltl::Semantics semantics, const plan::Map& map) {
  JsonArray out;
  for (std::size_t i = 0; i < std::min(readings.size(), shown_readings); ++i)
    out.add(JsonObject()
                .add("formula", ltl::print(readings[i].formula))
                .add("unicode", ltl::print(readings[i].formula, ltl::Style::Unicode))
                .add("english", tools::in_english(readings[i].formula, semantics, map))
                .add("probability", readings[i].probability)
                .add("reader", readings[i].program.empty() ? "commands" : "routes"));
  return out;
}

JsonObject lasso_answer(const tools::Heard& heard, const std::stop_token& stop) {
  const tools::WalkTask task{heard.map, heard.starts, heard.readings.front().formula};
  return tools::planned_lasso(task, {.head = tools::head_of_lasso(heard), .adds_route = true}, stop).json;
}

JsonObject route_answer(const tools::Heard& heard, double grounding, const std::stop_token& stop) {
  tools::StopWatch watch;
  const automata::Dfa dfa = tools::translate(heard.readings.front().formula, stop);
  const double translating = watch.lap();
  tools::Answer answer = tools::answer_of(heard, dfa, stop);
  if (heard.readings.size() > 1)
    answer.alternatives = tools::json_of(tools::alternatives(heard.readings, heard.map, heard.starts, stop), heard.map);
  answer.corridor_run.seconds.ground = grounding;
  answer.corridor_run.seconds.translate = translating;
  return tools::json_of(answer, heard.map);
}

struct Planned {  // a task of the request
  std::shared_ptr<const World> world;
  ltl::Arena arena;
  ltl::Formula formula;
  std::vector<plan::PoseId> starts;
  bool infinite;

  Planned(const Request& request, const Context& context)
      : world(context.worlds.of(request.text_or("map", "grid"))),
        arena(world->map.vocabulary()),
        formula(formula_of(request, arena)),
        starts(starts_of(request, world->map)),
        infinite(request.one_of("semantics", {"finite", "infinite"}) == "infinite") {}

  tools::WalkTask walk() const { return {world->map, starts, formula}; }
};

}  // namespace

JsonObject run_instruction(const Request& request, const Context& context) {
  const std::string text = request.text("instruction");
  const std::string semantics = request.one_of("semantics", {"auto", "finite", "infinite"});
  const auto world = context.worlds.of(request.text_or("map", "grid"));
  const plan::Map& map = world->map;
  const auto starts = starts_of(request, map);
  ltl::Arena arena(map.vocabulary());
  tools::StopWatch watch;
  const parser::Understanding understood =
      parser::understand(context.reader, text, world->executor, starts, arena,
                         {.least = request.flag("force") ? 0 : parser::least_understood});
  const double grounding = watch.lap();
  if (understood.readings.empty()) return tools::not_understood_json(text, map.name(), understood);
  const std::optional<std::string> no_id;
  const tools::Heard heard{no_id, text, map, starts, understood.readings, shown_readings};
  const bool infinite = semantics == "infinite" || (semantics == "auto" && understood.ongoing);
  const auto kind = infinite ? ltl::Semantics::Infinite : ltl::Semantics::Finite;
  JsonObject out = infinite ? lasso_answer(heard, context.stop) : route_answer(heard, grounding, context.stop);
  return out.add("shown", shown(understood.readings, kind, map));
}

JsonObject trace_words(const Request& request, const Context& context) {
  const std::string text = request.text("instruction");
  const auto world = context.worlds.of(request.text_or("map", "grid"));
  const std::vector<std::string> tokens = parser::tokenize(text);
  const parser::HallwayThings known(world->map.vocabulary());
  JsonArray words, mentions;
  for (const std::string& token : tokens) words.add(token);
  for (const parser::Mention& mention : parser::find_mentions(tokens, known.things()))
    mentions.add(JsonObject()
                     .add("begin", mention.begin)
                     .add("end", mention.end)
                     .add("name", known.things()[mention.thing].name));
  const bool asked = request.flag("attention") && tools::network_of(context.reader) != nullptr;
  const bool unknown = starts_of(request, world->map).size() > 1;
  return JsonObject()
      .add("words", words)
      .add("mentions", mentions)
      .add("explain", asked ? tools::json_of(tools::attended(context.reader, text, unknown)) : JsonArray());
}

JsonObject plan_formula(const Request& request, const Context& context) {
  const Planned task(request, context);
  if (task.infinite) return tools::planned_lasso(task.walk(), {.adds_route = true}, context.stop).json;
  tools::StopWatch watch;
  const automata::Dfa dfa = tools::translate(task.formula, context.stop);
  const double translating = watch.lap();
  tools::Answer answer{
      .formula = task.formula,
      .corridor_run = tools::run_corridor(task.world->map, dfa, task.formula, task.starts, context.stop)};
  answer.corridor_run.seconds.translate = translating;
  return tools::json_of(answer, task.world->map);
}

JsonObject draw_plan(const Request& request, const Context& context) {
  const Planned task(request, context);
  const render::Layout layout{.edges = most_drawn_edges, .seconds = most_layout_seconds, .stop = context.stop};
  tools::Picture picture{
      .map = &task.world->map, .instruction = request.text_or("instruction", ""), .formula = task.formula};
  if (task.infinite) {
    const tools::PlannedLasso found = tools::planned_lasso(task.walk(), {}, context.stop);
    picture.omega = &found.automaton;
    if (found.lasso) picture.route = *found.lasso;
    return JsonObject().add("svg", tools::drawn(picture, layout).svg);
  }
  const automata::Dfa dfa = tools::translate(task.formula, context.stop);
  picture.dfa = &dfa;
  picture.route = tools::shown(tools::run_corridor(task.world->map, dfa, task.formula, task.starts, context.stop));
  return JsonObject().add("svg", tools::drawn(picture, layout).svg);
}

}  // namespace waymark::studio
