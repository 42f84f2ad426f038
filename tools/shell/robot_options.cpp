#include "tools/shell/robot_options.hpp"

#include "tools/shell/terminal.hpp"

namespace waymark::tools {

void add_robot_options(Command command, RobotOptions& options) {
  command = command.in("Robot");
  command.add_option("--robot", options.robot, "what moves").one_of({"point", "disc", "car"}).show_default();
  command.add_option("--radius", options.radius, "of the disc, where neighbouring places are 1 apart")
      .not_negative()
      .show_default();
  command.add_option("--car-length", options.car.length, "of the car").positive().show_default();
  command.add_option("--car-width", options.car.width, "of the car").positive().show_default();
  command.add_option("--turning-radius", options.car.turning_radius, "of the car, at its rear axle")
      .positive()
      .show_default();
}

plan::Robot robot_of(const RobotOptions& options) {
  if (options.robot == "car") return options.car;
  return plan::Disc{options.robot == "point" ? 0 : options.radius};
}

void add_search_options(Command command, SearchOptions& options) {
  command = command.in("Planner");
  command
      .add_option("--planner", options.planner,
                  "route: the discrete route first, then a motion along it; ltl: OMPL's LTLPlanner on the automaton")
      .one_of({"route", "ltl"})
      .show_default();
  command.add_option("--sampler", options.sampler, "of legs that need it: Informed RRT* or BIT*")
      .one_of({"rrtstar", "bitstar"})
      .show_default();
  command.add_option("--iterations", options.iterations, "of sampling, for each leg that needs it")
      .between(1, 10'000'000)
      .show_default();
  command.add_option("--seed", options.seed, "of the sampling; the same seed gives the same motion (not with ltl)")
      .show_default();
  command.add_option("--seconds", options.seconds, "that the planner ltl is given").positive().show_default();
}

void add_shape_options(Command command, ShapeOptions& options) {
  command = command.in("Map");
  command.add_option("--width", options.width, "of hallways").show_default();
  command.add_option("--furniture", options.furniture, "radius of every piece; 0: none").show_default();
}

std::vector<std::string> arguments_of(const RobotOptions& robot, const SearchOptions& search,
                                      const ShapeOptions& shape) {
  const auto text = [](double value) { return Json(value).text(); };
  return {"--robot",          robot.robot,
          "--radius",         text(robot.radius),
          "--car-length",     text(robot.car.length),
          "--car-width",      text(robot.car.width),
          "--turning-radius", text(robot.car.turning_radius),
          "--planner",        search.planner,
          "--sampler",        search.sampler,
          "--iterations",     std::to_string(search.iterations),
          "--seed",           std::to_string(search.seed),
          "--seconds",        text(search.seconds),
          "--width",          text(shape.width),
          "--furniture",      text(shape.furniture)};
}

JsonArray line_of(const plan::Motion& motion) {
  JsonArray line;
  for (const plan::Configuration& c : motion.configurations) line.add(JsonArray().add(c.x).add(c.y).add(c.heading));
  return line;
}

void add_robot(JsonObject& json, const plan::Robot& robot) {
  if (const auto* disc = std::get_if<plan::Disc>(&robot)) {
    json.add("radius", disc->radius);
    return;
  }
  const auto& car = std::get<plan::Car>(robot);
  json.add("car",
           JsonObject().add("length", car.length).add("width", car.width).add("turning_radius", car.turning_radius));
}

std::string in_words(const plan::Robot& robot) {
  if (const auto* disc = std::get_if<plan::Disc>(&robot))
    return disc->radius == 0 ? "a point" : "a disc of radius " + fixed(disc->radius, 2);
  const auto& car = std::get<plan::Car>(robot);
  return "a car " + fixed(car.length, 2) + " by " + fixed(car.width, 2) + " with turning radius " +
         fixed(car.turning_radius, 2);
}

}  // namespace waymark::tools
