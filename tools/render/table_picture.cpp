#include "tools/render/table_picture.hpp"

#include <algorithm>
#include <numeric>

#include "tools/render/svg.hpp"

namespace waymark::render {
namespace {

constexpr double size = 13, line = 22, margin = 16, gap = 22;

bool is_number(std::string_view cell) {
  return cell.empty() || cell.find_first_not_of("0123456789.,+-eE%± []") == std::string_view::npos || cell == "inf";
}

}  // namespace

std::string draw_table(const Table& table) {
  const std::size_t columns = table.columns.size();
  std::vector<double> widths(columns);
  std::vector<bool> right(columns, !table.rows.empty());
  const auto measure = [&](std::size_t c, std::string_view cell, double factor) {
    widths[c] = std::max(widths[c], factor * size * text_width(cell));
  };
  for (std::size_t c = 0; c < columns; ++c) measure(c, table.columns[c], 1.08);  // bold
  for (const auto& row : table.rows)
    for (std::size_t c = 0; c < columns; ++c) {
      measure(c, row[c], 1);
      right[c] = right[c] && is_number(row[c]);
    }
  const double inner = std::max(std::accumulate(widths.begin(), widths.end(), gap * static_cast<double>(columns) - gap),
                                1.08 * (size + 2) * text_width(table.title));
  const double top = table.title.empty() ? margin : margin + 30;
  const double height = top + line * static_cast<double>(table.rows.size() + 1) + margin + 6;
  Svg svg;
  svg.open_picture(inner + 2 * margin, height);
  if (!table.title.empty()) svg.text({margin, margin + 12}, size + 2, table.title, R"(fill="#1c3f7c")");
  const auto write = [&](double y, const std::vector<std::string>& cells, std::string_view style) {
    double x = margin;
    for (std::size_t c = 0; c < columns; ++c) {
      svg.text({right[c] ? x + widths[c] : x, y}, size, cells[c],
               (right[c] ? R"(text-anchor="end" )" : "") + std::string(style));
      x += widths[c] + gap;
    }
  };
  write(top + 15, table.columns, R"(font-weight="bold" fill="#20242b")");
  svg.line({margin, top + line}, {margin + inner, top + line}, R"(stroke="#20242b" stroke-width="1")");
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    write(top + 17 + line * static_cast<double>(r + 1), table.rows[r], R"(fill="#20242b")");
  svg.close("svg");
  return svg.str();
}

}  // namespace waymark::render
