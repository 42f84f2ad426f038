// waymark-convert: SVG on standard input, drawn by librsvg and cairo, PNG or PDF on standard output.
//
// A helper that waymark starts when a picture is to be PNG or PDF. Arguments: `png` and the number of pixels for each
// unit of the picture, or `pdf`, whose page is as large as the picture, a unit of which is 1/96 inch.
#include <cairo-pdf.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>

#include "tools/shell/with_parent.hpp"

namespace {

constexpr int usage = 20, bad_input = 21, our_bug = 30;  // docs/cli.md
constexpr double points_per_unit = 72.0 / 96.0;
constexpr double most_pixels = 32'000;  // a side; cairo's images have sides up to 32,767

int fail(int code, const std::string& message) {
  std::cerr << "error: waymark-convert: " << message << '\n';
  return code;
}

cairo_status_t print(void*, const unsigned char* data, unsigned length) {
  std::cout.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(length));
  return std::cout ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

struct Unreference {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
template <class T>
using Owned = std::unique_ptr<T, Unreference>;

struct Size {
  double width = 0, height = 0;
};

// The whole picture, `scale` units of the surface for each unit of the picture.
std::string draw(RsvgHandle* picture, cairo_surface_t* surface, Size size, double scale) {
  const Owned<cairo_t> context(cairo_create(surface));
  const RsvgRectangle page{0, 0, size.width * scale, size.height * scale};
  GError* error = nullptr;
  if (rsvg_handle_render_document(picture, context.get(), &page, &error) != 0) return "";
  std::string message = error->message;
  g_error_free(error);
  return message;
}

int write_png(RsvgHandle* picture, Size size, double scale) {
  if (size.width * scale > most_pixels || size.height * scale > most_pixels)
    return fail(bad_input, "the picture would have more than 32,000 pixels a side; a smaller --scale, SVG or PDF");
  const Owned<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32,
                                                                  static_cast<int>(std::ceil(size.width * scale)),
                                                                  static_cast<int>(std::ceil(size.height * scale))));
  const std::string problem = draw(picture, surface.get(), size, scale);
  if (!problem.empty()) return fail(our_bug, problem);
  if (cairo_surface_write_to_png_stream(surface.get(), print, nullptr) != CAIRO_STATUS_SUCCESS)
    return fail(bad_input, "standard output cannot be written");
  return 0;
}

int write_pdf(RsvgHandle* picture, Size size) {
  const Owned<cairo_surface_t> surface(
      cairo_pdf_surface_create_for_stream(print, nullptr, size.width * points_per_unit, size.height * points_per_unit));
  const std::string problem = draw(picture, surface.get(), size, points_per_unit);
  if (!problem.empty()) return fail(our_bug, problem);
  cairo_surface_finish(surface.get());
  return cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS
             ? 0
             : fail(bad_input, "standard output cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  waymark::tools::end_with_parent();
  const std::string_view format = argc > 1 ? argv[1] : "";
  const double scale = argc > 2 ? std::stod(argv[2]) : 1;
  if ((format != "png" && format != "pdf") || !(scale > 0))
    return fail(usage, "png SCALE or pdf, with a scale above 0");
  const std::string svg{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  GError* error = nullptr;
  const Owned<RsvgHandle> picture(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  if (!picture) {
    const std::string message = error->message;
    g_error_free(error);
    return fail(bad_input, "standard input is not SVG: " + message);
  }
  Size size;
  if (rsvg_handle_get_intrinsic_size_in_pixels(picture.get(), &size.width, &size.height) == 0)
    return fail(bad_input, "the picture has no size");
  const int code = format == "png" ? write_png(picture.get(), size, scale) : write_pdf(picture.get(), size);
  return std::cout.flush() ? code : fail(bad_input, "standard output cannot be written");
}
