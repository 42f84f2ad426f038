// Costs that grow: panels side by side, both axes logarithmic, one line for each way of doing the same thing.
#pragma once
#include <string>
#include <vector>

namespace waymark::render {

struct CostPanel {
  std::string over;                        // what grows
  std::vector<double> sizes;               // positive, ascending
  std::vector<std::vector<double>> costs;  // by line, one for each size, positive
};

struct CostPlot {
  std::string title, caption, unit;
  std::vector<std::string> lines;
  std::vector<CostPanel> panels;
};

// A complete SVG document. At most eight lines.
std::string draw_costs(const CostPlot& plot);

}  // namespace waymark::render
