#include "tools/render/pictograms.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace waymark::render {
namespace {

struct Drawing {
  std::string_view name;
  std::string_view svg;
};

// In a 24 × 24 square; fill and stroke are inherited (dark, stroke width 2, round).
constexpr std::array objects{
    Drawing{"barstool", R"(<ellipse cx="12" cy="4.5" rx="7" ry="2.5"/>)"
                        R"(<path fill="none" d="M8 7 L5 22 M16 7 L19 22 M12 7 V22 M6.4 15.5 H17.6"/>)"},
    Drawing{"chair", R"(<path fill="none" d="M6 2 V22 M18 13 V22"/><path d="M6 12 H18 V14.5 H6 Z"/>)"
                     R"(<path fill="none" d="M6 3 H9 V11"/>)"},
    Drawing{"easel", R"(<path fill="none" d="M12 1 V4 M8 16 L4.5 23 M16 16 L19.5 23 M12 16 V20"/>)"
                     R"(<path fill="#fff" d="M4.5 4 H19.5 V16 H4.5 Z"/>)"
                     R"(<path stroke-width="1.4" d="M7 13.5 L10.5 8.5 L13 11.5 L14.5 10 L17 13.5 Z"/>)"},
    Drawing{"hatrack",
            R"(<path fill="none" d="M12 2 V22 M6.5 22.5 L12 18.5 L17.5 22.5 M12 9 Q6 9 5 4 M12 9 Q18 9 19 4 M12 13 )"
            R"(Q8 13 7 10.5 M12 13 Q16 13 17 10.5"/>)"
            R"(<circle cx="12" cy="2.4" r="1.3"/>)"},
    Drawing{"lamp", R"(<path d="M8 2 H16 L19.5 11 H4.5 Z"/><path fill="none" d="M12 11 V21"/>)"
                    R"(<path d="M7.5 20.5 H16.5 V22.5 H7.5 Z"/>)"},
    Drawing{"sofa",
            R"(<path d="M4.5 12 V7.5 Q4.5 5.5 6.5 5.5 H17.5 Q19.5 5.5 19.5 7.5 V12" fill="none"/>)"
            R"(<path d="M2 11 Q2 9.5 3.5 9.5 Q5 9.5 5 11 V14 H19 V11 Q19 9.5 20.5 9.5 Q22 9.5 22 11 V18.5 H2 Z"/>)"
            R"(<path fill="none" d="M4.5 19 V21 M19.5 19 V21"/>)"},
};

// In a 20 × 16 frame.
constexpr std::array paintings{
    Drawing{
        "butterfly",
        R"(<g fill="#7b3fa0"><path d="M10 8 Q4 0 2.6 5 Q2.4 8 10 8.6 Z"/>)"
        R"(<path d="M10 8 Q16 0 17.4 5 Q17.6 8 10 8.6 Z"/>)"
        R"(<path d="M10 8.4 Q4 9 5 12.4 Q7.5 14.6 10 8.4 Z"/><path d="M10 8.4 Q16 9 15 12.4 Q12.5 14.6 10 8.4 Z"/></g>)"
        R"(<path d="M10 4.5 V13" stroke="#222" stroke-width="1.1" stroke-linecap="round"/>)"},
    Drawing{"fish", R"(<path d="M2.6 8 Q7.5 2.4 13 7.2 L17.2 4 V12 L13 8.8 Q7.5 13.6 2.6 8 Z" fill="#c2570c"/>)"
                    R"(<circle cx="6" cy="7.2" r="0.9" fill="#fff"/>)"},
    Drawing{"tower",
            R"(<path d="M10 1.6 L11 6.5 H9 Z M8.6 6.5 H11.4 L12.6 10 H7.4 Z M7 10 H13 L15.2 14.4 H12.7 Q10 10.4 7.3 )"
            R"(14.4 H4.8 Z" fill="#33475b"/>)"},
};

template <std::size_t N>
const Drawing* find(const std::array<Drawing, N>& drawings, std::string_view name) {
  const auto found = std::find_if(drawings.begin(), drawings.end(), [&](const Drawing& d) { return d.name == name; });
  return found == drawings.end() ? nullptr : &*found;
}

// Whole characters only: a name may be in any script.
std::string first_letters(std::string_view name, std::size_t count) {
  std::size_t end = 0;
  while (end < name.size() && count > 0) {
    ++end;
    while (end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) ++end;
    --count;
  }
  return std::string(name.substr(0, end));
}

struct WrittenOut {
  double size;  // of the letters
  std::vector<std::string> lines;
};

// The largest letters that fit; nullopt when the smallest do not.
std::optional<WrittenOut> written_out(std::string_view name) {
  constexpr double widest = 60;
  for (const double size : {12.0, 11.0, 10.0, 9.0}) {
    std::vector<std::string> lines = wrapped(name, widest / size);
    const bool fits = std::all_of(lines.begin(), lines.end(),
                                  [&](const std::string& line) { return text_width(line) * size <= widest; });
    if (fits && lines.size() <= 3) return WrittenOut{size, std::move(lines)};
  }
  return std::nullopt;
}

}  // namespace

bool has_drawing(std::string_view object) { return find(objects, object) != nullptr; }

bool is_written_out(std::string_view object) { return !has_drawing(object) && written_out(object).has_value(); }

void draw_object(Svg& svg, std::string_view object, Point centre, double size) {
  if (const auto name = has_drawing(object) ? std::nullopt : written_out(object)) {
    double y = centre.y - name->size * (static_cast<double>(name->lines.size()) / 2 - 0.85) * 1.05;
    for (const std::string& line : name->lines) {
      svg.text({centre.x, y}, name->size, line,
               R"(text-anchor="middle" font-weight="bold" fill="#20242b" stroke="#fbfaf7" stroke-width="3" )"
               R"(paint-order="stroke")");
      y += name->size * 1.05;
    }
    return;
  }
  svg.open("g", translated({centre.x - size / 2, centre.y - size / 2}, size / 24) +
                    " fill=\"#20242b\" stroke=\"#20242b\" stroke-width=\"2\" stroke-linecap=\"round\" "
                    "stroke-linejoin=\"round\"");
  if (const Drawing* drawing = find(objects, object))
    svg.raw(drawing->svg);
  else
    svg.text({12, 17}, 15, first_letters(object, 2), "text-anchor=\"middle\" stroke=\"none\" font-weight=\"bold\"");
  svg.close("g");
}

void draw_painting(Svg& svg, std::string_view painting, Point centre, double height) {
  const double scale = height / 16;
  svg.open("g", translated({centre.x - 10 * scale, centre.y - 8 * scale}, scale));
  svg.rectangle({0.5, 0.5}, 19, 15, R"(fill="#fffdf6" stroke="#6b4a1c" stroke-width="1.5")");
  if (const Drawing* drawing = find(paintings, painting))
    svg.raw(drawing->svg);
  else
    svg.text({10, 12}, 11, first_letters(painting, 2), R"(text-anchor="middle" fill="#222")");
  svg.close("g");
}

}  // namespace waymark::render
