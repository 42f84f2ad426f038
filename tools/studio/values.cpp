#include "tools/studio/values.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "libltl/text/print.hpp"
#include "libplan/learn/comparison.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/model/prism/write_prism.hpp"
#include "libplan/product/explicit_product.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/decide.hpp"
#include "tools/answer.hpp"
#include "tools/comparing.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/options.hpp"

namespace waymark::studio {
namespace {

using tools::Json;
using tools::JsonArray;
using tools::JsonObject;

constexpr std::size_t most_pairs = 200'000;  // of pose and state: more are no answer for a page

// A finite task from one pose, where FORWARD goes aside with probability `slip`, half to the left, half to the right.
struct Noisy {
  std::shared_ptr<const World> world;
  ltl::Arena arena;
  ltl::Formula formula;
  plan::PoseId start;
  plan::MapNoise noise;

  Noisy(const Request& request, const Context& context)
      : world(context.worlds.of(request.text_or("map", "grid"))),
        arena(world->map.vocabulary()),
        formula(formula_of(request, arena)),
        start(tools::start_poses(request.text_or("start", ""), world->map).front()) {
    const double slip = request.number_or("slip", 0, 0, 0.9);
    noise.forward = {.forward = 1 - slip, .left = slip / 2, .right = slip / 2, .back = 0};
  }
};

JsonArray pose_json(const plan::Map& map, std::uint32_t place) {
  const plan::Pose pose = map.pose(plan::PoseId{place});
  return JsonArray().add(pose.x).add(pose.y).add(pose.heading);
}

// By state of the automaton, as it is drawn: pose, value, action.
JsonArray poses_json(const plan::ProductMdp<plan::Mdp>& product, const plan::Decided& decided, bool cost,
                     const plan::Map& map) {
  std::map<std::uint32_t, JsonArray> by_state;
  product.for_each_state([&](const auto& s) {
    const std::uint32_t choice = decided.strategy.choice[s.index];
    const bool goal = product.is_goal(s), acts = choice != plan::Strategy::none && !goal;
    const double value = cost && !acts && !goal ? INFINITY : decided.values[s.index];
    by_state[product.task().origin(s.task)].add(
        JsonObject()
            .add("pose", pose_json(map, s.place))
            .add("value", std::isinf(value) ? Json() : Json(value))
            .add("action", acts ? Json(product.model().action(s.place, choice)) : Json()));
  });
  JsonArray out;
  for (const auto& [state, poses] : by_state) out.add(JsonObject().add("state", state).add("poses", poses));
  return out;
}

plan::ProductMdp<plan::Mdp> explored(const plan::Mdp& mdp, const plan::TaskTable& table, const std::stop_token& stop) {
  auto product = plan::ProductMdp<plan::Mdp>::explore(mdp, table, {.states = most_pairs, .stop = stop});
  if (stop.stop_requested()) throw tools::Interrupted();
  if (!product) throw tools::GaveUp("the product with the map is too large");
  return std::move(*product);
}

const plan::Method& method_of(const std::vector<plan::Method>& methods, const std::string& name) {
  const auto found =
      std::find_if(methods.begin(), methods.end(), [&](const plan::Method& m) { return m.name == name; });
  if (found != methods.end()) return *found;
  std::string known;
  for (const plan::Method& method : methods) known += (known.empty() ? "" : ", ") + method.name;
  throw RequestError(400, "request", "'method' is one of: " + known);
}

}  // namespace

JsonObject value_poses(const Request& request, const Context& context) {
  const Noisy task(request, context);
  const std::string query = request.one_of("query", {"pmax", "mincost"});
  const plan::Map& map = task.world->map;
  const automata::Dfa dfa = tools::translate(task.formula, context.stop);
  const plan::Mdp mdp = plan::mdp_of(map, task.start, task.noise);
  const plan::TaskTable table(dfa, mdp.letters());
  const auto product = explored(mdp, table, context.stop);
  const plan::IterationOptions limits{.keep_values = true, .stop = context.stop};
  const bool cost = query == "mincost";
  const auto decided = cost ? plan::least_cost(product, limits) : plan::greatest_probability(product, limits);
  if (!decided) throw tools::GaveUp("value iteration came to no end within its limits");
  const bool any = !decided->values.empty();  // else the value at the start says it all
  return JsonObject()
      .add("formula", ltl::print(task.formula))
      .add("map", map.name())
      .add("query", query)
      .add("value", decided->value.middle())
      .add("lower", decided->value.lower)
      .add("upper", decided->value.upper)
      .add("sweeps", decided->sweeps)
      .add("automaton", tools::json_of(tools::size_of(dfa)))
      .add("product", JsonObject().add("states", product.states()).add("edges", product.edges()))
      .add("states", any ? poses_json(product, *decided, cost, map) : JsonArray());
}

JsonObject write_product(const Request& request, const Context& context) {
  const Noisy task(request, context);
  const automata::Dfa dfa = tools::translate(task.formula, context.stop);
  const plan::Mdp mdp = plan::mdp_of(task.world->map, task.start, task.noise);
  const plan::TaskTable table(dfa, mdp.letters());
  const auto product = explored(mdp, table, context.stop);
  return JsonObject().add("format", "prism").add("text", plan::write_prism(plan::explicit_product(product)));
}

JsonObject learn_task(const Request& request, const Context& context) {
  const Noisy task(request, context);
  const auto methods = plan::learning_methods();
  const plan::Method& method = method_of(methods, request.text_or("method", "q-learning"));
  const auto steps = request.count_or("steps", 5'000, 100, 50'000);
  const auto run = request.count_or("seed", 1, 1, 1'000) - 1;
  const automata::Dfa dfa = tools::translate(task.formula, context.stop);
  const plan::LearningTask learning(task.world->map, dfa, task.formula, {&task.start, 1}, {.noise = task.noise});
  const plan::PolicyValue best = learning.optimum().value;
  JsonObject out;
  out.add("formula", ltl::print(task.formula))
      .add("method", method.name)
      .add("seed", run + 1)
      .add("optimum", JsonObject()
                          .add("probability", best.probability)
                          .add("cost", std::isinf(best.cost) ? Json() : Json(best.cost)));
  JsonArray points;
  if (best.probability > 0 && !learning.product().is_over()) {
    const tools::Protocol protocol{.seeds = 1, .steps = steps, .interval = std::max<std::size_t>(1, steps / 50)};
    const auto curve = learning.run(method, tools::training_of(method, protocol, run, context.stop));
    if (context.stop.stop_requested()) throw tools::Interrupted();
    for (const plan::Checkpoint& at : curve.checkpoints)
      points.add(JsonObject()
                     .add("steps", at.steps)
                     .add("score", plan::score(at.value, best))
                     .add("probability", at.value.probability));
  }
  return out.add("curve", points);
}

}  // namespace waymark::studio
