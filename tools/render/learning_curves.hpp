// Learning curves: environment steps against the score of the policy, one line for each learner with its 95 % band.
// Curves that cover one another are told apart by their marks, which stand at steps of their own. What is exact is a
// dashed line at 1.
#pragma once
#include <string>
#include <vector>

namespace waymark::render {

struct Curve {
  struct Point {
    double steps = 0, value = 0, low = 0, high = 0;  // values in [0, 1]
  };
  std::string name;
  std::vector<Point> points;  // by steps
};

struct CurvePlot {
  std::string title;    // the formula
  std::string caption;  // one line of facts
  std::vector<Curve> curves;
  std::vector<std::string> exact = {};  // names of exact methods: always an optimal route
};

// A complete SVG document.
std::string draw_curves(const CurvePlot& plot);

}  // namespace waymark::render
