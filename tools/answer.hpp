// The answer of `run` and `plan`, as text for people and as one JSON object (docs/cli.md documents every key).
#pragma once
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "tools/corridor.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {

struct WeighedFormula {
  ltl::Formula formula;
  double probability = 0;
};

struct Answer {
  std::optional<std::string> id = {}, instruction = {};
  std::optional<std::string> understood = {};  // in English, from the formula
  std::optional<ltl::Formula> formula = {};
  std::vector<WeighedFormula> readings = {};  // best first; of an instruction only
  CorridorRun corridor_run;
  std::optional<JsonArray> alternatives = {};  // readings of another meaning
};

JsonObject json_of(const Answer& answer, const plan::Map& map);
void print(std::ostream& out, const Terminal& terminal, const Answer& answer, const plan::Map& map);
std::string milliseconds(double seconds);  // "1.25 ms"

JsonObject json_of(const AutomatonSize& size);
JsonArray json_of(const plan::Trajectory& trajectory, const plan::Map& map);  // [[x,y,heading],…]
// One line an action, numbered from `first` on.
void print_steps(std::ostream& out, const plan::Trajectory& trajectory, const plan::Map& map, std::size_t first = 1);
// "start at (1,9) facing north"
void print_start(std::ostream& out, const Terminal& terminal, plan::PoseId start, const plan::Map& map);
std::string counted(std::size_t count, const std::string& noun);  // "1 state", "3 states"
// In Unicode where the terminal can show it.
std::string shown(ltl::Formula formula, const Terminal& terminal);
std::string heading_name(int heading);  // "north"

}  // namespace waymark::tools
