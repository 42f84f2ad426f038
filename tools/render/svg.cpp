#include "tools/render/svg.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace waymark::render {
namespace {

// Advance widths of DejaVu Sans for U+0020 … U+007E, in thousandths of the font size.
constexpr std::array<std::uint16_t, 95> advance{
    317, 400, 459, 837, 636, 950, 779, 274, 390, 390, 500, 837, 317, 360,  317, 336, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 336, 336, 837, 837, 837, 530, 1000, 684, 686, 698, 770, 631,
    575, 774, 751, 294, 294, 655, 557, 862, 748, 787, 603, 787, 694, 634,  610, 731, 684, 988, 685,
    610, 685, 390, 336, 390, 837, 500, 500, 612, 634, 549, 634, 615, 352,  634, 633, 277, 277, 579,
    277, 974, 633, 611, 634, 634, 411, 520, 392, 633, 591, 817, 591, 591,  524, 636, 336, 636, 837};
constexpr double other_advance = 0.9;  // operators and arrows: 0.73 … 0.94

}  // namespace

std::string number(double value) {
  std::array<char, 400> buffer{};
  const double rounded = std::round(value * 100) / 100 + 0.0;  // + 0.0 turns −0 into 0
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded, std::chars_format::fixed, 2).ptr;
  std::string text(buffer.data(), end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

double text_width(std::string_view text) {
  double width = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F)
      width += advance[byte - 0x20U] / 1000.0;
    else if ((byte & 0xC0U) != 0x80U)  // the first byte of a character
      width += other_advance;
  }
  return width;
}

std::vector<std::string> wrapped(std::string_view text, double width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const auto space = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, space));
    text.remove_prefix(std::min(space + 1, text.size()));
    if (!line.empty() && text_width(line + ' ' + word) > width) {
      lines.push_back(std::move(line));
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

std::string at(Point p) { return number(p.x) + ' ' + number(p.y); }

std::string translated(Point to, double scale) {
  std::string out = "transform=\"translate(" + number(to.x) + ',' + number(to.y) + ')';
  if (scale != 1) out += " scale(" + std::to_string(scale) + ')';
  return out + '"';
}

void Svg::open(std::string_view element, std::string_view attributes) {
  out_ += '<' + std::string(element) + (attributes.empty() ? "" : " ") + std::string(attributes) + ">\n";
}

void Svg::open_picture(double width, double height) {
  const std::string size = number(width) + ' ' + number(height);
  open("svg", R"(xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width=")" +
                  number(width) + R"(" height=")" + number(height) + R"(" viewBox="0 0 )" + size +
                  R"(" font-family=")" + std::string(font_family) + '"');
  rectangle({0, 0}, width, height, R"(fill="#fff")");
}

void Svg::close(std::string_view element) { out_ += "</" + std::string(element) + ">\n"; }

void Svg::line(Point from, Point to, std::string_view attributes) {
  out_ += "<line x1=\"" + number(from.x) + "\" y1=\"" + number(from.y) + "\" x2=\"" + number(to.x) + "\" y2=\"" +
          number(to.y) + "\" " + std::string(attributes) + "/>\n";
}

void Svg::rectangle(Point corner, double width, double height, std::string_view attributes) {
  out_ += "<rect x=\"" + number(corner.x) + "\" y=\"" + number(corner.y) + "\" width=\"" + number(width) +
          "\" height=\"" + number(height) + "\" " + std::string(attributes) + "/>\n";
}

void Svg::circle(Point centre, double radius, std::string_view attributes) {
  out_ += "<circle cx=\"" + number(centre.x) + "\" cy=\"" + number(centre.y) + "\" r=\"" + number(radius) + "\" " +
          std::string(attributes) + "/>\n";
}

void Svg::path(std::string_view d, std::string_view attributes) {
  out_ += "<path d=\"" + std::string(d) + "\" " + std::string(attributes) + "/>\n";
}

void Svg::text(Point where, double size, std::string_view text, std::string_view attributes) {
  out_ += "<text x=\"" + number(where.x) + "\" y=\"" + number(where.y) + "\" font-size=\"" + number(size) + "\" " +
          std::string(attributes) + '>' + escaped(text) + "</text>\n";
}

}  // namespace waymark::render
