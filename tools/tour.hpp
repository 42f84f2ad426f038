// waymark move --workspace: a formula and a terrain → a certified tour of a robot with a body.
#pragma once
#include <string>

#include "libltl/formula.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/robot_options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct TourRequest {
  Text formula;
  NotationOptions notation;
  std::string workspace;  // a file
  std::string start;      // x,y or x,y,heading
  RobotOptions robot;
  SearchOptions search;
  std::string clearance;  // "centre" or "body": what keeps off regions that are avoided
  std::string svg;        // a file; empty: no picture
  bool json = false;
};
ExitCode run_tour(const TourRequest& request, const Session& session);

}  // namespace waymark::tools
