// A table as a picture: a heading, a rule, and rows; columns of numbers stand at the right.
#pragma once
#include <string>
#include <vector>

namespace waymark::render {

struct Table {
  std::string title;                           // empty: none
  std::vector<std::string> columns;            // their headings
  std::vector<std::vector<std::string>> rows;  // each as many cells as there are columns
};

// A complete SVG document.
std::string draw_table(const Table& table);

}  // namespace waymark::render
