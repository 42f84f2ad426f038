// Learning curves: environment steps against the score of the policy, one line for each method with its 95 % band.
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
};

// A complete SVG document.
std::string draw_curves(const CurvePlot& plot);

}  // namespace waymark::render
