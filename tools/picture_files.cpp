#include "tools/picture_files.hpp"

#include <array>
#include <charconv>
#include <stdexcept>
#include <vector>

#include "tools/shell/data_directory.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

std::filesystem::path converter() {
  return needed_helper("waymark-convert", "makes PNG and PDF (it needs librsvg2-dev)");
}

std::string converted(const std::string& svg, const std::vector<std::string>& arguments) {
  Finished finished = run_helper(converter(), arguments, svg);
  constexpr int too_large = 21;
  if (finished.exit_code == too_large)
    throw UsageError("the picture is too large for PNG; a smaller --scale, or --pdf");
  if (finished.exit_code != 0)
    throw std::runtime_error("waymark-convert ended with exit code " + std::to_string(finished.exit_code));
  return std::move(finished.output);
}

std::string shortest(double value) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

void add_picture_options(Command command, PictureFiles& files) {
  command.add_option("--svg", files.svg, "the picture as SVG; - is standard output").type_name("FILE");
  command.add_option("--png", files.png, "the picture as PNG").type_name("FILE");
  command.add_option("--pdf", files.pdf, "the picture as PDF, one page of its size").type_name("FILE");
  command.add_option("--scale", files.scale, "with --png: pixels for each 1/96 inch of the picture")
      .type_name("X")
      .between(0.1, 20.0)
      .show_default();
}

void check_picture_files(const PictureFiles& files) {
  if (!files.given()) throw UsageError("give a file for the picture: --svg, --png or --pdf");
  if (!files.png.empty() || !files.pdf.empty()) (void)converter();
}

void write_picture(const std::string& svg, const PictureFiles& files) {
  if (!files.svg.empty()) write_file(files.svg, svg);
  if (!files.png.empty()) write_file(files.png, converted(svg, {"png", shortest(files.scale)}));
  if (!files.pdf.empty()) write_file(files.pdf, converted(svg, {"pdf"}));
}

}  // namespace waymark::tools
