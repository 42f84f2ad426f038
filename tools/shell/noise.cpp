#include "tools/shell/noise.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <vector>

#include "tools/shell/exit_code.hpp"

namespace waymark::tools {
namespace {

struct Shape {  // of an option: its name, what it takes, how many chances
  std::string option, syntax, leaves;
  std::size_t least, most;
};

// "0.1,0.1": chances, as many as there are at most, those that are left out 0.
std::vector<double> chances(const std::string& text, const Shape& shape) {
  std::vector<double> out;
  std::istringstream in(text);
  for (std::string part; out.size() < shape.most && std::getline(in, part, ',');) {
    std::istringstream number(part);
    if (!(number >> out.emplace_back()) || !number.eof()) throw UsageError(shape.option + " takes " + shape.syntax);
  }
  const double sum = std::accumulate(out.begin(), out.end(), 0.0);
  if (out.size() < shape.least || !in.eof() || !(sum < 1) || *std::min_element(out.begin(), out.end()) < 0)
    throw UsageError(shape.option + " takes " + shape.leaves);
  out.resize(shape.most);
  return out;
}

}  // namespace

void add_noise_options(Command command, NoiseOptions& options) {
  command = command.in("Other models than a map, and what may fail");
  command.add_option("--slip", options.forward, "chances that FORWARD goes left, right, back instead")
      .type_name("L,R[,B]");
  command
      .add_option("--slip-turn", options.turn,
                  "chances that a turn comes to nothing, and that it goes on to the opposite heading")
      .type_name("S[,O]");
}

plan::MapNoise noise_of(const NoiseOptions& options) {
  plan::MapNoise noise;
  if (!options.forward.empty()) {
    const auto c = chances(options.forward, {"--slip", "LEFT,RIGHT or LEFT,RIGHT,BACK",
                                             "two or three chances that leave something for going forward", 2, 3});
    noise.forward = {.forward = 1 - c[0] - c[1] - c[2], .left = c[0], .right = c[1], .back = c[2]};
  }
  if (!options.turn.empty()) {
    const auto c = chances(options.turn, {"--slip-turn", "STAY or STAY,OPPOSITE",
                                          "one or two chances that leave something for turning", 1, 2});
    noise.turn = {.stay = c[0], .beyond = c[1]};
  }
  return noise;
}

}  // namespace waymark::tools
