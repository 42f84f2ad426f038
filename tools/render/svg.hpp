// SVG text: numbers without noise, escaped strings, and how wide a string will be.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace waymark::render {

struct Point {
  double x = 0, y = 0;
};

std::string number(double value);            // at most two decimals, no trailing zeros, never "-0"
std::string escaped(std::string_view text);  // & < > " and control characters

// Width in units of the font size, with the glyph widths of DejaVu Sans, the widest of the fonts we name: text that
// fits by this measure fits in all of them.
double text_width(std::string_view text);
// Broken at spaces into lines no wider than `width` (in font sizes); a longer word stands alone.
std::vector<std::string> wrapped(std::string_view text, double width);

inline constexpr std::string_view font_family = "Helvetica, Arial, 'DejaVu Sans', sans-serif";

// A growing document. Attributes are given as text, ready to paste: `fill="#fff" stroke="none"`.
class Svg {
 public:
  void open_picture(double width, double height);  // the element svg, white ground and links included
  void open(std::string_view element, std::string_view attributes = "");
  void close(std::string_view element);
  void line(Point from, Point to, std::string_view attributes);
  void rectangle(Point corner, double width, double height, std::string_view attributes);
  void circle(Point centre, double radius, std::string_view attributes);
  void path(std::string_view d, std::string_view attributes);
  void text(Point at, double size, std::string_view text, std::string_view attributes = "");
  void raw(std::string_view svg) { out_ += svg; }
  const std::string& str() const { return out_; }

 private:
  std::string out_;
};

std::string translated(Point to, double scale = 1);  // `transform="translate(…) scale(…)"`
std::string at(Point p);                             // "x y", for path data

}  // namespace waymark::render
