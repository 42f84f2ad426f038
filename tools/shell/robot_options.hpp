// Options that say what moves and how its motion is found, shared by `waymark move` and the helpers it starts.
#pragma once
#include <string>
#include <vector>

#include "libplan/motion/motion.hpp"
#include "tools/shell/command.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

struct RobotOptions {
  std::string robot = "disc";  // point, disc, car
  double radius = plan::Disc{}.radius;
  plan::Car car;
};
void add_robot_options(Command command, RobotOptions& options);
plan::Robot robot_of(const RobotOptions& options);

struct SearchOptions {
  std::string planner = "route";    // route: the discrete route first; ltl: OMPL's LTLPlanner
  std::string sampler = "rrtstar";  // rrtstar, bitstar
  std::size_t iterations = 1'000;
  std::uint64_t seed = 1;
  double seconds = 30;
};
void add_search_options(Command command, SearchOptions& options);

struct ShapeOptions {
  double width = 0.4, furniture = 0.07;
};
void add_shape_options(Command command, ShapeOptions& options);

// As the command line of a helper.
std::vector<std::string> arguments_of(const RobotOptions& robot, const SearchOptions& search,
                                      const ShapeOptions& shape);

JsonArray line_of(const plan::Motion& motion);               // the configurations
void add_robot(JsonObject& json, const plan::Robot& robot);  // "radius" or "car"
std::string in_words(const plan::Robot& robot);              // "a disc of radius 0.05"

}  // namespace waymark::tools
